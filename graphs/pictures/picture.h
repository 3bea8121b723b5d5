// SPDX-License-Identifier: Apache-2.0
// The pictures that the example graphs are drawn with, made from noise: 8 bits a channel, sRGB,
// straight alpha. Transparent pixels have a colour too, so that filtering mixes nothing strange
// into the edges.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "graphs/pictures/noise.h"

namespace texgraph::pictures {

struct Color {  // sRGB values from 0 to 1
  double r = 0;
  double g = 0;
  double b = 0;
};
Color Mix(Color a, Color b, double t);
Color operator*(Color color, double factor);

struct Picture {
  int width = 0;
  int height = 0;
  bool has_alpha = false;
  std::vector<uint8_t> pixels;  // rows from the top, 3 or 4 bytes a pixel
};

// What a painter says of one point. The light comes from the upper left; `height` is in the unit of
// the coordinates.
struct Surface {
  Color color;
  double alpha = 1;
};
struct Painter {
  std::function<double(Point)> height;
  std::function<Surface(Point)> surface;
  double relief = 1;  // how strongly slopes are shaded
};

// Coordinates go from (0, 0) at the upper left to (width / height, 1).
Picture Paint(int width, int height, bool has_alpha, const Painter& painter);

// A relief as data for a graph. `height` says how high a point lies, in the unit of the
// coordinates; red, green and blue are its normal, (n + 1) / 2, x to the right, y up, z out of the
// surface. With `alpha` there is a fourth channel.
struct Relief {
  std::function<double(Point)> height;
  std::function<double(Point)> alpha;
};
Picture PaintRelief(int width, int height, const Relief& relief);

struct NamedPicture {
  std::string path;  // from the folder of graphs
  std::function<Picture()> make;
};
// All of them.
std::vector<NamedPicture> Pictures();

Picture MakeBrick(int height);
Picture MakeBrickRelief();
Picture MakeMortar(int height);
Picture MakeMoss(int height);
Picture MakeSoot();
Picture MakeWood();
Picture MakeLeafOnBlack();
Picture MakePlaster();
Picture MakePlasterRelief();
Picture MakeCrack();
Picture MakeHole();
Picture MakeDoor();
Picture MakeDoorRelief();
Picture MakeWindow();
Picture MakeWindowRelief();
Picture MakeGlaze();
Picture MakeGlazeRelief();
Picture MakeWear();
Picture MakeRoofTile();
Picture MakeRoofTileRelief();
Picture MakeMeadow();
Picture MakeLandscape();
Picture MakeShore();
Picture MakeLeaves();
Picture MakeForestFloor();
Picture MakeLamps();
Picture MakeMessage();
Picture MakeDrops();
Picture MakeOpeningFlower();
Picture MakeTrees();
Picture MakeInsects();
Picture MakeDaisy();
Picture MakeFlowers();
Picture MakeFlowerBeds();
Picture MakeGranite();
Picture MakeLichenMap();
Picture MakeGrass();
Picture MakeDryGrass();
Picture MakeEarth();
Picture MakeKinds();
Picture MakePebbles();
Picture MakePebblesHeight();
Picture MakePebblesRelief();
Picture MakePebblesRoughness();
Picture MakeLawn();
Picture MakeGravel();
Picture MakeGravelHeight();
Picture MakeGravelRelief();
Picture MakePaths();
Picture MakePathsRowMajor();
Picture MakeEdgeDots();
Picture MakeEdgeDotCorners();
Picture MakeCornerDots();

}  // namespace texgraph::pictures
