// SPDX-License-Identifier: Apache-2.0
/// Four random directions in space at once, evenly spread over the octahedron |x| + |y| + |z| = 1.
/// Their mean is 0, that of each component's square is 1/6, and that of the product of two is 0.
/// @source the unfolding of the octahedron: Meyer et al., On Floating-Point Normal Vectors,
///   Computer Graphics Forum 29(4), 2010, section 3.3
/// @param bits random bits for each direction, as of `hash`
/// @param x the x of each
/// @param y the y of each
/// @param z the z of each
void directions3(uvec4 bits, out vec4 x, out vec4 y, out vec4 z) {
  x = vec4(ivec4(bits)) * 4.656612873077393e-10;
  y = vec4(ivec4(bits << 16u)) * 4.656612873077393e-10;
  z = 1.0 - abs(x) - abs(y);
  // What lies outside of the upper half's square is folded under it.
  vec4 under = max(-z, 0.0);
  x -= sign(x) * under;
  y -= sign(y) * under;
}
