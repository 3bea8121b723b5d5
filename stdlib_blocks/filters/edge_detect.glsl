// SPDX-License-Identifier: Apache-2.0
/// Shows the edges of whatever is connected: how much it changes within a given width.
/// The difference of the means on both sides, across and up, as the root of the sum of their
/// squares: of an edge that is higher by 1 it is 1 on the edge, and has fallen to 0 at the width on
/// both sides. Where a pixel is larger than the width, the edges become fainter as they do in the
/// image.
/// @source Substance 3D Designer and Material Maker, "Edge Detect"; Gonzalez and Woods, Digital
///   Image Processing, section 10.2.5, the magnitude of the gradient
/// @param image whose edges
/// @param uv where to look @default uv
/// @param width how far on each side, across and up, in the units of uv; above 0
///   @default vec2(0.01)
/// @return from 0, nothing changes
genType image(vec2 uv);

float edge_detect(vec2 uv, vec2 width) {
  vec2 pixel = footprint(uv);
  vec2 side = max(sqrt(width * width + pixel * pixel), 1e-7);
  vec2 half_way = 0.5 * side;
  genType across = image(widen(uv + vec2(half_way.x, 0.0), vec2(side.x, pixel.y), uv)) -
                   image(widen(uv - vec2(half_way.x, 0.0), vec2(side.x, pixel.y), uv));
  genType along = image(widen(uv + vec2(0.0, half_way.y), vec2(pixel.x, side.y), uv)) -
                  image(widen(uv - vec2(0.0, half_way.y), vec2(pixel.x, side.y), uv));
  return sqrt(dot(across, across) + dot(along, along));
}
