// SPDX-License-Identifier: Apache-2.0
/// Divides the first value by the second, component by component. Division by 0 gives 0.
/// @param a what is divided
/// @param b the divisor @default 1
float divide(float a, float b) { return b == 0.0 ? 0.0 : a / b; }
vec2 divide(vec2 a, vec2 b) { return mix(a / b, vec2(0.0), equal(b, vec2(0.0))); }
vec3 divide(vec3 a, vec3 b) { return mix(a / b, vec3(0.0), equal(b, vec3(0.0))); }
vec4 divide(vec4 a, vec4 b) { return mix(a / b, vec4(0.0), equal(b, vec4(0.0))); }
