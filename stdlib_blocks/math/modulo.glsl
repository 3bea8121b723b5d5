// SPDX-License-Identifier: Apache-2.0
/// What a division leaves over, from 0 up to but not including the divisor, also below zero: `a - b
/// * floor(a / b)`.
/// A divisor of 0 gives 0.
/// @param a what is divided
/// @param b the divisor @default 1
float modulo(float a, float b) { return b == 0.0 ? 0.0 : mod(a, b); }
vec2 modulo(vec2 a, vec2 b) { return mix(mod(a, b), vec2(0.0), equal(b, vec2(0.0))); }
vec3 modulo(vec3 a, vec3 b) { return mix(mod(a, b), vec3(0.0), equal(b, vec3(0.0))); }
vec4 modulo(vec4 a, vec4 b) { return mix(mod(a, b), vec4(0.0), equal(b, vec4(0.0))); }
