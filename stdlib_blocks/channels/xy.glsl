// SPDX-License-Identifier: Apache-2.0
/// The first two components of a vector.
/// @param vector the vector
vec2 xy(vec3 vector) { return vector.xy; }
vec2 xy(vec4 vector) { return vector.xy; }
