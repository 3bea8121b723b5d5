// SPDX-License-Identifier: Apache-2.0
// The greatest |cos(angle)| x + |sin(angle)| y between two angles in degrees, for x and y above 0.
float widest(float x, float y, vec2 rotation) {
  vec2 angle = radians(rotation);
  // It is greatest at the diagonal's angle, and again at every half turn from there.
  float peak = atan(y, x);
  vec2 from = (angle.x - vec2(peak, -peak)) * 0.31830988618;
  vec2 to = (angle.y - vec2(peak, -peak)) * 0.31830988618;
  bool meets_peak = floor(to.x) >= ceil(from.x) || floor(to.y) >= ceil(from.y);
  vec2 ends = abs(cos(angle)) * x + abs(sin(angle)) * y;
  return meets_peak ? length(vec2(x, y)) : max(ends.x, ends.y);
}

/// How many tiles around its own the elements of a layer can reach, whatever is drawn at random.
/// `layer` computes it when the shader is made and looks at no more tiles than these; 0 for tiles
/// of a grid that cannot show its neighbours, and for images that cover their tile and are cut
/// there.
/// @param tile the layer's tile
/// @param position_min as of the layer @default vec2(0.5)
/// @param position_max as of the layer @default vec2(0.5)
/// @param scale as of the layer @default vec2(1)
/// @param stretch as of the layer @default vec2(1)
/// @param rotation as of the layer @default vec2(0) @unit degrees
/// @param fit as of the layer @default FIT_STRETCH
int layer_neighbours(Tile tile, vec2 position_min, vec2 position_max, vec2 scale, vec2 stretch,
                     vec2 rotation, const int fit) {
  vec2 away = max(abs(position_min - 0.5), abs(position_max - 0.5));
  vec2 most = 0.5 * scale.y * vec2(1.0, stretch.y);
  // In its own tile, whatever that is like: what stays inside needs no neighbours.
  vec2 least = max(tile.smallest, vec2(1e-20));
  vec2 part = vec2(widest(most.x, most.y * tile.largest.y / least.x, rotation),
                   widest(most.y, most.x * tile.largest.x / least.y, rotation));
  vec2 inside = away + part;
  bool stays = tile.smallest.x > 0.0 && max(inside.x, inside.y) < 0.5001;
  vec2 frame = tile.largest;
  if (fit == FIT_CONTAIN) {
    frame = vec2(min(frame.x, frame.y));
  }
  vec2 box = most * frame;
  box = vec2(widest(box.x, box.y, rotation), widest(box.y, box.x, rotation));
  vec2 from_middle = away * tile.largest + box;
  vec2 from_tile = tile.drift + tile.tilt.x * from_middle + tile.tilt.y * from_middle.yx;
  vec2 reach = from_tile / max(tile.pitch, vec2(1e-20)) - 0.5;
  // What only touches its neighbour, but for rounding, does not reach it.
  int neighbours = max(int(ceil(max(reach.x, reach.y) - 0.0001)), 0);
  return stays || fit == FIT_COVER || tile.pitch.x <= 0.0 ? 0 : neighbours;
}
