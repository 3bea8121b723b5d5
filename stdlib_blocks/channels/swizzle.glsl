// SPDX-License-Identifier: Apache-2.0
const int X_X = 0;
const int X_Y = 1;
const int X_Z = 2;
const int X_W = 3;
const int X_ZERO = 4;
const int X_ONE = 5;
const int Y_X = 0;
const int Y_Y = 1;
const int Y_Z = 2;
const int Y_W = 3;
const int Y_ZERO = 4;
const int Y_ONE = 5;
const int Z_X = 0;
const int Z_Y = 1;
const int Z_Z = 2;
const int Z_W = 3;
const int Z_ZERO = 4;
const int Z_ONE = 5;
const int W_X = 0;
const int W_Y = 1;
const int W_Z = 2;
const int W_W = 3;
const int W_ZERO = 4;
const int W_ONE = 5;

float chosen(vec4 vector, const int which) {
  return which == X_X   ? vector.x
         : which == X_Y ? vector.y
         : which == X_Z ? vector.z
         : which == X_W ? vector.w
                        : float(which - X_ZERO);
}

/// Takes the components of a vector, or the channels of a colour, in another order.
/// Each component of the result is one of the vector's, x, y, z or w, or zero, or one. Of a vector
/// with fewer, those that are missing are 0.
/// @source MaterialX 1.38, Standard Nodes, swizzle
/// @param vector the vector
/// @param x what comes first, red @default X_X
/// @param y what comes second, green @default Y_Y
vec2 swizzle(vec2 vector, const int x, const int y) {
  vec4 all_four = vec4(vector, 0.0, 0.0);
  return vec2(chosen(all_four, x), chosen(all_four, y));
}

/// @param vector the vector
/// @param x what comes first, red @default X_X
/// @param y what comes second, green @default Y_Y
/// @param z what comes third, blue @default Z_Z
vec3 swizzle(vec3 vector, const int x, const int y, const int z) {
  vec4 all_four = vec4(vector, 0.0);
  return vec3(chosen(all_four, x), chosen(all_four, y), chosen(all_four, z));
}

/// @param vector the vector
/// @param x what comes first, red @default X_X
/// @param y what comes second, green @default Y_Y
/// @param z what comes third, blue @default Z_Z
/// @param w what comes last, alpha @default W_W
vec4 swizzle(vec4 vector, const int x, const int y, const int z, const int w) {
  return vec4(chosen(vector, x), chosen(vector, y), chosen(vector, z), chosen(vector, w));
}
