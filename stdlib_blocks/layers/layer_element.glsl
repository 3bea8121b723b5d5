// SPDX-License-Identifier: Apache-2.0
// A direction or a place, turned and mirrored from the element into its image; about (0, 0).
vec2 turned(vec2 p, uint bits, const int turn, const int flip) {
  if (turn == TURN_QUARTERS) {
    p = (bits & 1u) != 0u ? vec2(p.y, -p.x) : p;
  }
  if (turn != TURN_NONE) {
    p = (bits & 2u) != 0u ? -p : p;
  }
  if (flip == FLIP_X || flip == FLIP_BOTH) {
    p.x = (bits & 4u) != 0u ? -p.x : p.x;
  }
  if (flip == FLIP_Y || flip == FLIP_BOTH) {
    p.y = (bits & 8u) != 0u ? -p.y : p.y;
  }
  return p;
}

// The greatest |cos| and |sin| between two angles in degrees.
vec2 steepest(vec2 rotation) {
  vec2 from = vec2(rotation.x, rotation.x + 90.0);
  vec2 to = vec2(rotation.y, rotation.y + 90.0);
  vec2 ends = max(abs(cos(radians(from))), abs(cos(radians(to))));
  return vec2(floor(to.x / 180.0) >= ceil(from.x / 180.0) ? 1.0 : ends.x,
              floor(to.y / 180.0) >= ceil(from.y / 180.0) ? 1.0 : ends.y);
}

// The greatest |cos| and |sin| of the sum of two angles.
vec2 tilted(vec2 tilt, vec2 by) {
  return min(vec2(dot(tilt, by), dot(tilt, by.yx)), vec2(1.0));
}

/// Where a layer's element is in its tile, and how much of the pixel it covers: a layer without its
/// image. For layers that draw something else than a colour, or that several layers share.
/// Angles and shapes are kept in texture space: a long brick that is turned does not shear.
/// @source the brick shader generator, sections 3.1 and 3.2: parameters with a minimum and a
///   maximum for each element of a tile's template, and parents
/// @param tile where it is: a tile of a grid, or the `inner` of a parent
/// @param position_min left and lower limit of the centre's position, in tiles @default vec2(0.5)
/// @param position_max right and upper limit of the centre's position, in tiles @default vec2(0.5)
///   @not_below position_min
/// @param scale least and greatest size, in tiles; above 0 @default vec2(1) @ordered
/// @param stretch least and greatest height for each width: 1 keeps the shape that `fit` gives, 2
///   is twice as high; above 0 @default vec2(1) @ordered
/// @param rotation least and greatest angle, counter-clockwise @default vec2(0) @unit degrees
///   @ordered
/// @param opacity least and greatest opacity @default vec2(1) @range 0 1 @ordered
/// @param chance the share of the tiles in which the image is drawn @default 1 @range 0 1
/// @param fit the shape at scale 1: stretch, that of the tile; contain, the largest square that
///   fits in; cover, the smallest square that covers the tile, and is cut off at its border
///   @default FIT_STRETCH
/// @param turn the image is turned within its element at random: none; halves, by 0 or 180 degrees;
///   quarters, by 0, 90, 180 or 270 degrees @default TURN_NONE
/// @param flip the image is mirrored within its element at random: none; x, left and right; y, up
///   and down; both, each for itself @default FLIP_NONE
/// @param stream layers with different streams vary independently of each other @default 0
/// @param cut whether the element ends at the border of its tile, where the next tile goes on;
///   else it is all there, and the tiles around have to be looked at as well @default true
/// @param alpha the share of the pixel that the element covers, times its opacity; 0 where it is
///   not there. Of an element that is cut it passes into the mean of all tiles where a pixel grows
///   as large as a tile
/// @param inner the frame of the image, turned and flipped with it, as a tile for child layers
/// @param inner_position the tile moved as the image is, for children that follow its position
///   alone
/// @param inner_rotation the tile turned about its middle as the image is, for children that follow
///   its rotation alone
/// @param inner_scale the tile scaled about its middle as the image is, for children that follow
///   its scale alone
/// @param present 1 where the tile has its element, 0 where `chance` left it out. As the `chance`
///   of a child, or a factor of it, it leaves the child out as well
void layer_element(Tile tile, vec2 position_min, vec2 position_max, vec2 scale, vec2 stretch,
                   vec2 rotation, vec2 opacity, float chance, const int fit, const int turn,
                   const int flip, int stream, const bool cut, out float alpha, out Tile inner,
                   out Tile inner_position, out Tile inner_rotation, out Tile inner_scale,
                   out float present) {
  uint seed = hash(tile.seed + uint(stream));
  vec2 pose = random2(seed, -2);
  float angle = radians(mix(rotation.x, rotation.y, pose.y));
  uint bits = hash(seed - 4u);
  float ratio = mix(stretch.x, stretch.y, float(bits & 65535u) * 0.0000152587890625);
  float size = mix(scale.x, scale.y, pose.x);
  float side = fit == FIT_CONTAIN ? min(tile.size.x, tile.size.y) : max(tile.size.x, tile.size.y);
  vec2 frame = fit == FIT_STRETCH ? tile.size : vec2(side);
  vec2 along = fit == FIT_STRETCH ? vec2(1.0) : tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / frame;
  vec2 center = mix(position_min, position_max, random2(seed, -1));
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 1.0 / ratio);
  vec2 q = cos(angle) * into * along * p + (sin(angle) * into * across * p.yx + 0.5);
  vec2 away = max(abs(position_min - 0.5), abs(position_max - 0.5)) * tile.largest;
  vec2 drift = tile.drift + tile.tilt.x * away + tile.tilt.y * away.yx;
  vec2 tilt = tilted(tile.tilt, steepest(rotation));
  vec2 most = scale.y * vec2(1.0, stretch.y);
  vec2 right = cos(angle) * tile.right + sin(angle) * tile.up;
  vec2 up = cos(angle) * tile.up - sin(angle) * tile.right;

  inner.cell = tile.cell;
  if (turn == TURN_NONE && flip == FLIP_NONE) {
    inner.local = q;
  } else {
    inner.local = turned(q - 0.5, bits >> 16u, turn, flip) + 0.5;
  }
  inner.size = size * vec2(1.0, ratio) * frame;
  inner.largest = most * tile.largest;
  if (fit == FIT_CONTAIN) {
    inner.largest = most * min(tile.largest.x, tile.largest.y);
  } else if (fit == FIT_COVER) {
    inner.largest = most * max(tile.largest.x, tile.largest.y);
  }
  if (turn == TURN_QUARTERS) {
    inner.size = (bits >> 16u & 1u) != 0u ? inner.size.yx : inner.size;
    inner.largest = vec2(max(inner.largest.x, inner.largest.y));
  }
  inner.seed = seed;
  vec2 to_x = turned(vec2(right.x, up.x), bits >> 16u, turn, flip);
  vec2 to_y = turned(vec2(right.y, up.y), bits >> 16u, turn, flip);
  inner.right = vec2(to_x.x, to_y.x);
  inner.up = vec2(to_x.y, to_y.y);
  inner.pitch = tile.pitch;
  inner.smallest = vec2(0.0);
  inner.drift = drift;
  inner.tilt = tilt;

  vec2 from_middle = tile.local - 0.5;
  inner_position = tile;
  inner_position.local = p + 0.5;
  inner_position.seed = seed;
  inner_position.smallest = vec2(0.0);
  inner_position.drift = drift;

  inner_rotation = tile;
  inner_rotation.local =
      cos(angle) * from_middle +
      (sin(angle) * vec2(tile.size.y, -tile.size.x) / tile.size * from_middle.yx + 0.5);
  inner_rotation.seed = seed;
  inner_rotation.smallest = vec2(0.0);
  inner_rotation.right = right;
  inner_rotation.up = up;
  inner_rotation.tilt = tilt;

  inner_scale = tile;
  inner_scale.local = into * from_middle + 0.5;
  inner_scale.size = size * vec2(1.0, ratio) * tile.size;
  inner_scale.seed = seed;
  inner_scale.smallest = vec2(0.0);
  inner_scale.largest = most * tile.largest;

  vec2 luck = random2(seed, -3);
  alpha = mix(opacity.x, opacity.y, luck.x) * box_share(q, along * into, tile.local, cut);
  present = 1.0;
  if (chance < 1.0 && luck.y >= chance) {
    present = 0.0;
    alpha = 0.0;
  }
  if (cut) {
    // Where a pixel holds whole tiles it shows their mean.
    vec2 width = footprint(tile.local);
    float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
    float squares = (dot(scale, scale) + scale.x * scale.y) / 3.0;
    float area = min(squares * mix(stretch.x, stretch.y, 0.5) / (along.x * along.y), 1.0);
    alpha = mix(alpha, chance * mix(opacity.x, opacity.y, 0.5) * area, far);
  }
}
