// SPDX-License-Identifier: Apache-2.0
/// The components of a vector, as numbers.
/// @param vector the vector
/// @param x first component
/// @param y second component
void components(vec2 vector, out float x, out float y) {
  x = vector.x;
  y = vector.y;
}

/// @param z third component
void components(vec3 vector, out float x, out float y, out float z) {
  x = vector.x;
  y = vector.y;
  z = vector.z;
}

/// @param w fourth component
void components(vec4 vector, out float x, out float y, out float z, out float w) {
  x = vector.x;
  y = vector.y;
  z = vector.z;
  w = vector.w;
}
