// SPDX-License-Identifier: Apache-2.0
/// Goes from one value to another in a straight line: `a` where the amount is 0, `b` where it is 1.
/// GLSL's mix.
/// For colours that have opacity, see `blend`.
/// @param a value at 0
/// @param b value at 1
/// @param amount how far to go; it is not limited to 0 to 1 @default 0.5 @range 0 1
genType lerp(genType a, genType b, float amount) { return mix(a, b, amount); }
