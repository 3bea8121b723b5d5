// SPDX-License-Identifier: Apache-2.0
const int RULE_EVEN_ODD = 0;
const int RULE_NON_ZERO = 1;
const int RULE_OPEN = 2;

// The first point of a contour is on the curve, whatever it says.
bool begins(const vec3 points[], int i) { return i == 0 || points[i].z > 1.5; }
bool is_control(const vec3 points[], int i) {
  return i > 0 && points[i].z > 0.5 && points[i].z < 1.5;
}

// The place on the curve at `other`, or half-way to it if it is a control point as well.
vec2 curve_end(const vec3 points[], int control, int other) {
  vec2 middle = 0.5 * (points[control].xy + points[other].xy);
  return is_control(points, other) ? middle : points[other].xy;
}

// A distance from the origin that no point between a, b and c is nearer than.
float from_box(vec2 a, vec2 b, vec2 c) {
  return length(max(max(min(min(a, b), c), -max(max(a, b), c)), 0.0));
}

// +1 if the way from the origin to the right is crossed upwards, -1 if downwards. What lies at the
// height of the origin is below it, so the end of one part and the beginning of the next agree.
int line_crossing(vec2 a, vec2 b) {
  float side = a.x * b.y - a.y * b.x;
  int up = a.y <= 0.0 && b.y > 0.0 && side > 0.0 ? 1 : 0;
  int down = a.y > 0.0 && b.y <= 0.0 && side < 0.0 ? 1 : 0;
  return up - down;
}

// The same for a curve. Which of the roots of bend.y t^2 - 2 lead.y t + a.y count follows from the
// heights of a, b and c alone: the first, where the curve goes down, if it begins above or turns
// from above; the second, where it goes up, likewise.
int curve_crossing(vec2 a, vec2 b, vec2 c) {
  vec2 bend = a - 2.0 * b + c;
  vec2 lead = a - b;
  bool goes_down = a.y > 0.0 ? c.y <= 0.0 || b.y <= 0.0 : c.y <= 0.0 && b.y > 0.0;
  bool goes_up = c.y > 0.0 ? a.y <= 0.0 || b.y <= 0.0 : a.y <= 0.0 && b.y > 0.0;
  float under_root = lead.y * lead.y - bend.y * a.y;
  bool meets = goes_down != goes_up || under_root > 0.0;
  float root = sqrt(max(under_root, 0.0));
  float sum = lead.y < 0.0 ? lead.y - root : lead.y + root;
  float by_start = clamp(a.y / (sum == 0.0 ? 1e-20 : sum), 0.0, 1.0);
  float by_bend = clamp(sum / (bend.y == 0.0 ? 1e-20 : bend.y), 0.0, 1.0);
  vec2 t = lead.y < 0.0 ? vec2(by_bend, by_start) : vec2(by_start, by_bend);
  vec2 x = (bend.x * t - 2.0 * lead.x) * t + a.x;
  int down = goes_down && meets && x.x > 0.0 ? 1 : 0;
  int up = goes_up && meets && x.y > 0.0 ? 1 : 0;
  return up - down;
}

/// The distance from a path of lines and curves, such as a letter; below 0 inside.
/// Points are written as fonts of the kind TrueType have them. A line joins two points on the
/// curve. A control point bends the way from the point before it to the one behind it, as in
/// `sdf_quadratic_curve`; half-way between two control points is a point on the curve that need not
/// be written. The nearest part is found without derivatives, by its number; only its distance has
/// some. Inside is what the contours turn around, counted by how often they cross the way to the
/// right.
/// @source Lengyel, GPU-Centered Font Rendering Directly from Glyph Outlines, JCGT 6 (2017)
/// @param uv coordinate @default uv
/// @param points each is x, y and what it is: 0 a point on the curve, 1 a control point, 2 a point
///   on the curve that begins the next contour @length 2 1024
///   @default vec3[](vec3(0.1, 0.5, 0), vec3(0.1, 0.9, 1), vec3(0.9, 0.9, 1), vec3(0.9, 0.5, 0), vec3(0.9, 0.1, 1), vec3(0.1, 0.1, 1), vec3(0.4, 0.4, 2), vec3(0.6, 0.4, 0), vec3(0.5, 0.7, 0))
/// @param rule what is inside: with `even_odd` a contour within another is a hole; with `non_zero`
///   if it goes around the other way, as in fonts, but a part that lies in the shape keeps its
///   distance of 0. With `open` nothing is: contours end where they end, with a point on the curve,
///   and `sdf_stroke` draws them @default RULE_EVEN_ODD
float sdf_path(vec2 uv, const vec3 points[], const int rule) {
  int first = 0;
  int nearest = 0;
  int behind_nearest = 0;
  float least = 1e30;
  int winding = 0;
  for (int i = 0; i < points.length(); i++) {
    first = begins(points, i) ? i : first;
    int after = min(i + 1, points.length() - 1);
    bool ends = after == i || begins(points, after);
    int next = ends ? first : after;
    if (rule != RULE_OPEN || !ends) {
      vec2 point = points[i].xy - uv;
      if (is_control(points, i)) {
        vec2 a = curve_end(points, i, i - 1);
        vec2 c = curve_end(points, i, next);
        if (from_box(a - uv, point, c - uv) < least) {
          float found = sdf_quadratic_curve(uv, a, points[i].xy, c, 0.0);
          nearest = found < least ? i : nearest;
          behind_nearest = found < least ? next : behind_nearest;
          least = min(found, least);
        }
        winding += curve_crossing(a - uv, point, c - uv);
      } else if (!is_control(points, next)) {
        vec2 end = points[next].xy - uv;
        float found = sdf_line(uv, points[i].xy, points[next].xy, 0.0);
        nearest = found < least ? i : nearest;
        behind_nearest = found < least ? next : behind_nearest;
        least = min(found, least);
        winding += line_crossing(point, end);
      }
    }
  }
  float outline = 0.0;
  if (is_control(points, nearest)) {
    vec2 a = curve_end(points, nearest, nearest - 1);
    vec2 c = curve_end(points, nearest, behind_nearest);
    outline = sdf_quadratic_curve(uv, a, points[nearest].xy, c, 0.0);
  } else {
    outline = sdf_line(uv, points[nearest].xy, points[behind_nearest].xy, 0.0);
  }
  bool inside = rule == RULE_EVEN_ODD   ? (winding & 1) != 0
                : rule == RULE_NON_ZERO ? winding != 0
                                        : false;
  return inside ? -outline : outline;
}
