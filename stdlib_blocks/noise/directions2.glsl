// SPDX-License-Identifier: Apache-2.0
/// Four random directions in the plane at once, evenly spread over the square |x| + |y| = 1.
/// Their mean is 0, that of x x and of y y is 1/3, and that of x y is 0. They cost no root, no sine
/// and no table, and there are as many as floats, so that noise made of them shows no few
/// directions.
/// @param bits random bits for each direction, as of `hash`
/// @param x the x of each
/// @param y the y of each
void directions2(uvec4 bits, out vec4 x, out vec4 y) {
  x = vec4(ivec4(bits)) * 4.656612873077393e-10;
  // The lowest bit, which no float of this size still has, is the sign.
  y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (bits << 31u));
}
