// SPDX-License-Identifier: Apache-2.0
const int PLACE_INSIDE = 0;
const int PLACE_ANYWHERE = 1;

/// Moves, turns and scales what is drawn in a tile; in place of the fragments that the paper
/// discards it tells how much of the pixel is covered.
/// With the place `inside` the pattern stays in its tile, whatever its position: its middle is at
/// h + position (1 - 2 h), where h is half the box around the turned pattern; one that is too large
/// for the tile is made smaller. The paper has (uv + (1 - scale) position) / scale, with a wrong
/// sign: everything but position 0 is cut off; and it leaves out the rotation. With the place
/// `anywhere` the position is that of the middle; what reaches out of the tile is drawn by
/// `overlap`, in one pass in place of the paper's four.
/// Angles and shapes are kept in texture space: in a long tile a turned pattern does not shear.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Tile
///   Transform, and figures 4 and 5
/// @param tile the tile
/// @param position where the pattern is in its tile, from (0, 0), left below, to (1, 1)
///   @default vec2(0.5)
/// @param scale the size of the pattern, in tiles; at most 0 hides it @default 1
/// @param rotation how far it is turned, counter-clockwise @default 0 @unit degrees
/// @param place inside, the pattern stays in its tile; anywhere, its middle is at the position
///   @default PLACE_INSIDE
/// @param far the coverage where a pixel holds many tiles: the mean of all; below 0 it is what the
///   tile's own pattern takes of the tile, the mean if all are scaled alike @default -1 @range -1 1
/// @param inner the pattern's frame
/// @param coverage the share of the pixel that the pattern covers
void tile_transform(Tile tile, vec2 position, float scale, float rotation, const int place,
                    float far, out Tile inner, out float coverage) {
  float angle = radians(rotation);
  vec2 turn = vec2(cos(angle), sin(angle));
  // The box around the pattern at scale 1, in tiles.
  vec2 box = abs(turn.x) + abs(turn.y) * tile.size.yx / tile.size;
  float size = max(scale, 1e-5);
  vec2 middle = position;
  if (place == PLACE_INSIDE) {
    size = min(size, 1.0 / max(box.x, box.y));
    vec2 half_box = 0.5 * size * box;
    middle = half_box + clamp(position, 0.0, 1.0) * (1.0 - 2.0 * half_box);
  }
  vec2 p = (tile.local - middle) * tile.size;
  vec2 q = vec2(dot(turn, p), turn.x * p.y - turn.y * p.x) / (size * tile.size) + 0.5;

  inner.cell = tile.cell;
  inner.local = q;
  inner.size = size * tile.size;
  inner.seed = tile.seed;
  inner.right = turn.x * tile.right + turn.y * tile.up;
  inner.up = turn.x * tile.up - turn.y * tile.right;
  inner.pitch = vec2(0.0);
  inner.smallest = vec2(0.0);
  inner.largest = vec2(0.0);
  inner.drift = vec2(0.0);
  inner.tilt = vec2(0.0);

  coverage = box_share(q, vec2(1.0 / size), tile.local, place == PLACE_INSIDE);
  if (place == PLACE_INSIDE) {
    vec2 tiles = footprint(tile.local);
    float away = clamp(2.0 * max(tiles.x, tiles.y) - 1.0, 0.0, 1.0);
    coverage = mix(coverage, far < 0.0 ? size * size : far, away);
  }
  coverage = scale > 0.0 ? coverage : 0.0;
}

/// In space the pattern turns about the third axis: trees that stand upright.
/// @param tile the tile
/// @param position where the pattern is in its tile, from (0, 0, 0) to (1, 1, 1)
///   @default vec3(0.5)
/// @param scale the size of the pattern, in tiles; at most 0 hides it @default 1
/// @param rotation how far it is turned about the third axis, counter-clockwise @default 0
///   @unit degrees
/// @param place inside, the pattern stays in its tile; anywhere, its middle is at the position
///   @default PLACE_INSIDE
/// @param far the coverage where a pixel holds many tiles: the mean of all; below 0 it is what the
///   tile's own pattern takes of the tile, the mean if all are scaled alike @default -1 @range -1 1
/// @param inner the pattern's frame
/// @param coverage the share of the pixel that the pattern covers, in the pixel's slice
void tile_transform(Tile3 tile, vec3 position, float scale, float rotation, const int place,
                    float far, out Tile3 inner, out float coverage) {
  float angle = radians(rotation);
  vec2 turn = vec2(cos(angle), sin(angle));
  vec2 ground = tile.size.xy;
  vec3 box = vec3(abs(turn.x) + abs(turn.y) * ground.yx / ground, 1.0);
  float size = max(scale, 1e-5);
  vec3 middle = position;
  if (place == PLACE_INSIDE) {
    size = min(size, 1.0 / max(max(box.x, box.y), 1.0));
    vec3 half_box = 0.5 * size * box;
    middle = half_box + clamp(position, 0.0, 1.0) * (1.0 - 2.0 * half_box);
  }
  vec3 from_middle = tile.local - middle;
  vec2 p = from_middle.xy * ground;
  vec2 q = vec2(dot(turn, p), turn.x * p.y - turn.y * p.x) / (size * ground) + 0.5;

  inner.cell = tile.cell;
  inner.local = vec3(q, from_middle.z / size + 0.5);
  inner.size = size * tile.size;
  inner.seed = tile.seed;
  inner.right = turn.x * tile.right + turn.y * tile.up;
  inner.up = turn.x * tile.up - turn.y * tile.right;
  inner.toward = tile.toward;

  float height = inner.local.z;
  float pixel = clamp(footprint(height), 1e-5, 1.0 / size);
  float slice = clamp(min((0.5 - abs(height - 0.5)) / pixel + 0.5, 1.0 / pixel), 0.0, 1.0);
  coverage = slice * box_share(q, vec2(1.0 / size), tile.local.xy, place == PLACE_INSIDE);
  if (place == PLACE_INSIDE) {
    vec2 tiles = footprint(tile.local.xy);
    float away = clamp(2.0 * max(tiles.x, tiles.y) - 1.0, 0.0, 1.0);
    coverage = mix(coverage, far < 0.0 ? size * size * slice : far, away);
  }
  coverage = scale > 0.0 ? coverage : 0.0;
}
