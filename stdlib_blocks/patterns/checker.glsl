// SPDX-License-Identifier: Apache-2.0
/// Two values in turn, like the squares of a chessboard; the square at the origin has the first.
/// Filtered analytically: the exact mean over a box as large as the pixel's footprint, so that it
/// neither has jagged edges nor shimmers, and far away is the mean of the two. The integral of the
/// square wave is a triangle wave.
/// @source Peachey, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 2, "Analytic
///   prefiltering"; the product of two waves: Quilez, Filtering the checkerboard pattern
/// @param uv coordinate @default uv
/// @param scale squares for each unit of the coordinate, across and up @default vec2(8)
/// @param a value of the first squares @default 0
/// @param b value of the others @default 1
genType checker(vec2 uv, vec2 scale, genType a, genType b) {
  // In pairs of squares, the wave's period.
  vec2 p = uv * (0.5 * scale);
  vec2 width = max(footprint(uv) * abs(0.5 * scale), 5e-5);
  vec2 near = abs(fract(p - 0.5 * width) - 0.5);
  vec2 far = abs(fract(p + 0.5 * width) - 0.5);
  vec2 wave = (near - far) / width;
  return mix(a, b, 0.5 - 0.5 * wave.x * wave.y);
}
