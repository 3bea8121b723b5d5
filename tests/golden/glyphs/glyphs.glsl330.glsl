// glyphs: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 board;  // default vec3(0.012, 0.06, 0.045)
uniform vec3 cream;  // default vec3(0.8, 0.7, 0.47)
uniform vec3 gold;  // default vec3(0.75, 0.4, 0.06)
uniform float bevel;  // default 0.03

// Constants
const vec3 glyphs_points[64] = vec3[64](vec3(0.22, 1.04, 0.0), vec3(0.52, 1.04, 0.0),
    vec3(0.75, 1.04, 1.0), vec3(0.75, 1.24, 0.0), vec3(0.75, 1.37, 1.0), vec3(0.62, 1.405, 0.0),
    vec3(0.72, 1.45, 1.0), vec3(0.72, 1.56, 0.0), vec3(0.72, 1.74, 1.0), vec3(0.5, 1.74, 0.0),
    vec3(0.22, 1.74, 0.0), vec3(0.36, 1.14, 2.0), vec3(0.5, 1.14, 0.0), vec3(0.605, 1.14, 1.0),
    vec3(0.605, 1.245, 0.0), vec3(0.605, 1.35, 1.0), vec3(0.5, 1.35, 0.0), vec3(0.36, 1.35, 0.0),
    vec3(0.36, 1.45, 2.0), vec3(0.48, 1.45, 0.0), vec3(0.58, 1.45, 1.0), vec3(0.58, 1.545, 0.0),
    vec3(0.58, 1.64, 1.0), vec3(0.48, 1.64, 0.0), vec3(0.36, 1.64, 0.0), vec3(1.27, 1.04, 2.0),
    vec3(1.27, 1.36, 0.0), vec3(1.27, 1.55, 1.0), vec3(1.07, 1.55, 0.0), vec3(0.9, 1.55, 1.0),
    vec3(0.87, 1.41, 0.0), vec3(1.0, 1.395, 0.0), vec3(1.01, 1.45, 1.0), vec3(1.065, 1.45, 0.0),
    vec3(1.14, 1.45, 1.0), vec3(1.14, 1.37, 0.0), vec3(1.14, 1.34, 0.0), vec3(0.84, 1.33, 1.0),
    vec3(0.84, 1.175, 0.0), vec3(0.84, 1.03, 1.0), vec3(0.99, 1.03, 0.0), vec3(1.09, 1.03, 1.0),
    vec3(1.145, 1.1, 0.0), vec3(1.15, 1.04, 0.0), vec3(1.14, 1.255, 2.0), vec3(1.14, 1.125, 1.0),
    vec3(1.03, 1.125, 0.0), vec3(0.975, 1.125, 1.0), vec3(0.975, 1.18, 0.0),
    vec3(0.975, 1.255, 1.0), vec3(1.38, 1.04, 2.0), vec3(1.51, 1.04, 0.0), vec3(1.51, 1.31, 0.0),
    vec3(1.51, 1.43, 1.0), vec3(1.63, 1.43, 0.0), vec3(1.66, 1.43, 1.0), vec3(1.68, 1.42, 0.0),
    vec3(1.69, 1.54, 0.0), vec3(1.67, 1.55, 1.0), vec3(1.64, 1.55, 0.0), vec3(1.55, 1.55, 1.0),
    vec3(1.505, 1.47, 0.0), vec3(1.5, 1.54, 0.0), vec3(1.38, 1.54, 0.0));
const vec3 glyphs_points2[32] = vec3[32](vec3(0.48, 0.15, 0.0), vec3(0.75, 0.15, 1.0),
    vec3(0.75, 0.35, 0.0), vec3(0.75, 0.48, 1.0), vec3(0.63, 0.53, 0.0), vec3(0.715, 0.58, 1.0),
    vec3(0.715, 0.685, 0.0), vec3(0.715, 0.87, 1.0), vec3(0.48, 0.87, 0.0), vec3(0.245, 0.87, 1.0),
    vec3(0.245, 0.685, 0.0), vec3(0.245, 0.58, 1.0), vec3(0.33, 0.53, 0.0), vec3(0.21, 0.48, 1.0),
    vec3(0.21, 0.35, 0.0), vec3(0.21, 0.15, 1.0), vec3(0.48, 0.255, 2.0), vec3(0.605, 0.255, 1.0),
    vec3(0.605, 0.36, 0.0), vec3(0.605, 0.47, 1.0), vec3(0.48, 0.47, 0.0), vec3(0.355, 0.47, 1.0),
    vec3(0.355, 0.36, 0.0), vec3(0.355, 0.255, 1.0), vec3(0.48, 0.575, 2.0),
    vec3(0.585, 0.575, 1.0), vec3(0.585, 0.675, 0.0), vec3(0.585, 0.765, 1.0),
    vec3(0.48, 0.765, 0.0), vec3(0.375, 0.765, 1.0), vec3(0.375, 0.675, 0.0),
    vec3(0.375, 0.575, 1.0));
const vec2 glyphs_points3[8] = vec2[8](vec2(0.95, 0.43), vec2(1.34, 0.43), vec2(1.3, 0.27),
    vec2(1.69, 0.51), vec2(1.3, 0.75), vec2(1.34, 0.59), vec2(0.95, 0.59), vec2(1.02, 0.51));
const vec3 glyphs_points4[10] = vec3[10](vec3(0.95, 0.86, 0.0), vec3(1.05, 0.99, 1.0),
    vec3(1.2, 0.89, 0.0), vec3(1.35, 0.79, 1.0), vec3(1.45, 0.9, 1.0), vec3(1.6, 0.98, 1.0),
    vec3(1.69, 0.86, 0.0), vec3(0.95, 0.2, 2.0), vec3(1.3, 0.06, 1.0), vec3(1.69, 0.2, 0.0));
const vec2 glyphs_points5[9] = vec2[9](vec2(0.15, 0.02), vec2(0.02, 0.15), vec2(0.02, 1.75),
    vec2(0.15, 1.88), vec2(1.75, 1.88), vec2(1.88, 1.75), vec2(1.88, 0.15), vec2(1.75, 0.02),
    vec2(0.15, 0.02));

// is_control_word, of sdf_path (shapes/sdf_path.glsl)
bool glyphs_is_control_word(int i) {
  float value = glyphs_points[clamp(i, 0, 63)].z;
  return i > 0 && value > 0.5 && value < 1.5;
}

// curve_end_word, of sdf_path (shapes/sdf_path.glsl)
vec2 glyphs_curve_end_word(int control, int other) {
  vec2 point = glyphs_points[clamp(other, 0, 63)].xy;
  vec2 middle = 0.5 * (glyphs_points[clamp(control, 0, 63)].xy + point);
  return glyphs_is_control_word(other) ? middle : point;
}

// sdf_quadratic_curve (shapes/sdf_quadratic_curve.glsl)
float glyphs_sdf_quadratic_curve(vec2 uv, vec2 a, vec2 b, vec2 c, vec2 uv_dx, vec2 uv_dy,
    out float result_dx, out float result_dy) {
  vec2 from_a = a - uv;
  vec2 from_a_dx = -uv_dx;
  vec2 from_a_dy = -uv_dy;
  vec2 lead = b - a;
  vec2 bend = a - 2.0 * b + c;
  float bend2 = dot(bend, bend);
  float projection = dot(lead, bend);
  float inflection = clamp(-projection / max(bend2, 1e-20), 0.0, 1.0);
  vec2 low = vec2(0.0, inflection);
  vec2 high = vec2(inflection, 1.0);
  float k0 = dot(from_a, lead);
  float k1 = 2.0 * dot(lead, lead) + dot(from_a, bend);
  float k2 = 3.0 * projection;
  vec2 t = vec2(0.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    vec2 product = ((bend2 * t + k2) * t + k1) * t;
    vec2 slope = product + k0;
    vec2 rise = (3.0 * bend2 * t + 2.0 * k2) * t + k1;
    t = clamp(t - slope / max(rise, 1e-20), low, high);
  }
  t = floor(t * 16777216.0 + 0.5) * 5.9604645e-8;
  vec2 product = 2.0 * lead;
  vec2 first = (bend * t.x + product) * t.x + from_a;
  vec2 last = (bend * t.y + product) * t.y + from_a;
  float norm = length(first);
  float greatest = max(norm, 1e-20);
  float norm2 = length(last);
  float greatest2 = max(norm2, 1e-20);
  float least = min(norm, norm2);
  bool test = norm2 < norm;
  float choice = test ? dot(last, from_a_dx) / greatest2 : dot(first, from_a_dx) / greatest;
  float choice2 = test ? dot(last, from_a_dy) / greatest2 : dot(first, from_a_dy) / greatest;
  float norm3 = length(from_a);
  float greatest3 = max(norm3, 1e-20);
  float gap = distance(uv, c);
  vec2 difference = uv - c;
  float greatest4 = max(gap, 1e-20);
  float least2 = min(norm3, gap);
  bool test2 = gap < norm3;
  float choice3 = test2 ? dot(difference, uv_dx) / greatest4 : dot(from_a, from_a_dx) / greatest3;
  float choice4 = test2 ? dot(difference, uv_dy) / greatest4 : dot(from_a, from_a_dy) / greatest3;
  float from_curve = min(least, least2);
  bool test3 = least2 < least;
  result_dx = test3 ? choice3 : choice;
  result_dy = test3 ? choice4 : choice2;
  return from_curve;
}

// sdf_line (shapes/sdf_line.glsl)
float glyphs_sdf_line(vec2 uv, vec2 a, vec2 b, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - a;
  float line_length = distance(a, b);
  vec2 along = line_length > 0.0 ? (b - a) / line_length : vec2(1.0, 0.0);
  float place = dot(p, along);
  float place_dx = dot(uv_dx, along);
  float place_dy = dot(uv_dy, along);
  float side = p.x * along.y - p.y * along.x;
  float side_dx = uv_dx.x * along.y - uv_dx.y * along.x;
  float side_dy = uv_dy.x * along.y - uv_dy.y * along.x;
  bool test = place < 0.0;
  bool test2 = line_length < place;
  float beyond = place - clamp(place, 0.0, line_length);
  float beyond_dx = place_dx - (test ? 0.0 : test2 ? 0.0 : place_dx);
  float beyond_dy = place_dy - (test ? 0.0 : test2 ? 0.0 : place_dy);
  float beside_slope = side < 0.0 ? -1.0 : 1.0;
  float beside = side * beside_slope;
  float beside_dx = side_dx * beside_slope;
  float beside_dy = side_dy * beside_slope;
  if (beyond != 0.0) {
    vec2 point = vec2(beyond, side);
    beside = length(point);
    float greatest = max(beside, 1e-20);
    beside_dx = dot(point, vec2(beyond_dx, side_dx)) / greatest;
    beside_dy = dot(point, vec2(beyond_dy, side_dy)) / greatest;
  }
  result_dx = beside_dx;
  result_dy = beside_dy;
  return beside;
}

// from_box, of sdf_path (shapes/sdf_path.glsl)
float glyphs_from_box(vec2 a, vec2 b, vec2 c) {
  return length(max(max(min(min(a, b), c), -max(max(a, b), c)), 0.0));
}

// curve_crossing, of sdf_path (shapes/sdf_path.glsl)
int glyphs_curve_crossing(vec2 a, vec2 b, vec2 c) {
  vec2 bend = a - 2.0 * b + c;
  vec2 lead = a - b;
  bool goes_down;
  if (a.y > 0.0) {
    goes_down = c.y <= 0.0 || b.y <= 0.0;
  } else {
    goes_down = c.y <= 0.0 && b.y > 0.0;
  }
  bool goes_up;
  if (c.y > 0.0) {
    goes_up = a.y <= 0.0 || b.y <= 0.0;
  } else {
    goes_up = a.y <= 0.0 && b.y > 0.0;
  }
  float under_root = lead.y * lead.y - bend.y * a.y;
  bool meets = goes_down != goes_up || under_root > 0.0;
  float root = sqrt(max(under_root, 0.0));
  bool test = lead.y < 0.0;
  float sum = test ? lead.y - root : lead.y + root;
  float by_start = clamp(a.y / (sum == 0.0 ? 1e-20 : sum), 0.0, 1.0);
  float by_bend = clamp(sum / (bend.y == 0.0 ? 1e-20 : bend.y), 0.0, 1.0);
  vec2 t = test ? vec2(by_bend, by_start) : vec2(by_start, by_bend);
  vec2 x = (bend.x * t - 2.0 * lead.x) * t + a.x;
  int down = goes_down && meets && x.x > 0.0 ? 1 : 0;
  int up = goes_up && meets && x.y > 0.0 ? 1 : 0;
  return up - down;
}

// sdf_quadratic_curve (shapes/sdf_quadratic_curve.glsl)
float glyphs_sdf_quadratic_curve2(vec2 uv, vec2 a, vec2 b, vec2 c) {
  vec2 from_a = a - uv;
  vec2 lead = b - a;
  vec2 bend = a - 2.0 * b + c;
  float bend2 = dot(bend, bend);
  float projection = dot(lead, bend);
  float inflection = clamp(-projection / max(bend2, 1e-20), 0.0, 1.0);
  vec2 low = vec2(0.0, inflection);
  vec2 high = vec2(inflection, 1.0);
  float k0 = dot(from_a, lead);
  float k1 = 2.0 * dot(lead, lead) + dot(from_a, bend);
  float k2 = 3.0 * projection;
  vec2 t = vec2(0.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    vec2 product = ((bend2 * t + k2) * t + k1) * t;
    vec2 slope = product + k0;
    vec2 rise = (3.0 * bend2 * t + 2.0 * k2) * t + k1;
    t = clamp(t - slope / max(rise, 1e-20), low, high);
  }
  t = floor(t * 16777216.0 + 0.5) * 5.9604645e-8;
  vec2 product = 2.0 * lead;
  vec2 first = (bend * t.x + product) * t.x + from_a;
  vec2 last = (bend * t.y + product) * t.y + from_a;
  float from_curve = min(min(length(first), length(last)), min(length(from_a), distance(uv, c)));
  return from_curve;
}

// sdf_line (shapes/sdf_line.glsl)
float glyphs_sdf_line2(vec2 uv, vec2 a, vec2 b) {
  vec2 p = uv - a;
  float line_length = distance(a, b);
  vec2 along = line_length > 0.0 ? (b - a) / line_length : vec2(1.0, 0.0);
  float place = dot(p, along);
  float side = p.x * along.y - p.y * along.x;
  float beyond = place - clamp(place, 0.0, line_length);
  float beside = side * (side < 0.0 ? -1.0 : 1.0);
  return beyond != 0.0 ? length(vec2(beyond, side)) : beside;
}

// line_crossing, of sdf_path (shapes/sdf_path.glsl)
int glyphs_line_crossing(vec2 a, vec2 b) {
  float side = a.x * b.y - a.y * b.x;
  int up = a.y <= 0.0 && b.y > 0.0 && side > 0.0 ? 1 : 0;
  int down = a.y > 0.0 && b.y <= 0.0 && side < 0.0 ? 1 : 0;
  return up - down;
}

// sdf_path (shapes/sdf_path.glsl)
float glyphs_sdf_path_word(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  int first = 0;
  int nearest = 0;
  int behind_nearest = 0;
  float least = 1e30;
  int winding = 0;
  for (int i = 0; i < 64; ++i) {
    vec3 item = glyphs_points[i];
    first = i == 0 || item.z > 1.5 ? i : first;
    int after = min(i + 1, 63);
    bool ends = after == i || after == 0 || glyphs_points[clamp(after, 0, 63)].z > 1.5;
    int next = ends ? first : after;
    vec2 point = item.xy - uv;
    int nearest2, behind_nearest2, winding2;
    float least2;
    if (glyphs_is_control_word(i)) {
      vec2 a = glyphs_curve_end_word(i, i - 1);
      vec2 c = glyphs_curve_end_word(i, next);
      vec2 difference = a - uv;
      vec2 difference2 = c - uv;
      nearest2 = nearest;
      behind_nearest2 = behind_nearest;
      least2 = least;
      if (glyphs_from_box(difference, point, difference2) < least) {
        float found = glyphs_sdf_quadratic_curve2(uv, a, item.xy, c);
        bool test = found < least;
        nearest2 = test ? i : nearest;
        behind_nearest2 = test ? next : behind_nearest;
        least2 = min(found, least);
      }
      winding2 = winding + glyphs_curve_crossing(difference, point, difference2);
    } else {
      if (!glyphs_is_control_word(next)) {
        vec2 point2 = glyphs_points[clamp(next, 0, 63)].xy;
        vec2 end = point2 - uv;
        float found = glyphs_sdf_line2(uv, item.xy, point2);
        bool test = found < least;
        nearest = test ? i : nearest;
        behind_nearest = test ? next : behind_nearest;
        least = min(found, least);
        winding += glyphs_line_crossing(point, end);
      }
      nearest2 = nearest;
      behind_nearest2 = behind_nearest;
      least2 = least;
      winding2 = winding;
    }
    nearest = nearest2;
    behind_nearest = behind_nearest2;
    least = least2;
    winding = winding2;
  }
  float outline, outline_dx, outline_dy;
  if (glyphs_is_control_word(nearest)) {
    vec2 a = glyphs_curve_end_word(nearest, nearest - 1);
    vec2 c = glyphs_curve_end_word(nearest, behind_nearest);
    outline = glyphs_sdf_quadratic_curve(uv, a, glyphs_points[clamp(nearest, 0, 63)].xy, c, uv_dx,
        uv_dy, outline_dx, outline_dy);
  } else {
    outline = glyphs_sdf_line(uv, glyphs_points[clamp(nearest, 0, 63)].xy,
        glyphs_points[clamp(behind_nearest, 0, 63)].xy, uv_dx, uv_dy, outline_dx, outline_dy);
  }
  bool inside = (winding & 1) != 0;
  result_dx = inside ? -outline_dx : outline_dx;
  result_dy = inside ? -outline_dy : outline_dy;
  return inside ? -outline : outline;
}

// is_control_digit, of sdf_path (shapes/sdf_path.glsl)
bool glyphs_is_control_digit(int i) {
  float value = glyphs_points2[clamp(i, 0, 31)].z;
  return i > 0 && value > 0.5 && value < 1.5;
}

// curve_end_digit, of sdf_path (shapes/sdf_path.glsl)
vec2 glyphs_curve_end_digit(int control, int other) {
  vec2 point = glyphs_points2[clamp(other, 0, 31)].xy;
  vec2 middle = 0.5 * (glyphs_points2[clamp(control, 0, 31)].xy + point);
  return glyphs_is_control_digit(other) ? middle : point;
}

// sdf_path (shapes/sdf_path.glsl)
float glyphs_sdf_path_digit(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  int first = 0;
  int nearest = 0;
  int behind_nearest = 0;
  float least = 1e30;
  int winding = 0;
  for (int i = 0; i < 32; ++i) {
    vec3 item = glyphs_points2[i];
    first = i == 0 || item.z > 1.5 ? i : first;
    int after = min(i + 1, 31);
    bool ends = after == i || after == 0 || glyphs_points2[clamp(after, 0, 31)].z > 1.5;
    int next = ends ? first : after;
    vec2 point = item.xy - uv;
    int nearest2, behind_nearest2, winding2;
    float least2;
    if (glyphs_is_control_digit(i)) {
      vec2 a = glyphs_curve_end_digit(i, i - 1);
      vec2 c = glyphs_curve_end_digit(i, next);
      vec2 difference = a - uv;
      vec2 difference2 = c - uv;
      nearest2 = nearest;
      behind_nearest2 = behind_nearest;
      least2 = least;
      if (glyphs_from_box(difference, point, difference2) < least) {
        float found = glyphs_sdf_quadratic_curve2(uv, a, item.xy, c);
        bool test = found < least;
        nearest2 = test ? i : nearest;
        behind_nearest2 = test ? next : behind_nearest;
        least2 = min(found, least);
      }
      winding2 = winding + glyphs_curve_crossing(difference, point, difference2);
    } else {
      if (!glyphs_is_control_digit(next)) {
        vec2 point2 = glyphs_points2[clamp(next, 0, 31)].xy;
        vec2 end = point2 - uv;
        float found = glyphs_sdf_line2(uv, item.xy, point2);
        bool test = found < least;
        nearest = test ? i : nearest;
        behind_nearest = test ? next : behind_nearest;
        least = min(found, least);
        winding += glyphs_line_crossing(point, end);
      }
      nearest2 = nearest;
      behind_nearest2 = behind_nearest;
      least2 = least;
      winding2 = winding;
    }
    nearest = nearest2;
    behind_nearest = behind_nearest2;
    least = least2;
    winding = winding2;
  }
  float outline, outline_dx, outline_dy;
  if (glyphs_is_control_digit(nearest)) {
    vec2 a = glyphs_curve_end_digit(nearest, nearest - 1);
    vec2 c = glyphs_curve_end_digit(nearest, behind_nearest);
    outline = glyphs_sdf_quadratic_curve(uv, a, glyphs_points2[clamp(nearest, 0, 31)].xy, c, uv_dx,
        uv_dy, outline_dx, outline_dy);
  } else {
    outline = glyphs_sdf_line(uv, glyphs_points2[clamp(nearest, 0, 31)].xy,
        glyphs_points2[clamp(behind_nearest, 0, 31)].xy, uv_dx, uv_dy, outline_dx, outline_dy);
  }
  bool inside = (winding & 1) != 0;
  result_dx = inside ? -outline_dx : outline_dx;
  result_dy = inside ? -outline_dy : outline_dy;
  return inside ? -outline : outline;
}

// nearness_arrow, of sdf_polygon (shapes/sdf_polygon.glsl)
float glyphs_nearness_arrow(vec2 a, vec2 b) {
  vec2 edge = b - a;
  vec2 product = edge * clamp(-dot(a, edge) / max(dot(edge, edge), 1e-20), 0.0, 1.0);
  vec2 to_nearest = a + product;
  return dot(to_nearest, to_nearest);
}

// crossing, of sdf_polygon (shapes/sdf_polygon.glsl)
int glyphs_crossing(vec2 a, vec2 b) {
  float side = a.x * b.y - a.y * b.x;
  int up = a.y <= 0.0 && b.y > 0.0 && side > 0.0 ? 1 : 0;
  int down = a.y > 0.0 && b.y <= 0.0 && side < 0.0 ? 1 : 0;
  return up - down;
}

// sdf_polygon (shapes/sdf_polygon.glsl)
float glyphs_sdf_polygon(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  int nearest = 0;
  float least = 1e30;
  int winding = 0;
  for (int i = 0; i < 8; ++i) {
    vec2 a = glyphs_points3[i] - uv;
    int sum = i + 1;
    vec2 b = glyphs_points3[clamp(sum < 8 ? sum : 0, 0, 7)] - uv;
    float found = glyphs_nearness_arrow(a, b);
    nearest = found < least ? i : nearest;
    least = min(found, least);
    winding += glyphs_crossing(a, b);
  }
  int sum = nearest + 1;
  int next = sum < 8 ? sum : 0;
  float outline_dx, outline_dy;
  float outline = glyphs_sdf_line(uv, glyphs_points3[clamp(nearest, 0, 7)],
      glyphs_points3[clamp(next, 0, 7)], uv_dx, uv_dy, outline_dx, outline_dy);
  bool inside = (winding & 1) != 0;
  result_dx = inside ? -outline_dx : outline_dx;
  result_dy = inside ? -outline_dy : outline_dy;
  return inside ? -outline : outline;
}

// sdf_fill (shapes/sdf_fill.glsl)
float glyphs_sdf_fill_face(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// sdf_stroke (shapes/sdf_stroke.glsl)
float glyphs_sdf_stroke_around(float shape, float width, float shape_dx, float shape_dy) {
  float pixel = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float center = shape - 0.03;
  float product = 0.5 * pixel;
  float low = max(center - product, -0.5 * width);
  float high = min(center + product, 0.5 * width);
  return clamp((high - low) / pixel, 0.0, 1.0);
}

// sdf_fill (shapes/sdf_fill.glsl)
float glyphs_sdf_fill_shade(float shape, float shape_dx, float shape_dy) {
  float width = 0.14 + max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// is_control_flourish, of sdf_path (shapes/sdf_path.glsl)
bool glyphs_is_control_flourish(int i) {
  float value = glyphs_points4[clamp(i, 0, 9)].z;
  return i > 0 && value > 0.5 && value < 1.5;
}

// curve_end_flourish, of sdf_path (shapes/sdf_path.glsl)
vec2 glyphs_curve_end_flourish(int control, int other) {
  vec2 point = glyphs_points4[clamp(other, 0, 9)].xy;
  vec2 middle = 0.5 * (glyphs_points4[clamp(control, 0, 9)].xy + point);
  return glyphs_is_control_flourish(other) ? middle : point;
}

// sdf_path (shapes/sdf_path.glsl)
float glyphs_sdf_path_flourish(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  int first = 0;
  int nearest = 0;
  int behind_nearest = 0;
  float least = 1e30;
  for (int i = 0; i < 10; ++i) {
    vec3 item = glyphs_points4[i];
    first = i == 0 || item.z > 1.5 ? i : first;
    int after = min(i + 1, 9);
    bool ends = after == i || after == 0 || glyphs_points4[clamp(after, 0, 9)].z > 1.5;
    int next = ends ? first : after;
    int nearest2 = nearest;
    int behind_nearest2 = behind_nearest;
    float least2 = least;
    if (!ends) {
      vec2 point = item.xy - uv;
      if (glyphs_is_control_flourish(i)) {
        vec2 a = glyphs_curve_end_flourish(i, i - 1);
        vec2 c = glyphs_curve_end_flourish(i, next);
        nearest2 = nearest;
        behind_nearest2 = behind_nearest;
        least2 = least;
        if (glyphs_from_box(a - uv, point, c - uv) < least) {
          float found = glyphs_sdf_quadratic_curve2(uv, a, item.xy, c);
          bool test = found < least;
          nearest2 = test ? i : nearest;
          behind_nearest2 = test ? next : behind_nearest;
          least2 = min(found, least);
        }
      } else {
        if (!glyphs_is_control_flourish(next)) {
          float found = glyphs_sdf_line2(uv, item.xy, glyphs_points4[clamp(next, 0, 9)].xy);
          bool test = found < least;
          nearest = test ? i : nearest;
          behind_nearest = test ? next : behind_nearest;
          least = min(found, least);
        }
        nearest2 = nearest;
        behind_nearest2 = behind_nearest;
        least2 = least;
      }
    }
    nearest = nearest2;
    behind_nearest = behind_nearest2;
    least = least2;
  }
  float outline, outline_dx, outline_dy;
  if (glyphs_is_control_flourish(nearest)) {
    vec2 a = glyphs_curve_end_flourish(nearest, nearest - 1);
    vec2 c = glyphs_curve_end_flourish(nearest, behind_nearest);
    outline = glyphs_sdf_quadratic_curve(uv, a, glyphs_points4[clamp(nearest, 0, 9)].xy, c, uv_dx,
        uv_dy, outline_dx, outline_dy);
  } else {
    outline = glyphs_sdf_line(uv, glyphs_points4[clamp(nearest, 0, 9)].xy,
        glyphs_points4[clamp(behind_nearest, 0, 9)].xy, uv_dx, uv_dy, outline_dx, outline_dy);
  }
  result_dx = outline_dx;
  result_dy = outline_dy;
  return outline;
}

// sdf_stroke (shapes/sdf_stroke.glsl)
float glyphs_sdf_stroke_flourish_line(float shape, float width, float shape_dx, float shape_dy) {
  float pixel = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float product = 0.5 * pixel;
  float low = max(shape - product, -0.5 * width);
  float high = min(shape + product, 0.5 * width);
  return clamp((high - low) / pixel, 0.0, 1.0);
}

// nearness_frame, of sdf_polyline (shapes/sdf_polyline.glsl)
float glyphs_nearness_frame(vec2 a, vec2 b) {
  vec2 edge = b - a;
  vec2 product = edge * clamp(-dot(a, edge) / max(dot(edge, edge), 1e-20), 0.0, 1.0);
  vec2 to_nearest = a + product;
  return dot(to_nearest, to_nearest);
}

// sdf_polyline (shapes/sdf_polyline.glsl)
float glyphs_sdf_polyline(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  int nearest = 0;
  float least = 1e30;
  for (int i = 0; i < 8; ++i) {
    float found = glyphs_nearness_frame(glyphs_points5[i] - uv, glyphs_points5[i + 1] - uv);
    nearest = found < least ? i : nearest;
    least = min(found, least);
  }
  float result_dx2, result_dy2;
  float sdf_line_value = glyphs_sdf_line(uv, glyphs_points5[clamp(nearest, 0, 8)],
      glyphs_points5[clamp(nearest + 1, 0, 8)], uv_dx, uv_dy, result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return sdf_line_value;
}

// hash (random/hash.glsl)
uvec2 glyphs_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 glyphs_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float glyphs_value_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 6.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = glyphs_hash(uvec2(cell.y, cell.y + 1u) + 2131687100u);
  uvec4 bits = glyphs_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 6.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

void glyphs(vec2 uv, out vec4 color, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // page_size: multiply (math/multiply.glsl)
  vec2 page_size = uv * 2.04;
  // page: add (math/add.glsl)
  vec2 page = page_size - 0.07;
  // word: sdf_path (shapes/sdf_path.glsl)
  vec2 page_dx = uv_dx * 2.04;
  vec2 page_dy = uv_dy * 2.04;
  float word_dx, word_dy;
  float word = glyphs_sdf_path_word(page, page_dx, page_dy, word_dx, word_dy);
  // digit: sdf_path (shapes/sdf_path.glsl)
  float digit_dx, digit_dy;
  float digit = glyphs_sdf_path_digit(page, page_dx, page_dy, digit_dx, digit_dy);
  // arrow: sdf_polygon (shapes/sdf_polygon.glsl)
  float arrow_dx, arrow_dy;
  float arrow = glyphs_sdf_polygon(page, page_dx, page_dy, arrow_dx, arrow_dy);
  // letters: sdf_union (shapes/sdf_union.glsl)
  float letters = min(word, digit);
  bool test = digit < word;
  float letters_dx = test ? digit_dx : word_dx;
  float letters_dy = test ? digit_dy : word_dy;
  // raised: sdf_union (shapes/sdf_union.glsl)
  float raised = min(letters, arrow);
  bool test2 = arrow < letters;
  float raised_dx = test2 ? arrow_dx : letters_dx;
  float raised_dy = test2 ? arrow_dy : letters_dy;
  // face: sdf_fill (shapes/sdf_fill.glsl)
  float face = glyphs_sdf_fill_face(raised, raised_dx, raised_dy);
  // around: sdf_stroke (shapes/sdf_stroke.glsl)
  float around = glyphs_sdf_stroke_around(raised, 0.012, raised_dx, raised_dy);
  // shade: sdf_fill (shapes/sdf_fill.glsl)
  float shade = glyphs_sdf_fill_shade(raised, raised_dx, raised_dy);
  // flourish: sdf_path (shapes/sdf_path.glsl)
  float flourish_dx, flourish_dy;
  float flourish = glyphs_sdf_path_flourish(page, page_dx, page_dy, flourish_dx, flourish_dy);
  // flourish_line: sdf_stroke (shapes/sdf_stroke.glsl)
  float flourish_line = glyphs_sdf_stroke_flourish_line(flourish, 0.022, flourish_dx, flourish_dy);
  // frame: sdf_polyline (shapes/sdf_polyline.glsl)
  float frame_dx, frame_dy;
  float frame = glyphs_sdf_polyline(page, page_dx, page_dy, frame_dx, frame_dy);
  // frame_line: sdf_stroke (shapes/sdf_stroke.glsl)
  float frame_line = glyphs_sdf_stroke_flourish_line(frame, 0.02, frame_dx, frame_dy);
  // frame_hair: sdf_stroke (shapes/sdf_stroke.glsl)
  float frame_hair = glyphs_sdf_stroke_around(frame, 0.005, frame_dx, frame_dy);
  // frame_lines: maximum (math/maximum.glsl)
  float frame_lines = max(frame_line, frame_hair);
  // thin: maximum (math/maximum.glsl)
  float thin = max(around, flourish_line);
  // lines: maximum (math/maximum.glsl)
  float lines = max(thin, frame_lines);
  // grain_place: multiply (math/multiply.glsl)
  vec2 grain_place = uv * vec2(1.0, 14.0);
  // grain: value_noise (noise/value_noise.glsl)
  vec2 grain_place_dx = uv_dx * vec2(1.0, 14.0);
  vec2 grain_place_dy = uv_dy * vec2(1.0, 14.0);
  float grain = glyphs_value_noise(grain_place, grain_place_dx, grain_place_dy);
  // wood: remap (math/remap.glsl)
  float wood = mix(0.7, 1.25, grain);
  // painted: multiply (math/multiply.glsl)
  vec3 painted = board * wood;
  // shadow: remap (math/remap.glsl)
  float shadow = mix(1.0, 0.3, shade);
  // shaded: multiply (math/multiply.glsl)
  vec3 shaded = painted * shadow;
  // lined: lerp (math/lerp.glsl)
  vec3 lined = mix(shaded, gold, lines);
  // inward: negate (math/negate.glsl)
  float inward = -raised;
  // profile: divide (math/divide.glsl)
  float profile = bevel == 0.0 ? 0.0 : inward / bevel;
  // height: clamp_range (math/clamp_range.glsl)
  float height2 = clamp(profile, 0.0, 1.0);
  // worn: remap (math/remap.glsl)
  float worn = mix(0.93, 1.05, grain);
  // edge_color: multiply (math/multiply.glsl)
  vec3 edge_color = gold * 0.8;
  // plane_color: multiply (math/multiply.glsl)
  vec3 plane_color = cream * worn;
  // letter_color: lerp (math/lerp.glsl)
  vec3 letter_color = mix(edge_color, plane_color, height2);
  // color: lerp (math/lerp.glsl)
  vec3 color2 = mix(lined, letter_color, face);
  // finished: rgba (channels/rgba.glsl)
  vec4 finished = vec4(color2, 1.0);
  // roughness: lerp (math/lerp.glsl)
  float roughness2 = mix(0.6, 0.35, face);
  color = finished;
  height = height2;
  roughness = roughness2;
}
