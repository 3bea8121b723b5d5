// SPDX-License-Identifier: Apache-2.0
/// Draws a material once in every tile, each time a little different: as `layer`, but with all
/// channels together.
/// The normal turns with its element, and is mirrored with it, so that the light falls on a turned
/// brick as it should. All channels of elements that lie on each other are composited by the same
/// share. Slopes and heights stay as they are in elements that are scaled.
/// For what the ports mean see `layer`: children, neighbours and the order of elements are as
/// there.
/// @source the brick shader generator, sections 3.1 and 3.2: parameters with a minimum and a
///   maximum for each element of a tile's template, and parents
/// @param image what is drawn, from (0, 0) at its lower left corner to (1, 1): a function of the
///   graph that gives a material, whose normal is in the image's own frame. It may take `tile` as
///   well, which is `inner`: its random bits are the element's own, so that no two elements need be
///   alike
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
/// @param fade_size the layer goes to `far` where the shorter side of its largest elements has
///   fewer pixels: it is all there from this size on, and gone at half of it; 0 never @default 0
///   @range 0 4096 @unit pixels
/// @param far what the layer is from far away: its mean over a tile, with the share of the tile
///   that it covers as the alpha of its colour; by default it fades out
///   @default Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.6, 0.0)
/// @param stream layers with different streams vary independently of each other @default 0
/// @param neighbour the tile that `inner` and the others are asked for; a child layer does
///   @default neighbour
/// @param surface the layer's material; the alpha of its colour says where it is
/// @param inner the frame of the image, turned and flipped with it, as a tile for child layers
/// @param inner_position the tile moved as the image is, for children that follow its position
///   alone
/// @param inner_rotation the tile turned about its middle as the image is, for children that follow
///   its rotation alone
/// @param inner_scale the tile scaled about its middle as the image is, for children that follow
///   its scale alone
/// @param present 1 where the tile has its element, 0 where `chance` left it out. As the `chance`
///   of a child, or a factor of it, it leaves the child out as well
Material image(vec2 uv, Tile tile);
Tile tile(ivec2 neighbour);
vec2 position_min(ivec2 neighbour);
vec2 position_max(ivec2 neighbour);
vec2 scale(ivec2 neighbour);
vec2 stretch(ivec2 neighbour);
vec2 rotation(ivec2 neighbour);
vec2 opacity(ivec2 neighbour);
float chance(ivec2 neighbour);
vec3 tint(ivec2 neighbour);

// The element of one tile: its material, and where it is.
Material draw(ivec2 which, const int fit, const int turn, const int flip, int stream,
              const bool cut, out Tile inner, out Tile inner_position, out Tile inner_rotation,
              out Tile inner_scale, out float present) {
  float alpha;
  layer_element(tile(which), position_min(which), position_max(which), scale(which), stretch(which),
                rotation(which), opacity(which), chance(which), fit, turn, flip, stream, cut, alpha,
                inner, inner_position, inner_rotation, inner_scale, present);
  Material seen = Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0);
  if (cut || alpha > 0.0) {
    seen = image(inner.local, inner);
    seen.color = vec4(seen.color.rgb * tint(which), seen.color.a * alpha);
    seen.normal = turn_normal(seen.normal, inner);
  }
  return seen;
}

// All channels times a factor.
Material weighed(Material surface, float weight) {
  return Material(vec4(surface.color.rgb * weight, weight), weight * surface.normal,
                  weight * surface.height, weight * surface.roughness, weight * surface.metallic);
}

Material sum(Material a, Material b) {
  return Material(a.color + b.color, a.normal + b.normal, a.height + b.height,
                  a.roughness + b.roughness, a.metallic + b.metallic);
}

// From a sum of weighed materials, whose weights are in the alpha, to their mean; flat where there
// is none.
Material mean(Material total) {
  float share = 1.0 / max(total.color.a, 1e-20);
  vec3 n = total.normal + vec3(0.0, 0.0, 1e-9);
  return Material(vec4(total.color.rgb * share, total.color.a),
                  n * inversesqrt(max(dot(n, n), 1e-20)), total.height * share,
                  total.roughness * share, total.metallic * share);
}

void material_layer(const int fit, const int turn, const int flip, const int neighbours,
                    float fade_size, Material far, int stream, ivec2 neighbour,
                    out Material surface, out Tile inner, out Tile inner_position,
                    out Tile inner_rotation, out Tile inner_scale, out float present) {
  surface = draw(neighbour, fit, turn, flip, stream, neighbours == 0, inner, inner_position,
                 inner_rotation, inner_scale, present);
  if (neighbours > 0) {
    // From the last to the first, each under what is there already, until nothing shows through.
    // Where a pixel holds whole tiles their elements lie beside each other, not on each other.
    vec2 tiles = footprint(tile(ivec2(0)).local);
    float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
    Material total = Material(vec4(0.0), vec3(0.0), 0.0, 0.0, 0.0);
    for (int y = neighbours; y >= -neighbours; --y) {
      for (int x = neighbours; x >= -neighbours; --x) {
        if (total.color.a < 0.999) {
          Tile a;
          Tile b;
          Tile c;
          Tile d;
          float e;
          Material other = draw(ivec2(x, y), fit, turn, flip, stream, false, a, b, c, d, e);
          total = sum(total, weighed(other, other.color.a * (1.0 - total.color.a * on)));
        }
      }
    }
    surface = mean(total);
    surface.color.a = min(surface.color.a, 1.0);
  }
  if (fade_size > 0.0) {
    Tile here = tile(ivec2(0));
    vec2 most = scale(ivec2(0)).y * vec2(1.0, stretch(ivec2(0)).y);
    float side = fit == FIT_CONTAIN ? min(here.size.x, here.size.y) : max(here.size.x, here.size.y);
    vec2 largest = most * (fit == FIT_STRETCH ? here.size : vec2(side));
    vec2 width = footprint(here.local) * here.size;
    float pixels = min(largest.x, largest.y) / max(max(width.x, width.y), 1e-6);
    float near = clamp(2.0 * pixels / fade_size - 1.0, 0.0, 1.0);
    surface = mean(
        sum(weighed(far, far.color.a * (1.0 - near)), weighed(surface, surface.color.a * near)));
  }
}
