// SPDX-License-Identifier: Apache-2.0
/// Four random directions of four dimensions at once: one component is 0, each of the others 1 or
/// -1, which are the 32 middles of a hypercube's edges.
/// Their mean is 0, that of each component's square is 3/4, and that of the product of two is 0.
/// @source Perlin, Improving Noise, SIGGRAPH 2002, which has the edges of the cube
/// @param bits random bits for each direction, as of `hash`
/// @param x the first component of each
/// @param y the second of each
/// @param z the third of each
/// @param w the fourth of each
void directions4(uvec4 bits, out vec4 x, out vec4 y, out vec4 z, out vec4 w) {
  // 1.0 with a sign from a bit of its own; the upper two bits say which is 0.
  const uint SIGN = 0x80000000u;
  const uint ONE = 0x3f800000u;
  uvec4 none = bits >> 30u;
  x = uintBitsToFloat(((bits << 2u) & SIGN) | ONE) * vec4(notEqual(none, uvec4(0u)));
  y = uintBitsToFloat(((bits << 3u) & SIGN) | ONE) * vec4(notEqual(none, uvec4(1u)));
  z = uintBitsToFloat(((bits << 4u) & SIGN) | ONE) * vec4(notEqual(none, uvec4(2u)));
  w = uintBitsToFloat(((bits << 5u) & SIGN) | ONE) * vec4(notEqual(none, uvec4(3u)));
}
