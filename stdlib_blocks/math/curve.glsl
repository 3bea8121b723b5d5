// SPDX-License-Identifier: Apache-2.0
const int INTERPOLATION_LINEAR = 0;
const int INTERPOLATION_MONOTONE = 1;
const int INTERPOLATION_STEPS = 2;

// The slope of the straight line from a point to the next one; none beyond the ends.
float secant(const vec2 points[], int i) {
  vec2 way = points[i + 1] - points[i];
  return way.y / max(way.x, 1e-7);
}

// Steffen's slope at a point: that of the parabola through it and its neighbours, but never more
// than twice the flatter of both secants, and 0 where they do not rise both or fall both. At the
// ends it is the parabola's there, within the same limits.
float slope_at(const vec2 points[], int i) {
  int last = points.length() - 1;
  if (last == 1) {
    return secant(points, 0);
  }
  int middle = clamp(i, 1, last - 1);
  float before = secant(points, middle - 1);
  float behind = secant(points, middle);
  float length_before = max(points[middle].x - points[middle - 1].x, 1e-7);
  float length_behind = max(points[middle + 1].x - points[middle].x, 1e-7);
  float all = length_before + length_behind;
  if (i == middle) {
    float parabola = (before * length_behind + behind * length_before) / all;
    float flatter = min(abs(before), abs(behind));
    return (sign(before) + sign(behind)) * min(flatter, 0.5 * abs(parabola));
  }
  float own = i == 0 ? before : behind;
  float share = (i == 0 ? length_before : length_behind) / all;
  float parabola = own + share * (own - (i == 0 ? behind : before));
  if (parabola * own <= 0.0) {
    return 0.0;
  }
  return abs(parabola) > 2.0 * abs(own) ? 2.0 * own : parabola;
}

// The mean of the part behind point i: the cubic's value in the middle of what is seen of it, and
// its second derivative times reach^2 / 6, which is exact.
float part_mean(const vec2 points[], int i, float middle, float reach, const int interpolation) {
  vec2 from = points[i];
  vec2 to = points[i + 1];
  if (interpolation == INTERPOLATION_STEPS) {
    return from.y;
  }
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  if (interpolation == INTERPOLATION_LINEAR) {
    return mix(from.y, to.y, t);
  }
  float rise = to.y - from.y;
  float start = way * slope_at(points, i) - rise;
  float end = rise - way * slope_at(points, i + 1);
  // from + rise t + t (1 - t) (start (1 - t) + end t)
  float bend = (6.0 * t - 4.0) * start + (2.0 - 6.0 * t) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

/// Bends a value by a curve through points, as painting programs do with tones.
/// Before the first point and after the last it is constant. A monotone curve has no kinks between,
/// and no value beyond those of the points on both sides: where points rise it rises. It is the
/// exact mean over the value's footprint, so steep parts and steps do not alias.
/// @source Steffen, A Simple Method for Monotonic Interpolation in One Dimension, Astronomy and
///   Astrophysics 239, 1990
/// @param value the value
/// @param points value and result, in rising order of the value; two may have the same
///   @length 2 256 @default vec2[](vec2(0, 0), vec2(1, 1))
/// @param interpolation linear, straight lines; monotone, a smooth curve; steps, each point's
///   result up to the next one @default INTERPOLATION_MONOTONE
/// @param filtered whether it is filtered; else it needs no derivatives of the value @default true
float curve(float value, const vec2 points[], const int interpolation, const bool filtered) {
  int last = points.length() - 1;
  if (!filtered) {
    int part = 0;
    for (int i = 1; i < last; i++) {
      part = value >= points[i].x ? i : part;
    }
    float inside = clamp(value, points[0].x, points[last].x);
    float bent = part_mean(points, part, inside, 0.0, interpolation);
    return value >= points[last].x ? points[last].y : bent;
  }
  float width = max(footprint(value), 1e-7);
  // The share of the pixel that is below a point.
  float below = clamp((points[0].x - value) / width + 0.5, 0.0, 1.0);
  float sum = points[0].y * below;
  for (int i = 0; i < last; i++) {
    float next = clamp((points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float reach = 0.5 * (next - below) * width;
    sum += (next - below) * part_mean(points, i, middle, reach, interpolation);
    below = next;
  }
  return sum + (1.0 - below) * points[last].y;
}
