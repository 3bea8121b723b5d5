// SPDX-License-Identifier: Apache-2.0
// A picture made of many small things laid over each other: blades of grass, stones, petals.
// Coordinates are those of Paint: (0, 0) at the upper left, (width / height, 1) at the lower right.
// Each pixel is the mean of 16 points, averaged in the squares of sRGB values, which is close to
// linear light.
#pragma once

#include <functional>
#include <vector>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

Point operator+(Point a, Point b);
Point operator-(Point a, Point b);
Point operator*(Point p, double factor);
double Dot(Point a, Point b);
double Length(Point p);
Point Unit(Point p);  // of length 1; (1, 0) for a point near 0
// One of all directions, by two random numbers.
Point Direction(int x, int y, uint32_t seed);
// `p` in a frame whose x axis is `along`, of length 1.
Point Turned(Point p, Point along);

class Canvas {
 public:
  Canvas(int width, int height);

  // Everywhere, opaque.
  void Fill(const std::function<Color(Point)>& color);
  // Lays `surface`, asked for at offsets from `center`, over what lies within `reach` each way.
  void Stamp(Point center, double reach, const std::function<Surface(Point)>& surface);
  // An ellipse with a soft rim; `along`, of length 1, is the direction of its half axis `size.x`.
  void Spot(Point center, Point along, Point size, Color color, double alpha,
            double softness = 0.3);
  // A stroke from `from` to `to`, bent sideways by `bend` in its middle, that tapers off; `width`
  // is half of it at the foot. From the colour `foot` to `tip`.
  void Stroke(Point from, Point to, double bend, double width, Color foot, Color tip);

  // Where nothing was laid, pixels are transparent and have the colour `backdrop`.
  Picture Finish(Color backdrop) const;
  // All of it, without alpha.
  Picture FinishOpaque() const;

 private:
  struct Sample {
    float r, g, b, a;  // squares of colours, times alpha
  };
  Sample MeanOf(int x, int y) const;

  int width_;
  int height_;
  std::vector<Sample> samples_;
};

// Pictures of one size in a grid, row by row from the upper left.
Picture Sheet(int columns, const std::vector<Picture>& pictures);
// With 32 values a channel, for pictures in which nothing is smooth: the file is half as large.
Picture Coarse(Picture picture);

}  // namespace texgraph::pictures
