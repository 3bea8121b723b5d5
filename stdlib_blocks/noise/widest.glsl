// SPDX-License-Identifier: Apache-2.0
/// The greatest component of a vector: of a footprint, how many cells a pixel covers where it
/// covers most.
/// @param value the vector, or a number, which is its own
float widest(vec2 value) { return max(value.x, value.y); }
float widest(float value) { return value; }
float widest(vec3 value) { return max(max(value.x, value.y), value.z); }
float widest(vec4 value) { return max(max(value.x, value.y), max(value.z, value.w)); }
