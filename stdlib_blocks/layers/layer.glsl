// SPDX-License-Identifier: Apache-2.0
const int FIT_STRETCH = 0;
const int FIT_CONTAIN = 1;
const int FIT_COVER = 2;
const int TURN_NONE = 0;
const int TURN_HALVES = 1;
const int TURN_QUARTERS = 2;
const int FLIP_NONE = 0;
const int FLIP_X = 1;
const int FLIP_Y = 2;
const int FLIP_BOTH = 3;

/// Draws an image once in every tile, each time a little different: moved, scaled, turned and faded
/// at random within limits.
/// Give it the `inner` tile of another layer to make it that layer's child: it then moves, turns
/// and scales with its parent, as if it were painted on it, and varies on its own on top of that.
/// Angles and shapes are kept in texture space: a long brick that is turned does not shear. An
/// element is not drawn beyond its cell: what sticks out is cut off. The colour is transparent
/// outside the image, with antialiased edges.
/// @source the brick shader generator, sections 3.1 and 3.2: parameters with a minimum and a
///   maximum for each element of a tile's template, and parents
/// @param image what is drawn, from (0, 0) at its lower left corner to (1, 1); straight alpha. A
///   function of the graph may take `tile` as well, which is `inner`: its random bits are the
///   element's own, so that no two elements need be alike
/// @param tile where it is drawn: a tile of a grid, or the `inner` of a parent layer
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
/// @param tint what the image's colour is multiplied by @default vec3(1)
/// @param fit the shape at scale 1: stretch, that of the tile; contain, the largest square that
///   fits in; cover, the smallest square that covers the tile @default FIT_STRETCH
/// @param turn the image is turned within its element at random: none; halves, by 0 or 180 degrees;
///   quarters, by 0, 90, 180 or 270 degrees @default TURN_NONE
/// @param flip the image is mirrored within its element at random: none; x, left and right; y, up
///   and down; both, each for itself @default FLIP_NONE
/// @param fade_size the layer goes to `far` where the shorter side of an element has fewer pixels:
///   it is all there from this size on, and gone at half of it; 0 never @default 0 @range 0 4096
///   @unit pixels
/// @param far what the layer is from far away, straight alpha: its mean over a tile, with the share
///   of the tile that it covers as opacity; by default it fades out @default vec4(0)
/// @param stream layers with different streams vary independently of each other @default 0
/// @param color the layer's colour, straight alpha
/// @param inner the frame of the image, turned and flipped with it, as a tile for child layers
/// @param inner_position the tile moved as the image is, for children that follow its position
///   alone
/// @param inner_rotation the tile turned about its middle as the image is, for children that follow
///   its rotation alone
/// @param inner_scale the tile scaled about its middle as the image is, for children that follow
///   its scale alone
vec4 image(vec2 uv, Tile tile);

// The share of the pixel within its cell that the element covers, for each axis of the element.
// Dividing by the share of the pixel that lies in the cell makes an element that fills its cell
// opaque up to the border, where the neighbour goes on. Beyond the size of a cell the pixel's
// footprint counts as the cell, so that far away the coverage is the share of the cell that the
// element takes.
float coverage(vec2 q, vec2 cell_in_q, vec2 local) {
  vec2 density = 1.0 / clamp(footprint(q), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(footprint(local), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// The place in the image of a place in its element.
vec2 turned(vec2 q, uint bits, const int turn, const int flip) {
  if (turn == TURN_NONE && flip == FLIP_NONE) {
    return q;
  }
  vec2 p = q - 0.5;
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
  return p + 0.5;
}

void layer(Tile tile, vec2 position_min, vec2 position_max, vec2 scale, vec2 stretch, vec2 rotation,
           vec2 opacity, float chance, vec3 tint, const int fit, const int turn, const int flip,
           float fade_size, vec4 far, int stream, out vec4 color, out Tile inner,
           out Tile inner_position, out Tile inner_rotation, out Tile inner_scale) {
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
  inner.cell = tile.cell;
  inner.local = turned(q, bits >> 16u, turn, flip);
  inner.size = size * vec2(1.0, ratio) * frame;
  if (turn == TURN_QUARTERS) {
    inner.size = (bits >> 16u & 1u) != 0u ? inner.size.yx : inner.size;
  }
  inner.seed = seed;
  vec2 from_middle = tile.local - 0.5;
  inner_position = Tile(tile.cell, p + 0.5, tile.size, seed);
  inner_rotation.cell = tile.cell;
  inner_rotation.local =
      cos(angle) * from_middle +
      (sin(angle) * vec2(tile.size.y, -tile.size.x) / tile.size * from_middle.yx + 0.5);
  inner_rotation.size = tile.size;
  inner_rotation.seed = seed;
  inner_scale =
      Tile(tile.cell, into * from_middle + 0.5, size * vec2(1.0, ratio) * tile.size, seed);
  color = image(inner.local, inner);
  color.rgb *= tint;
  vec2 luck = random2(seed, -3);
  if (chance < 1.0 && luck.y >= chance) {
    color.a = 0.0;
  }
  color.a *= mix(opacity.x, opacity.y, luck.x) * coverage(q, along * into, tile.local);
  if (fade_size > 0.0) {
    vec2 width = footprint(q);
    float pixels = 1.0 / max(max(width.x, width.y), 1e-6);
    float near = clamp(2.0 * pixels / fade_size - 1.0, 0.0, 1.0);
    float alpha = mix(far.a, color.a, near);
    color.rgb = mix(far.rgb * far.a, color.rgb * color.a, near) / max(alpha, 1e-20);
    color.a = alpha;
  }
}
