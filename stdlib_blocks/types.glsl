// SPDX-License-Identifier: Apache-2.0
// The struct types of the library. Every block may use them; a graph may carry them on a wire.
// And the constants that blocks share.

// What red, green and blue are in a colour with alpha: themselves, or already multiplied by it.
// Colours on wires are straight unless a port says otherwise.
const int ALPHA_STRAIGHT = 0;
const int ALPHA_PREMULTIPLIED = 1;

// Where the random numbers of tile maps come from: the cell's hash, or a table of permutations.
const int RANDOMNESS_HASH = 0;
const int RANDOMNESS_PERMUTATION = 1;

// How an image lies in the tile of a layer: stretched over it, or as the largest square in it, or
// the smallest around it.
const int FIT_STRETCH = 0;
const int FIT_CONTAIN = 1;
const int FIT_COVER = 2;

// By which angles a layer turns its elements at random.
const int TURN_NONE = 0;
const int TURN_HALVES = 1;
const int TURN_QUARTERS = 2;

// In which directions a layer mirrors its elements at random.
const int FLIP_NONE = 0;
const int FLIP_X = 1;
const int FLIP_Y = 2;
const int FLIP_BOTH = 3;

// How a gradient goes on beyond its ends: it stays as it is, begins anew, or turns back.
const int SPREAD_PAD = 0;
const int SPREAD_REPEAT = 1;
const int SPREAD_REFLECT = 2;

// How far two points are from each other: along a straight line; the sum, or the greatest, of the
// components; or the root of the sum of their powers, for an exponent between these.
const int METRIC_EUCLIDEAN = 0;
const int METRIC_MANHATTAN = 1;
const int METRIC_CHEBYSHEV = 2;
const int METRIC_MINKOWSKI = 3;

// Where the copies of a bombed image end: at the image's frame, or at the circle inside of it.
const int SHAPE_SQUARE = 0;
const int SHAPE_DISC = 1;

/// One tile of a tiling, as seen from one point: what a block needs to draw something else in every
/// tile.
///
/// cell: which tile, as column and row. All points of a tile have the same.
/// local: the point in the tile's own frame, from (0, 0) at its lower left corner to (1, 1).
/// size: width and height of that frame in texture space, to keep lengths and angles there.
/// seed: random bits that all points of a tile share and no two tiles have in common; see `random`.
/// right, up: the directions of the frame's axes in texture space, of length 1. Where a frame is
/// turned or mirrored, what has a direction itself, a normal say, turns with it.
/// pitch: how far apart the grid's columns and rows are, in texture space; 0 if the grid cannot
/// show its neighbours.
/// smallest: the least width and height of a tile of the grid; 0 in a layer's frame.
/// largest, drift, tilt: what the frame can be in any tile of the grid, however the dice fall:
/// its greatest width and height, the greatest distance of its middle from the middle of the grid's
/// tile, both in texture space, and the greatest |cos| and |sin| of its angle there. A grid whose
/// tiles are not all alike gives as drift how much nearer than a pitch its tiles can be. From these
/// `layer_neighbours` knows how far an element can reach.
///
/// A layer gives a tile as well, its own frame, in which `local` may lie outside the unit square.
struct Tile {
  ivec2 cell;
  vec2 local;
  vec2 size;
  uint seed;
  vec2 right;
  vec2 up;
  vec2 pitch;
  vec2 smallest;
  vec2 largest;
  vec2 drift;
  vec2 tilt;
};

/// One cell of a line of cells, as seen from one point: a Tile of one dimension.
///
/// cell: its number. All points of a cell have the same.
/// local: the point in the cell, from 0 to 1.
/// size: how long the cell is in texture space.
/// seed: random bits that all points of a cell share.
struct Tile1 {
  int cell;
  float local;
  float size;
  uint seed;
};

/// One cell of a grid in space, as seen from one point, or a body that lies there: a Tile of three
/// dimensions.
///
/// cell: which cell, as column, row and slice. All points of a cell have the same.
/// local: the point in the cell's frame, from (0, 0, 0) to (1, 1, 1).
/// size: the frame's extent in texture space.
/// seed: random bits that all points of a cell share.
/// right, up, toward: the directions of the frame's axes in texture space, of length 1.
struct Tile3 {
  ivec3 cell;
  vec3 local;
  vec3 size;
  uint seed;
  vec3 right;
  vec3 up;
  vec3 toward;
};

/// A surface at one point, all of its channels on one wire.
///
/// color: linear light, straight alpha. Its alpha is the surface's opacity.
/// normal: of length 1, in texture space: x to where u grows, y to where v grows, z out of the
/// surface. (0, 0, 1) is flat.
/// height: over the surface's own level, in the unit that the graph chooses.
/// roughness: from 0, a mirror, to 1.
/// metallic: 1 for metal, 0 for what is none.
struct Material {
  vec4 color;
  vec3 normal;
  float height;
  float roughness;
  float metallic;
};
