// SPDX-License-Identifier: Apache-2.0
/// Draws an image once in every tile, each time a little different: moved, scaled, turned and faded
/// at random within limits.
/// Give it the `inner` tile of another layer to make it that layer's child: it then moves, turns
/// and scales with its parent, as if it were painted on it, and varies on its own on top of that.
/// Angles and shapes are kept in texture space: a long brick that is turned does not shear. An
/// element that reaches out of its tile is drawn whole, on grids that know their neighbours; see
/// `neighbours`. The elements of one layer lie on each other in the order of their tiles: rows from
/// the bottom up, and in a row from left to right, each over those before it. The colour is
/// transparent outside the image, with antialiased edges.
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
///   fits in; cover, the smallest square that covers the tile, and is cut off at its border
///   @default FIT_STRETCH
/// @param turn the image is turned within its element at random: none; halves, by 0 or 180 degrees;
///   quarters, by 0, 90, 180 or 270 degrees @default TURN_NONE
/// @param flip the image is mirrored within its element at random: none; x, left and right; y, up
///   and down; both, each for itself @default FLIP_NONE
/// @param neighbours how far the layer looks for elements of other tiles: 0, not at all, and what
///   sticks out of its tile is cut off; 1, at the 8 tiles around; 2, at 24; 3, at 48. Without a
///   value it is as far as the ranges need @default 0 @range 0 3
///   @computed layer_neighbours smaller scales, or positions nearer to the middle, reach less far
/// @param fade_size the layer goes to `far` where the largest elements' shorter side has fewer
///   pixels: it is all there from this size on, and gone at half of it; 0 never @default 0
///   @range 0 4096 @unit pixels
/// @param far what the layer is from far away, straight alpha: its mean over a tile, with the share
///   of the tile that it covers as opacity; by default it fades out @default vec4(0)
/// @param stream layers with different streams vary independently of each other @default 0
/// @param neighbour the tile that `inner` and the others are asked for; a child layer does
///   @default neighbour
/// @param color the layer's colour, straight alpha
/// @param inner the frame of the image, turned and flipped with it, as a tile for child layers
/// @param inner_position the tile moved as the image is, for children that follow its position
///   alone
/// @param inner_rotation the tile turned about its middle as the image is, for children that follow
///   its rotation alone
/// @param inner_scale the tile scaled about its middle as the image is, for children that follow
///   its scale alone
/// @param present 1 where the tile has its element, 0 where `chance` left it out. As the `chance`
///   of a child, or a factor of it, it leaves the child out as well
vec4 image(vec2 uv, Tile tile);
Tile tile(ivec2 neighbour);
vec2 position_min(ivec2 neighbour);
vec2 position_max(ivec2 neighbour);
vec2 scale(ivec2 neighbour);
vec2 stretch(ivec2 neighbour);
vec2 rotation(ivec2 neighbour);
vec2 opacity(ivec2 neighbour);
float chance(ivec2 neighbour);
vec3 tint(ivec2 neighbour);

// The element of one tile: its colour, and where it is.
vec4 draw(ivec2 which, const int fit, const int turn, const int flip, int stream, const bool cut,
          out Tile inner, out Tile inner_position, out Tile inner_rotation, out Tile inner_scale,
          out float present) {
  float alpha;
  layer_element(tile(which), position_min(which), position_max(which), scale(which),
                stretch(which), rotation(which), opacity(which), chance(which), fit, turn, flip,
                stream, cut, alpha, inner, inner_position, inner_rotation, inner_scale, present);
  vec4 color = vec4(0.0);
  if (cut || alpha > 0.0) {
    color = image(inner.local, inner);
    color = vec4(color.rgb * tint(which), color.a * alpha);
  }
  return color;
}

void layer(const int fit, const int turn, const int flip, const int neighbours, float fade_size,
           vec4 far, int stream, ivec2 neighbour, out vec4 color, out Tile inner,
           out Tile inner_position, out Tile inner_rotation, out Tile inner_scale,
           out float present) {
  color = draw(neighbour, fit, turn, flip, stream, neighbours == 0, inner, inner_position,
               inner_rotation, inner_scale, present);
  if (neighbours > 0) {
    // From the last to the first, each under what is there already, until nothing shows through.
    // Where a pixel holds whole tiles their elements lie beside each other, not on each other.
    vec2 tiles = footprint(tile(ivec2(0)).local);
    float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
    color = vec4(0.0);
    for (int y = neighbours; y >= -neighbours; --y) {
      for (int x = neighbours; x >= -neighbours; --x) {
        if (color.a < 0.999) {
          Tile a;
          Tile b;
          Tile c;
          Tile d;
          float e;
          vec4 other = draw(ivec2(x, y), fit, turn, flip, stream, false, a, b, c, d, e);
          float below = other.a * (1.0 - color.a * on);
          color += vec4(other.rgb * below, below);
        }
      }
    }
    color.rgb /= max(color.a, 1e-20);
    color.a = min(color.a, 1.0);
  }
  if (fade_size > 0.0) {
    Tile here = tile(ivec2(0));
    vec2 most = scale(ivec2(0)).y * vec2(1.0, stretch(ivec2(0)).y);
    float side = fit == FIT_CONTAIN ? min(here.size.x, here.size.y) : max(here.size.x, here.size.y);
    vec2 largest = most * (fit == FIT_STRETCH ? here.size : vec2(side));
    vec2 width = footprint(here.local) * here.size;
    float pixels = min(largest.x, largest.y) / max(max(width.x, width.y), 1e-6);
    float near = clamp(2.0 * pixels / fade_size - 1.0, 0.0, 1.0);
    float alpha = mix(far.a, color.a, near);
    color.rgb = mix(far.rgb * far.a, color.rgb * color.a, near) / max(alpha, 1e-20);
    color.a = alpha;
  }
}
