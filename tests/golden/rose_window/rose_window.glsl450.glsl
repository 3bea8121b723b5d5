// rose_window: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float daylight;  // default 0.85

// Types
struct rose_window_Tile {
  vec2 local;
  uint seed;
};
struct rose_window_Look2 {
  ivec2 corner;
  vec2 place;
};
struct rose_window_Near2 {
  float key;
  ivec2 offset;
  uint bits;
};
struct rose_window_Edge2 {
  float border;
  vec2 other;
};

// Constants
const float rose_window_stops[5] = float[5](0.1, 0.26, 0.45, 0.75, 1.0);
const vec4 rose_window_colors[5] = vec4[5](vec4(0.95, 0.62, 0.1, 1.0), vec4(0.75, 0.06, 0.03, 1.0),
    vec4(0.06, 0.08, 0.5, 1.0), vec4(0.02, 0.2, 0.6, 1.0), vec4(0.3, 0.03, 0.3, 1.0));
const float rose_window_stops2[3] = float[3](0.35, 0.5, 0.7);
const vec4 rose_window_colors2[3] = vec4[3](vec4(0.9, 0.5, 0.05, 1.0), vec4(0.7, 0.03, 0.03, 1.0),
    vec4(0.45, 0.01, 0.08, 1.0));

// polar (coordinates/polar.glsl)
vec2 rose_window_polar(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  vec2 p = uv - 0.5;
  bool test = p.x == 0.0;
  float choice = test ? 1e-20 : p.x;
  float greatest = max(p.y * p.y + choice * choice, 1e-20);
  float turns = atan(p.y, choice) * 0.15915494;
  float turns_dx = (choice * uv_dx.y - p.y * (test ? 0.0 : uv_dx.x)) / greatest * 0.15915494;
  float turns_dy = (choice * uv_dy.y - p.y * (test ? 0.0 : uv_dy.x)) / greatest * 0.15915494;
  float norm = length(p);
  float greatest2 = max(norm, 1e-20);
  result_dx = vec2(turns_dx, dot(p, uv_dx) / greatest2 / 0.46);
  result_dy = vec2(turns_dy, dot(p, uv_dy) / greatest2 / 0.46);
  return vec2(fract(turns), norm / 0.46);
}

// kaleidoscope (coordinates/kaleidoscope.glsl)
vec2 rose_window_kaleidoscope(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx,
    out vec2 result_dy) {
  vec2 p = uv - 0.5;
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x);
  float back = 0.5235988 * floor(turned / 0.5235988 + 0.5);
  float cosine = cos(back);
  float sine = sin(back);
  vec2 toward = vec2(cosine, sine);
  float difference = p.y * cosine - p.x * sine;
  float difference2 = uv_dx.y * cosine - uv_dx.x * sine;
  float difference3 = uv_dy.y * cosine - uv_dy.x * sine;
  vec2 q = vec2(dot(p, toward), difference);
  vec2 q_dx = vec2(dot(uv_dx, toward), difference2);
  vec2 q_dy = vec2(dot(uv_dy, toward), difference3);
  bool test = difference > 0.0;
  result_dx = q_dx - (test ? 0.0 : difference2) * 2.0 * vec2(-0.0, 1.0);
  result_dy = q_dy - (test ? 0.0 : difference3) * 2.0 * vec2(-0.0, 1.0);
  return 0.5 + q - 2.0 * min(difference, 0.0) * vec2(-0.0, 1.0);
}

// sdf_ellipse (shapes/sdf_ellipse.glsl)
float rose_window_sdf_ellipse(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(0.73, 0.5);
  vec2 q_slope = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 q = p * q_slope;
  vec2 q_dx = uv_dx * q_slope;
  vec2 q_dy = uv_dy * q_slope;
  vec2 t = vec2(0.70710677);
  for (int i = 0; i < 8; ++i) {
    vec2 middle = vec2(0.08193751, -0.19279413) * t * t * t;
    vec2 away = q - middle;
    float radius = distance(vec2(0.1, 0.0425) * t, middle);
    vec2 ratio = (middle + radius * away / max(length(away), 1e-20)) / vec2(0.1, 0.0425);
    t = clamp(ratio, 1e-7, 1.0);
    t *= inversesqrt(dot(t, t));
  }
  vec2 nearest = floor(t * 16777216.0 + 0.5) * 5.9604645e-8;
  vec2 unit = normalize(vec2(0.0425, 0.1) * nearest);
  result_dx = dot(q_dx, unit);
  result_dy = dot(q_dy, unit);
  return dot(q - vec2(0.1, 0.0425) * nearest, unit);
}

// sdf_ring (shapes/sdf_ring.glsl)
float rose_window_sdf_ring(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float outward_dx = dot(difference, uv_dx) / greatest;
  float outward_dy = dot(difference, uv_dy) / greatest;
  float outward = norm - 0.115;
  float side = outward < 0.0 ? -1.0 : 1.0;
  result_dx = outward_dx * side;
  result_dy = outward_dy * side;
  return side * outward - 0.0225;
}

// sdf_smooth_union (shapes/sdf_smooth_union.glsl)
float rose_window_sdf_smooth_union(float a, float b, float a_dx, float a_dy, float b_dx, float b_dy,
    out float result_dx, out float result_dy) {
  float sum = 0.5 + 0.5 * (b - a) / 0.03;
  float t = clamp(sum, 0.0, 1.0);
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : (b_dx - a_dx) * 0.5 / 0.03;
  float t_dy = test ? 0.0 : test2 ? 0.0 : (b_dy - a_dy) * 0.5 / 0.03;
  float difference = a - b;
  float difference2 = 1.0 - t;
  float sum2 = 0.03 * difference2 + t * -0.03;
  result_dx = mix(b_dx, a_dx, t) + difference * t_dx - t_dx * sum2;
  result_dy = mix(b_dy, a_dy, t) + difference * t_dy - t_dy * sum2;
  return mix(b, a, t) - 0.03 * t * difference2;
}

// sdf_fill (shapes/sdf_fill.glsl)
float rose_window_sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// cell_hash (indirection/cell_hash.glsl)
uint rose_window_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(460041413u, 705669638u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint rose_window_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// point_of, of voronoi (cellular/voronoi.glsl)
vec2 rose_window_point_of(rose_window_Look2 look, ivec2 offset, out uint bits) {
  uint bits2 = rose_window_cell_hash(look.corner + offset);
  uint hash_value = rose_window_hash(bits2 - 1u);
  vec2 product = 0.85 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  bits = bits2;
  return vec2(offset) + 0.07499999 + product;
}

// visit, of voronoi (cellular/voronoi.glsl)
rose_window_Near2 rose_window_visit(rose_window_Look2 look, ivec2 offset, rose_window_Near2 near) {
  uint bits;
  vec2 point = rose_window_point_of(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  rose_window_Near2 near2 = key < near.key ? rose_window_Near2(key, offset, bits) : near;
  return near2;
}

// nearest, of voronoi (cellular/voronoi.glsl)
rose_window_Near2 rose_window_nearest(rose_window_Look2 look) {
  rose_window_Near2 near = rose_window_Near2(1e9, ivec2(0), 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = rose_window_visit(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = rose_window_visit(look, ivec2(x, y), near);
    }
  }
  return near;
}

// gap_to, of voronoi (cellular/voronoi.glsl)
vec2 rose_window_gap_to(rose_window_Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.425 - 1e-5;
  return max(difference, 0.0);
}

// half_way, of voronoi (cellular/voronoi.glsl)
float rose_window_half_way(rose_window_Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_pieces, of voronoi (cellular/voronoi.glsl)
rose_window_Edge2 rose_window_border_around_pieces(rose_window_Look2 look, rose_window_Near2 near,
    vec2 point) {
  float first = distance(point, look.place);
  rose_window_Edge2 edge = rose_window_Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = rose_window_gap_to(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = rose_window_point_of(look, offset, bits);
        float border = rose_window_half_way(look, point, other);
        edge = border < edge.border ? rose_window_Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_pieces, of voronoi (cellular/voronoi.glsl)
rose_window_Edge2 rose_window_border_around_pieces2(rose_window_Look2 look, rose_window_Near2 near,
    vec2 point, rose_window_Edge2 edge) {
  float first = distance(point, look.place);
  rose_window_Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = rose_window_gap_to(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = rose_window_point_of(look, offset, bits);
        float border = rose_window_half_way(look, point, other);
        edge2 = border < edge2.border ? rose_window_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// half_way, of voronoi (cellular/voronoi.glsl)
float rose_window_half_way2(rose_window_Look2 look, vec2 point, vec2 other, vec2 look_place_dx,
    vec2 look_place_dy, out float result_dx, out float result_dy) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  result_dx = dot(-look_place_dx, product);
  result_dy = dot(-look_place_dy, product);
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_pieces, of voronoi (cellular/voronoi.glsl)
rose_window_Edge2 rose_window_border_around_pieces3(rose_window_Look2 look, rose_window_Near2 near,
    vec2 point, rose_window_Edge2 edge) {
  float first = distance(point, look.place);
  rose_window_Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = rose_window_gap_to(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = rose_window_point_of(look, offset, bits);
        float border = rose_window_half_way(look, point, other);
        edge2 = border < edge2.border ? rose_window_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of, of voronoi (cellular/voronoi.glsl)
float rose_window_border_of(rose_window_Look2 look, rose_window_Near2 near, vec2 point,
    vec2 look_place_dx, vec2 look_place_dy, out float result_dx, out float result_dy) {
  rose_window_Edge2 edge = rose_window_border_around_pieces(look, near, point);
  edge = rose_window_border_around_pieces2(look, near, point, edge);
  if (distance(point, look.place) + 2.0 * edge.border > 1.5) {
    edge = rose_window_border_around_pieces3(look, near, point, edge);
  }
  float result_dx2, result_dy2;
  float half_way_value = rose_window_half_way2(look, point, edge.other, look_place_dx,
      look_place_dy, result_dx2, result_dy2);
  bool test = half_way_value < 0.0;
  result_dx = test ? 0.0 : result_dx2;
  result_dy = test ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void rose_window_voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float border,
    out rose_window_Tile tile, out float border_dx, out float border_dy, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * 26.0;
  vec2 corner = floor(p + 0.5);
  vec2 difference = p - corner;
  rose_window_Look2 look = rose_window_Look2(ivec2(corner), difference);
  vec2 look_place_dx = uv_dx * 26.0;
  vec2 look_place_dy = uv_dy * 26.0;
  rose_window_Near2 near = rose_window_nearest(look);
  uint hash_value = rose_window_hash(near.bits - 1u);
  vec2 product = 0.85 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  vec2 point = vec2(near.offset) + 0.07499999 + product;
  float border_dx2, border_dy2;
  float border2 = rose_window_border_of(look, near, point, look_place_dx, look_place_dy, border_dx2,
      border_dy2);
  border = border2;
  tile = rose_window_Tile(0.5 + (difference - point), near.bits);
  border_dx = border_dx2;
  border_dy = border_dy2;
  tile_local_dx = look_place_dx;
  tile_local_dy = look_place_dy;
}

// joint (tiles/joint.glsl)
float rose_window_joint(float edge, float edge_dx, float edge_dy) {
  float pixel = max(sqrt(edge_dx * edge_dx + edge_dy * edge_dy), 1e-7);
  float product = 0.5 * pixel;
  float low = max(edge - product, -0.045);
  float high = min(edge + product, 0.045);
  float line = max(high - low, 0.0) / pixel;
  float far = clamp(2.0 * pixel - 1.0, 0.0, 1.0);
  line = min(line / (1.0 - 0.5 * min(pixel, 1.0)), 1.0);
  return mix(line, 0.17190003, far);
}

// sdf_stroke (shapes/sdf_stroke.glsl)
float rose_window_sdf_stroke(float shape, float shape_dx, float shape_dy) {
  float pixel = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float product = 0.5 * pixel;
  float low = max(shape - product, -0.003);
  float high = min(shape + product, 0.003);
  return clamp((high - low) / pixel, 0.0, 1.0);
}

// part_mean_rings, of color_ramp (color/color_ramp.glsl)
vec4 rose_window_part_mean_rings(vec4 from, vec4 to, float middle, float reach) {
  float square = reach * reach;
  float product = 6.0 * middle;
  float s = product * (1.0 - middle);
  float b = 3.0 - product;
  float mean = middle * middle * (3.0 - 2.0 * middle) + b * square / 3.0;
  float sum = s * s / 3.0 + square * (b * b * 0.08888889 - 0.8 * s + square * 0.5714286);
  float variance = square * sum;
  vec4 color = mix(from, to, mean);
  vec3 sum2 = color.xyz * color.w + (to.xyz - from.xyz) * ((to.w - from.w) * variance);
  return vec4(sum2, color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 rose_window_color_ramp_rings(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp((0.1 - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.95, 0.62, 0.1, 1.0) * below;
  for (int i = 0; i < 4; ++i) {
    int sum2 = i + 1;
    float item = rose_window_stops[sum2];
    float next = clamp((item - position) / width + 0.5, 0.0, 1.0);
    float item2 = rose_window_stops[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float least = min(0.5 * difference * width * part, 0.5);
    vec4 part_mean_rings_value = rose_window_part_mean_rings(rose_window_colors[i],
        rose_window_colors[sum2], clamp(middle * part, 0.0, 1.0), least);
    below = next;
    sum += difference * part_mean_rings_value;
  }
  sum += (1.0 - below) * vec4(0.3, 0.03, 0.3, 1.0);
  vec3 choice = vec3(0.3, 0.03, 0.3);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// part_mean_petal_tone, of color_ramp (color/color_ramp.glsl)
vec4 rose_window_part_mean_petal_tone(vec4 from, vec4 to, float middle, float reach) {
  float square = reach * reach;
  float variance = square / 3.0;
  vec4 color = mix(from, to, middle);
  vec3 sum = color.xyz * color.w + (to.xyz - from.xyz) * ((to.w - from.w) * variance);
  return vec4(sum, color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 rose_window_color_ramp_petal_tone(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp((0.35 - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.9, 0.5, 0.05, 1.0) * below;
  for (int i = 0; i < 2; ++i) {
    int sum2 = i + 1;
    float item = rose_window_stops2[sum2];
    float next = clamp((item - position) / width + 0.5, 0.0, 1.0);
    float item2 = rose_window_stops2[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float clamped = clamp(middle * part, 0.0, 1.0);
    float least = min(0.5 * difference * width * part, 0.5);
    vec4 part_mean_petal_tone_value = rose_window_part_mean_petal_tone(rose_window_colors2[i],
        rose_window_colors2[sum2], clamped, least);
    below = next;
    sum += difference * part_mean_petal_tone_value;
  }
  sum += (1.0 - below) * vec4(0.45, 0.01, 0.08, 1.0);
  vec3 choice = vec3(0.45, 0.01, 0.08);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// tile_near (tiles/tile_near.glsl)
float rose_window_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 rose_window_random3(uint seed) {
  uint bits = rose_window_hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(rose_window_hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 rose_window_rgb_to_hsv(vec3 color) {
  float value = max(max(color.x, color.y), color.z);
  float range = value - min(min(color.x, color.y), color.z);
  float part = 1.0 / max(range, 1e-20);
  float sector = (color.x - color.y) * part + 4.0;
  float sector2;
  if (color.x == value) {
    sector2 = (color.y - color.z) * part;
  } else {
    if (color.y == value) {
      sector = (color.z - color.x) * part + 2.0;
    }
    sector2 = sector;
  }
  return vec3(fract(sector2 / 6.0), range / max(value, 1e-20), value);
}

// hsv_to_rgb (color/hsv_to_rgb.glsl)
vec3 rose_window_hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 rose_window_hsv_adjust(vec3 color, float hue, float saturation, float value) {
  float top = max(max(color.x, color.y), color.z);
  float range = top - min(min(color.x, color.y), color.z);
  float pull = 1.0;
  if (saturation != 1.0) {
    pull = min(saturation, top / max(range, 1e-20));
  }
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = rose_window_rgb_to_hsv(pulled);
  vec3 turned = rose_window_hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 rose_window_varied(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), rose_window_random3(seed), near);
  vec3 one = rose_window_hsv_adjust(color, mix(-16.0, 16.0, luck.x), mix(0.85, 1.0, luck.y),
      mix(0.55, 1.5, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9870536), one, near);
}

// swirl (coordinates/swirl.glsl)
vec2 rose_window_swirl(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  vec2 p = uv - 0.5;
  float norm = length(p);
  float greatest = max(norm, 1e-20);
  float difference = 1.0 - norm / 0.8;
  float t = max(difference, 0.0);
  bool test = difference < 0.0;
  float t_dx = test ? 0.0 : -(dot(p, uv_dx) / greatest / 0.8);
  float t_dy = test ? 0.0 : -(dot(p, uv_dy) / greatest / 0.8);
  float product = t * t;
  float difference2 = 3.0 - 2.0 * t;
  float turn = -3.4906585 * (product * difference2);
  float turn_slope = -3.4906585 * ((t + t) * difference2 + product * -2.0);
  float c = cos(turn);
  float turn_dx = t_dx * turn_slope;
  float turn_dy = t_dy * turn_slope;
  float s = sin(turn);
  float c_dx = -(turn_dx * s);
  float c_dy = -(turn_dy * s);
  float s_dx = turn_dx * c;
  float s_dy = turn_dy * c;
  float difference3 = c_dx * p.x + c * uv_dx.x - (s_dx * p.y + s * uv_dx.y);
  float difference4 = c_dy * p.x + c * uv_dy.x - (s_dy * p.y + s * uv_dy.y);
  result_dx = vec2(difference3, s_dx * p.x + s * uv_dx.x + (c_dx * p.y + c * uv_dx.y));
  result_dy = vec2(difference4, s_dy * p.x + s * uv_dy.x + (c_dy * p.y + c * uv_dy.y));
  return 0.5 + vec2(c * p.x - s * p.y, s * p.x + c * p.y);
}

// hash (random/hash.glsl)
uvec2 rose_window_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 rose_window_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float rose_window_gradient_noise_streaks(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * vec2(3.0, 9.0);
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * vec2(3.0, 9.0);
  vec2 t_dy = uv_dy * vec2(3.0, 9.0);
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = rose_window_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = rose_window_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = t_dx.x * x + t_dx.y * y;
  vec4 corners_dy = t_dy.x * x + t_dy.y * y;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec2(3.0, 9.0);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float amplitude = 0.9340967 * (1.0 - blur);
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * amplitude;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * amplitude;
  return mix(blend.x, blend.y, fade.y) * amplitude + 0.5;
}

// level, of levels (color/levels.glsl)
float rose_window_level(float value, float value_dx, float value_dy) {
  float t = (value - 0.25) * 2.0;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.0, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// spread_range (math/spread_range.glsl)
float rose_window_spread_range(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(0.5 - value / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - value) / width, 0.0, 1.0);
  float middle = value + 0.5 * width * (below - above);
  return above + (1.0 - below - above) * clamp(middle, 0.0, 1.0);
}

// triangle_wave (math/triangle_wave.glsl)
float rose_window_triangle_wave(float phase, float phase_dx, float phase_dy) {
  float width = max(sqrt(phase_dx * phase_dx + phase_dy * phase_dy), 1e-7);
  float from_top = abs(fract(phase) - 0.5);
  float choice;
  if (width < 0.5) {
    float away = min(from_top, 0.5 - from_top);
    float beyond = max(0.5 * width - away, 0.0);
    float rounded = away + beyond * beyond / width;
    float product = 2.0 * rounded;
    choice = from_top < 0.25 ? 1.0 - product : product;
  } else {
    float product = 0.5 * width;
    float low = fract(phase - product) - 0.5;
    float high = fract(phase + product) - 0.5;
    vec2 place = vec2(low, high);
    vec2 integral = place * (0.5 - abs(place));
    choice = 0.5 + (integral.y - integral.x) / width;
  }
  return choice;
}

// gradient_angular (patterns/gradient_angular.glsl)
float rose_window_gradient_angular(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv - 0.5;
  bool test = p.x == 0.0;
  float choice = test ? 1e-20 : p.x;
  float greatest = max(p.y * p.y + choice * choice, 1e-20);
  float turns = atan(p.y, choice) * 0.15915494;
  float phase = (turns - 0.041666668) * 12.0;
  float phase_dx = (choice * uv_dx.y - p.y * (test ? 0.0 : uv_dx.x)) / greatest * 1.9098592;
  float phase_dy = (choice * uv_dy.y - p.y * (test ? 0.0 : uv_dy.x)) / greatest * 1.9098592;
  return rose_window_triangle_wave(phase, phase_dx, phase_dy);
}

// gradient_noise (noise/gradient_noise.glsl)
float rose_window_gradient_noise_perlin(vec2 uv) {
  vec2 base = floor(uv);
  vec2 t = uv - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = rose_window_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = rose_window_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// turbulence (noise/turbulence.glsl)
float rose_window_turbulence(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 24.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 24.0;
  float width = max(product.x, product.y);
  float weight = 0.516129;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.269;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 4.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float difference = 2.0 * rose_window_gradient_noise_perlin(p * frequency + shift) - 1.0;
      float folded = abs(difference);
      sum += weight * near * (folded - 0.269);
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  return sum;
}

// smooth_step (math/smooth_step.glsl)
float rose_window_smooth_step_bevel(float value) {
  float t = clamp(value / 0.012, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// sdf_ring (shapes/sdf_ring.glsl)
float rose_window_sdf_ring_arch(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float outward_dx = dot(difference, uv_dx) / greatest;
  float outward_dy = dot(difference, uv_dy) / greatest;
  float outward = norm - 0.49;
  float side = outward < 0.0 ? -1.0 : 1.0;
  result_dx = outward_dx * side;
  result_dy = outward_dy * side;
  return side * outward - 0.025;
}

// smooth_step (math/smooth_step.glsl)
float rose_window_smooth_step_joints(float value) {
  float t = clamp((value - 0.004) / 0.015999999, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

vec4 rose_window(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // turn: polar (coordinates/polar.glsl)
  vec2 turn_dx, turn_dy;
  vec2 turn = rose_window_polar(uv, uv_dx, uv_dy, turn_dx, turn_dy);
  // wedge: kaleidoscope (coordinates/kaleidoscope.glsl)
  vec2 wedge_dx, wedge_dy;
  vec2 wedge = rose_window_kaleidoscope(uv, uv_dx, uv_dy, wedge_dx, wedge_dy);
  // petal: sdf_ellipse (shapes/sdf_ellipse.glsl)
  float petal_dx, petal_dy;
  float petal = rose_window_sdf_ellipse(wedge, wedge_dx, wedge_dy, petal_dx, petal_dy);
  // bud: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference = wedge - vec2(0.894, 0.585);
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float bud_dx = dot(difference, wedge_dx) / greatest;
  float bud_dy = dot(difference, wedge_dy) / greatest;
  float bud = norm - 0.038;
  // eye: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference2 = wedge - 0.5;
  float norm2 = length(difference2);
  float greatest2 = max(norm2, 1e-20);
  float eye_dx = dot(difference2, wedge_dx) / greatest2;
  float eye_dy = dot(difference2, wedge_dy) / greatest2;
  float eye = norm2 - 0.075;
  // ring: sdf_ring (shapes/sdf_ring.glsl)
  float ring_dx, ring_dy;
  float ring = rose_window_sdf_ring(wedge, wedge_dx, wedge_dy, ring_dx, ring_dy);
  // openings_1: sdf_union (shapes/sdf_union.glsl)
  float openings_1 = min(petal, bud);
  bool test = bud < petal;
  float openings_1_dx = test ? bud_dx : petal_dx;
  float openings_1_dy = test ? bud_dy : petal_dy;
  // openings_2: sdf_union (shapes/sdf_union.glsl)
  float openings_2 = min(eye, ring);
  bool test2 = ring < eye;
  float openings_2_dx = test2 ? ring_dx : eye_dx;
  float openings_2_dy = test2 ? ring_dy : eye_dy;
  // openings: sdf_union (shapes/sdf_union.glsl)
  float openings = min(openings_1, openings_2);
  bool test3 = openings_2 < openings_1;
  float openings_dx = test3 ? openings_2_dx : openings_1_dx;
  float openings_dy = test3 ? openings_2_dy : openings_1_dy;
  // frame: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference3 = uv - 0.5;
  float norm3 = length(difference3);
  float greatest3 = max(norm3, 1e-20);
  // openings_wide: sdf_round (shapes/sdf_round.glsl)
  float openings_wide = openings - 0.016;
  // between: sdf_smooth_difference (shapes/sdf_smooth_difference.glsl)
  float result_dx, result_dy;
  float sdf_smooth_union_value = rose_window_sdf_smooth_union(0.46 - norm3, openings_wide,
      -(dot(difference3, uv_dx) / greatest3), -(dot(difference3, uv_dy) / greatest3), openings_dx,
      openings_dy, result_dx, result_dy);
  // fields: sdf_round (shapes/sdf_round.glsl)
  float fields = 0.006 - sdf_smooth_union_value;
  // panes: sdf_union (shapes/sdf_union.glsl)
  float panes = min(openings, fields);
  float fields_dx = -result_dx;
  float fields_dy = -result_dy;
  bool test4 = fields < openings;
  float panes_dx = test4 ? fields_dx : openings_dx;
  float panes_dy = test4 ? fields_dy : openings_dy;
  // glass_there: sdf_fill (shapes/sdf_fill.glsl)
  float glass_there = rose_window_sdf_fill(panes, panes_dx, panes_dy);
  // pieces: voronoi (cellular/voronoi.glsl)
  float pieces_border, pieces_border_dx, pieces_border_dy;
  rose_window_Tile pieces_tile;
  vec2 pieces_tile_local_dx, pieces_tile_local_dy;
  rose_window_voronoi(wedge, wedge_dx, wedge_dy, pieces_border, pieces_tile, pieces_border_dx,
      pieces_border_dy, pieces_tile_local_dx, pieces_tile_local_dy);
  // lead_lines: joint (tiles/joint.glsl)
  float lead_lines = rose_window_joint(pieces_border, pieces_border_dx, pieces_border_dy);
  // lead_rims: sdf_stroke (shapes/sdf_stroke.glsl)
  float lead_rims = rose_window_sdf_stroke(panes, panes_dx, panes_dy);
  // lead: maximum (math/maximum.glsl)
  float lead = max(lead_lines, lead_rims);
  // rings: color_ramp (color/color_ramp.glsl)
  vec4 rings = rose_window_color_ramp_rings(turn.y, turn_dx.y, turn_dy.y);
  // in_petal: sdf_fill (shapes/sdf_fill.glsl)
  float in_petal = rose_window_sdf_fill(petal, petal_dx, petal_dy);
  // in_bud: sdf_fill (shapes/sdf_fill.glsl)
  float in_bud = rose_window_sdf_fill(bud, bud_dx, bud_dy);
  // petal_tone: color_ramp (color/color_ramp.glsl)
  vec4 petal_tone = rose_window_color_ramp_petal_tone(turn.y, turn_dx.y, turn_dy.y);
  // with_petals: lerp (math/lerp.glsl)
  vec4 with_petals = mix(rings, petal_tone, in_petal);
  // dyed: lerp (math/lerp.glsl)
  vec4 dyed = mix(with_petals, vec4(0.03, 0.42, 0.16, 1.0), in_bud);
  // own: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 varied_value = rose_window_varied(pieces_tile.seed,
      rose_window_tile_near(pieces_tile_local_dx, pieces_tile_local_dy), dyed.xyz);
  // stirred: swirl (coordinates/swirl.glsl)
  vec2 stirred_dx, stirred_dy;
  vec2 stirred = rose_window_swirl(pieces_tile.local, pieces_tile_local_dx, pieces_tile_local_dy,
      stirred_dx, stirred_dy);
  // streaks: gradient_noise (noise/gradient_noise.glsl)
  float streaks_dx, streaks_dy;
  float streaks = rose_window_gradient_noise_streaks(stirred, stirred_dx, stirred_dy, streaks_dx,
      streaks_dy);
  // streak_tone: levels (color/levels.glsl)
  float streak_tone = mix(0.75, 1.2, rose_window_level(streaks, streaks_dx, streaks_dy));
  // day: gradient_radial (patterns/gradient_radial.glsl)
  vec2 difference4 = uv - vec2(0.56, 0.62);
  float norm4 = length(difference4);
  float greatest4 = max(norm4, 1e-20);
  float ratio = dot(difference4, uv_dx) / greatest4 / 0.75;
  float day = rose_window_spread_range(norm4 / 0.75, ratio,
      dot(difference4, uv_dy) / greatest4 / 0.75);
  // day_tone: remap (math/remap.glsl)
  float day_tone = mix(1.35, 0.6, day);
  // shine: multiply (math/multiply.glsl)
  float shine = streak_tone * day_tone;
  // behind: multiply (math/multiply.glsl)
  float behind = shine * daylight;
  // bright: brightness_contrast (color/brightness_contrast.glsl)
  vec4 bright = vec4(varied_value * behind, dyed.w);
  // glazed: lerp (math/lerp.glsl)
  vec4 glazed = mix(bright, vec4(0.006, 0.006, 0.008, 1.0), lead);
  // spokes: gradient_angular (patterns/gradient_angular.glsl)
  float spokes = rose_window_gradient_angular(uv, uv_dx, uv_dy);
  // grit: turbulence (noise/turbulence.glsl)
  float grit = rose_window_turbulence(uv, uv_dx, uv_dy);
  // grit_tone: remap (math/remap.glsl)
  float grit_tone = mix(0.75, 1.25, grit);
  // bevel: smooth_step (math/smooth_step.glsl)
  float bevel = rose_window_smooth_step_bevel(panes);
  // bevel_tone: remap (math/remap.glsl)
  float bevel_tone = mix(0.35, 1.0, bevel);
  // arch: sdf_ring (shapes/sdf_ring.glsl)
  float arch_dx, arch_dy;
  float arch = rose_window_sdf_ring_arch(uv, uv_dx, uv_dy, arch_dx, arch_dy);
  // arch_there: sdf_fill (shapes/sdf_fill.glsl)
  float arch_there = rose_window_sdf_fill(arch, arch_dx, arch_dy);
  // joints: smooth_step (math/smooth_step.glsl)
  float joints = rose_window_smooth_step_joints(spokes);
  // joint_tone: lerp (math/lerp.glsl)
  float joint_tone = mix(1.0, joints, arch_there);
  // stone_light: multiply (math/multiply.glsl)
  float stone_light = grit_tone * bevel_tone;
  // stone_tone: multiply (math/multiply.glsl)
  float stone_tone = stone_light * joint_tone;
  // stone: multiply (math/multiply.glsl)
  vec3 stone = vec3(0.075, 0.07, 0.062) * stone_tone;
  // stone_color: rgba (channels/rgba.glsl)
  vec4 stone_color = vec4(stone, 1.0);
  // seen: lerp (math/lerp.glsl)
  vec4 seen = mix(stone_color, glazed, glass_there);
  return seen;
}
