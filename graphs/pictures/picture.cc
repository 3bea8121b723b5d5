// SPDX-License-Identifier: Apache-2.0
#include "graphs/pictures/picture.h"

#include <cmath>

namespace texgraph::pictures {

Color Mix(Color a, Color b, double t) {
  return {Mix(a.r, b.r, t), Mix(a.g, b.g, t), Mix(a.b, b.b, t)};
}

Color operator*(Color color, double factor) {
  return {color.r * factor, color.g * factor, color.b * factor};
}

namespace {

uint8_t Quantize(double value) {
  return static_cast<uint8_t>(std::floor(Clamp(value, 0, 1) * 255 + 0.5));
}

// How bright a slope is, 1 for a level one: Lambert's law, with light from the upper left and from
// all around.
double Shade(double slope_x, double slope_y) {
  double length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
  double lit = (0.42 * slope_x + 0.50 * slope_y + 0.76) / length / 0.76;
  return 0.45 + 0.55 * Clamp(lit, 0, 1.8);
}

}  // namespace

Picture Paint(int width, int height, bool has_alpha, const Painter& painter) {
  Picture picture{width, height, has_alpha, {}};
  picture.pixels.reserve(static_cast<size_t>(width) * height * (has_alpha ? 4 : 3));
  double step = 1.0 / height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Point p{(x + 0.5) * step, (y + 0.5) * step};
      double level = painter.height(p);
      double slope_x = (painter.height({p.x + step, p.y}) - level) / step;
      double slope_y = (painter.height({p.x, p.y + step}) - level) / step;
      Surface surface = painter.surface(p);
      Color color = surface.color * Shade(painter.relief * slope_x, painter.relief * slope_y);
      picture.pixels.push_back(Quantize(color.r));
      picture.pixels.push_back(Quantize(color.g));
      picture.pixels.push_back(Quantize(color.b));
      if (has_alpha) {
        picture.pixels.push_back(Quantize(surface.alpha));
      }
    }
  }
  return picture;
}

Picture PaintRelief(int width, int height, const Relief& relief) {
  Picture picture{width, height, relief.alpha != nullptr, {}};
  double step = 1.0 / height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Point p{(x + 0.5) * step, (y + 0.5) * step};
      double half = 0.5 * step;
      double across = (relief.height({p.x + half, p.y}) - relief.height({p.x - half, p.y})) / step;
      double down = (relief.height({p.x, p.y + half}) - relief.height({p.x, p.y - half})) / step;
      double length = std::sqrt(1 + across * across + down * down);
      picture.pixels.push_back(Quantize(0.5 - 0.5 * across / length));
      picture.pixels.push_back(Quantize(0.5 + 0.5 * down / length));
      picture.pixels.push_back(Quantize(0.5 + 0.5 / length));
      if (picture.has_alpha) {
        picture.pixels.push_back(Quantize(relief.alpha(p)));
      }
    }
  }
  return picture;
}

std::vector<NamedPicture> Pictures() {
  return {
      {"animated_tiles/drops.png", MakeDrops},
      {"aperiodic_tiling/ground.png", MakeMeadow},
      {"brick_wall/brick.png", [] { return MakeBrick(256); }},
      {"brick_wall/mortar.png", [] { return MakeMortar(256); }},
      {"brick_wall/moss.png", [] { return MakeMoss(256); }},
      {"brick_wall/soot.png", MakeSoot},
      {"daisies/daisy.png", MakeDaisy},
      {"first_wall/brick.png", [] { return MakeBrick(128); }},
      {"first_wall/leaf_on_black.png", MakeLeafOnBlack},
      {"first_wall/mortar.png", [] { return MakeMortar(128); }},
      {"first_wall/moss.png", [] { return MakeMoss(128); }},
      {"flower_field/beds.png", MakeFlowerBeds},
      {"flower_field/flowers.png", MakeFlowers},
      {"hallway/brick_relief.png", MakeBrickRelief},
      {"hallway/crack.png", MakeCrack},
      {"hallway/door.png", MakeDoor},
      {"hallway/door_relief.png", MakeDoorRelief},
      {"granite/granite.png", MakeGranite},
      {"grass_tiles/grass.png", MakeGrass},
      {"hallway/hole.png", MakeHole},
      {"hallway/plaster.png", MakePlaster},
      {"hallway/plaster_relief.png", MakePlasterRelief},
      {"hallway/window.png", MakeWindow},
      {"hallway/window_relief.png", MakeWindowRelief},
      {"hex_tiling/gravel.png", MakeGravel},
      {"hex_tiling/gravel_height.png", MakeGravelHeight},
      {"hex_tiling/gravel_relief.png", MakeGravelRelief},
      {"hex_tiling/lawn.png", MakeLawn},
      {"landscape/ground.png", MakeLandscape},
      {"led_board/lamps.png", MakeLamps},
      {"led_board/message.png", MakeMessage},
      {"moving_sprites/insects.png", MakeInsects},
      {"noise_by_example/lichen_map.png", MakeLichenMap},
      {"opening_flowers/flower.png", MakeOpeningFlower},
      {"painted_wood/wood.png", MakeWood},
      {"pebbles/pebbles.png", MakePebbles},
      {"pebbles/pebbles_height.png", MakePebblesHeight},
      {"pebbles/pebbles_relief.png", MakePebblesRelief},
      {"pebbles/pebbles_roughness.png", MakePebblesRoughness},
      {"plain/dry_grass.png", MakeDryGrass},
      {"plain/earth.png", MakeEarth},
      {"plain/kinds.png", MakeKinds},
      {"roof_tiles/roof_tile.png", MakeRoofTile},
      {"roof_tiles/roof_tile_relief.png", MakeRoofTileRelief},
      {"scattered_leaves/floor.png", MakeForestFloor},
      {"scattered_leaves/leaves.png", MakeLeaves},
      {"tiled_floor/glaze.png", MakeGlaze},
      {"tiled_floor/glaze_relief.png", MakeGlazeRelief},
      {"tiled_floor/wear.png", MakeWear},
      {"transition_tiling/ground.png", MakeShore},
      {"volumetric_trees/trees.png", MakeTrees},
      {"wei_tiles/corner_dots.png", MakeCornerDots},
      {"wei_tiles/edge_dot_corners.png", MakeEdgeDotCorners},
      {"wei_tiles/edge_dots.png", MakeEdgeDots},
      {"wei_tiles/paths.png", MakePaths},
      {"wei_tiles/paths_row_major.png", MakePathsRowMajor},
  };
}

}  // namespace texgraph::pictures
