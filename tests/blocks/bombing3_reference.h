// SPDX-License-Identifier: Apache-2.0
// The copies of bombed space, in double precision and from the definitions rather than from the
// blocks: pcg3d step by step, rotations as matrices, and every cell far around.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tests/blocks/reference.h"

namespace texgraph::blocks::reference {

using Vec3 = std::array<double, 3>;
using Matrix3 = std::array<Vec3, 3>;  // rows

inline double Dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vec3 Times(const Matrix3& m, const Vec3& v) {
  return {Dot(m[0], v), Dot(m[1], v), Dot(m[2], v)};
}

inline Matrix3 Transposed(const Matrix3& m) {
  return {{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
}

// Rodrigues' formula, an angle in radians.
inline Matrix3 Rotation(Vec3 axis, double angle) {
  const double length = std::sqrt(Dot(axis, axis));
  for (double& a : axis) a /= length;
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3 m{};
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) m[i][j] = (1 - c) * axis[i] * axis[j] + (i == j ? c : 0);
    const size_t next = (i + 1) % 3, last = (i + 2) % 3;
    m[i][next] -= s * axis[last];
    m[i][last] += s * axis[next];
  }
  return m;
}

// Shoemake 1992: three numbers from 0 to 1 make a quaternion (x, y, z, w), which makes a matrix.
inline Matrix3 Tumbled(double u1, double u2, double u3) {
  const double pi = std::numbers::pi, a = std::sqrt(1 - u1), b = std::sqrt(u1);
  const double x = a * std::sin(2 * pi * u2), y = a * std::cos(2 * pi * u2);
  const double z = b * std::sin(2 * pi * u3), w = b * std::cos(2 * pi * u3);
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

struct SpaceBits {
  std::array<uint32_t, 3> place;
  uint32_t luck, bits;
};

// Jarzynski and Olano 2020, pcg3d without its last shift, the seed in place of its addend and the
// copy's number as a further coordinate; two numbers more are sums of its three words.
inline SpaceBits CopyBits3(int32_t x, int32_t y, int32_t z, int32_t copy, uint32_t seed) {
  const uint32_t number = static_cast<uint32_t>(copy), once = Pcg(seed), twice = Pcg(once);
  std::array<uint32_t, 3> v = {
      static_cast<uint32_t>(x) * 1664525u + once + number * 2654435769u,
      static_cast<uint32_t>(y) * 1664525u + twice + number * 1540483477u,
      static_cast<uint32_t>(z) * 1664525u + Pcg(twice) + number * 2246822519u};
  auto mix = [&v] {
    v[0] += v[1] * v[2];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
  };
  mix();
  for (uint32_t& word : v) word ^= word >> 16;
  mix();
  return {{v[0], v[1], v[0] * 3266489917u + v[1] * 668265263u + v[2] * 374761393u},
          v[0] * 1597334677u + v[1] * 3432918353u + v[2] * 461845907u,
          v[2]};
}

struct Space {
  double jitter = 1;
  double size_min = 1, size_max = 1;
  double rotation_min = 0, rotation_max = 0;  // degrees
  Vec3 axis = {0, 0, 1};
  bool tumble = false;
  bool is_ball = false;
  int copies = 1;
  double density = 1;
  uint32_t seed = 0;
  double spacing = 0;
};

struct Body {
  Vec3 centre{};
  double side = 1;
  Matrix3 turn{};
  uint32_t seed = 0, rank = 0;
  int index = 0;        // in its cell
  Vec3 q{};             // the point in its image
  double edge = 0;      // how far inside the point is, in its image; below 0 outside
  double distance = 0;  // from its centre
};

inline Matrix3 TurnOf(const Space& space, uint32_t seed) {
  const uint32_t first = Pcg(seed - 5);
  if (space.tumble) return Tumbled(Low16(first), High16(first), Unit24(Pcg(first)));
  return Rotation(space.axis, Mix(space.rotation_min, space.rotation_max, Unit24(first)) *
                                  std::numbers::pi / 180);
}

inline Body BodyAt(const Space& space, const std::array<int32_t, 3>& cell, int copy,
                   const Vec3& p) {
  const SpaceBits bits = CopyBits3(cell[0], cell[1], cell[2], copy, space.seed);
  Body body;
  body.seed = bits.bits;
  body.rank = bits.luck;
  body.index = copy;
  body.side = Mix(space.size_min, space.size_max, Unit24(Pcg(body.seed - 2)));
  body.turn = TurnOf(space, body.seed);
  Vec3 from;
  for (size_t i = 0; i < 3; ++i) {
    const double place = static_cast<int32_t>(bits.place[i]) / 4294967296.0;
    body.centre[i] = cell[i] + 0.5 + space.jitter * place;
    from[i] = p[i] - body.centre[i];
  }
  body.q = Times(Transposed(body.turn), from);
  double furthest = 0;
  for (double& q : body.q) {
    q /= body.side;
    furthest = std::max(furthest, std::fabs(q));
    q += 0.5;
  }
  body.distance = std::sqrt(Dot(from, from));
  body.edge = 0.5 - (space.is_ball ? body.distance / body.side : furthest);
  return body;
}

// Whether another copy of at least its rank is nearer than the spacing to one of a cell.
inline bool IsCrowded(const Space& space, const std::array<int32_t, 3>& cell, int copy) {
  constexpr int kFar = 3;
  const Body own = BodyAt(space, cell, copy, {});
  for (int z = cell[2] - kFar; z <= cell[2] + kFar; ++z) {
    for (int y = cell[1] - kFar; y <= cell[1] + kFar; ++y) {
      for (int x = cell[0] - kFar; x <= cell[0] + kFar; ++x) {
        for (int i = 0; i < space.copies; ++i) {
          if (std::array<int32_t, 3>{x, y, z} == cell && i == copy) continue;
          const Body other = BodyAt(space, {x, y, z}, i, own.centre);
          if (other.rank >= own.rank && other.distance < space.spacing) return true;
        }
      }
    }
  }
  return false;
}

// Those at p, given in cells, in the order of slices, rows, columns and numbers.
inline std::vector<Body> BodiesAt(const Space& space, const Vec3& p) {
  constexpr int kFar = 4;
  std::array<int32_t, 3> own;
  for (size_t i = 0; i < 3; ++i) own[i] = static_cast<int32_t>(std::floor(p[i]));
  std::vector<Body> bodies;
  for (int z = own[2] - kFar; z <= own[2] + kFar; ++z) {
    for (int y = own[1] - kFar; y <= own[1] + kFar; ++y) {
      for (int x = own[0] - kFar; x <= own[0] + kFar; ++x) {
        for (int copy = 0; copy < space.copies; ++copy) {
          const uint32_t seed = CopyBits3(x, y, z, copy, space.seed).bits;
          if (Unit24(Pcg(seed - 3)) >= space.density) continue;
          Body body = BodyAt(space, {x, y, z}, copy, p);
          if (body.edge <= -0.1) continue;
          if (space.spacing > 0 && IsCrowded(space, {x, y, z}, copy)) continue;
          bodies.push_back(body);
        }
      }
    }
  }
  return bodies;
}

}  // namespace texgraph::blocks::reference
