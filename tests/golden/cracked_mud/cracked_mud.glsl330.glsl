// cracked_mud: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float width;  // default 0.09

// Types
struct cracked_mud_Tile {
  uint seed;
};
struct cracked_mud_Look2 {
  ivec2 corner;
  vec2 place;
};
struct cracked_mud_Near2 {
  float key;
  ivec2 offset;
  uint bits;
};
struct cracked_mud_Edge2 {
  float border;
  vec2 other;
};

// Constants
const vec2 cracked_mud_points[5] = vec2[5](vec2(0.0, 0.2), vec2(0.045, 0.7), vec2(0.1, 1.0),
    vec2(0.2, 0.86), vec2(0.45, 0.55));
const float cracked_mud_stops[3] = float[3](0.3, 0.5, 0.68);
const vec4 cracked_mud_colors[3] = vec4[3](vec4(0.24, 0.15, 0.09, 1.0), vec4(0.4, 0.27, 0.17, 1.0),
    vec4(0.52, 0.42, 0.31, 1.0));
const vec2 cracked_mud_points2[3] = vec2[3](vec2(0.0, 0.82), vec2(0.06, 0.98), vec2(0.2, 1.0));

// hash (random/hash.glsl)
uvec2 cracked_mud_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 cracked_mud_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float cracked_mud_gradient_noise_coarse(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 18.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * 18.0;
  vec2 t_dy = uv_dy * 18.0;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = cracked_mud_hash(uvec2(cell.y, cell.y + 1u) + 2120684060u);
  uvec4 hash_value = cracked_mud_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = t_dx.x * x + t_dx.y * y;
  vec4 corners_dy = t_dy.x * x + t_dy.y * y;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 18.0;
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

// domain_warp (noise/domain_warp.glsl)
vec2 cracked_mud_domain_warp(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx,
    out vec2 result_dy) {
  vec2 place = uv;
  vec2 place_dx = uv_dx;
  vec2 place_dy = uv_dy;
  for (int i = 0; i < 2; ++i) {
    float result_dx2, result_dy2;
    float gradient_noise_coarse_value = cracked_mud_gradient_noise_coarse(place, place_dx, place_dy,
        result_dx2, result_dy2);
    float result_dx3, result_dy3;
    float gradient_noise_coarse_value2 = cracked_mud_gradient_noise_coarse(place + 37.7, place_dx,
        place_dy, result_dx3, result_dy3);
    place = uv + 0.025 * (2.0 * vec2(gradient_noise_coarse_value, gradient_noise_coarse_value2)
        - 1.0);
    place_dx = uv_dx + vec2(result_dx2, result_dx3) * 0.05;
    place_dy = uv_dy + vec2(result_dy2, result_dy3) * 0.05;
  }
  result_dx = place_dx;
  result_dy = place_dy;
  return place;
}

// hash (random/hash.glsl)
uint cracked_mud_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// cell_hash (indirection/cell_hash.glsl)
uint cracked_mud_cell_hash(ivec2 cell, int seed) {
  uint first = cracked_mud_hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(first, cracked_mud_hash(first));
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// point_of_plates, of voronoi (cellular/voronoi.glsl)
vec2 cracked_mud_point_of_plates(cracked_mud_Look2 look, ivec2 offset, out uint bits) {
  uint bits2 = cracked_mud_cell_hash(look.corner + offset, 11);
  uint hash_value = cracked_mud_hash(bits2 - 1u);
  vec2 product = 0.9 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  bits = bits2;
  return vec2(offset) + 0.050000012 + product;
}

// visit_plates, of voronoi (cellular/voronoi.glsl)
cracked_mud_Near2 cracked_mud_visit_plates(cracked_mud_Look2 look, ivec2 offset,
    cracked_mud_Near2 near) {
  uint bits;
  vec2 point = cracked_mud_point_of_plates(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  cracked_mud_Near2 near2 = key < near.key ? cracked_mud_Near2(key, offset, bits) : near;
  return near2;
}

// nearest_plates, of voronoi (cellular/voronoi.glsl)
cracked_mud_Near2 cracked_mud_nearest_plates(cracked_mud_Look2 look) {
  cracked_mud_Near2 near = cracked_mud_Near2(1e9, ivec2(0), 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = cracked_mud_visit_plates(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = cracked_mud_visit_plates(look, ivec2(x, y), near);
    }
  }
  return near;
}

// gap_to_plates, of voronoi (cellular/voronoi.glsl)
vec2 cracked_mud_gap_to_plates(cracked_mud_Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.45 - 1e-5;
  return max(difference, 0.0);
}

// half_way, of voronoi (cellular/voronoi.glsl)
float cracked_mud_half_way(cracked_mud_Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_plates, of voronoi (cellular/voronoi.glsl)
cracked_mud_Edge2 cracked_mud_border_around_plates(cracked_mud_Look2 look, cracked_mud_Near2 near,
    vec2 point) {
  float first = distance(point, look.place);
  cracked_mud_Edge2 edge = cracked_mud_Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cracked_mud_gap_to_plates(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cracked_mud_point_of_plates(look, offset, bits);
        float border = cracked_mud_half_way(look, point, other);
        edge = border < edge.border ? cracked_mud_Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_plates, of voronoi (cellular/voronoi.glsl)
cracked_mud_Edge2 cracked_mud_border_around_plates2(cracked_mud_Look2 look, cracked_mud_Near2 near,
    vec2 point, cracked_mud_Edge2 edge) {
  float first = distance(point, look.place);
  cracked_mud_Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cracked_mud_gap_to_plates(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cracked_mud_point_of_plates(look, offset, bits);
        float border = cracked_mud_half_way(look, point, other);
        edge2 = border < edge2.border ? cracked_mud_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// half_way, of voronoi (cellular/voronoi.glsl)
float cracked_mud_half_way2(cracked_mud_Look2 look, vec2 point, vec2 other, vec2 look_place_dx,
    vec2 look_place_dy, out float result_dx, out float result_dy) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  result_dx = dot(-look_place_dx, product);
  result_dy = dot(-look_place_dy, product);
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_plates, of voronoi (cellular/voronoi.glsl)
cracked_mud_Edge2 cracked_mud_border_around_plates3(cracked_mud_Look2 look, cracked_mud_Near2 near,
    vec2 point, cracked_mud_Edge2 edge) {
  float first = distance(point, look.place);
  cracked_mud_Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cracked_mud_gap_to_plates(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cracked_mud_point_of_plates(look, offset, bits);
        float border = cracked_mud_half_way(look, point, other);
        edge2 = border < edge2.border ? cracked_mud_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of_plates, of voronoi (cellular/voronoi.glsl)
float cracked_mud_border_of_plates(cracked_mud_Look2 look, cracked_mud_Near2 near, vec2 point,
    vec2 look_place_dx, vec2 look_place_dy, out float result_dx, out float result_dy) {
  cracked_mud_Edge2 edge = cracked_mud_border_around_plates(look, near, point);
  edge = cracked_mud_border_around_plates2(look, near, point, edge);
  if (distance(point, look.place) + 2.0 * edge.border > 1.5) {
    edge = cracked_mud_border_around_plates3(look, near, point, edge);
  }
  float result_dx2, result_dy2;
  float half_way_value = cracked_mud_half_way2(look, point, edge.other, look_place_dx,
      look_place_dy, result_dx2, result_dy2);
  bool test = half_way_value < 0.0;
  result_dx = test ? 0.0 : result_dx2;
  result_dy = test ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void cracked_mud_voronoi_plates(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float border,
    out cracked_mud_Tile tile, out float border_dx, out float border_dy, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * 5.0;
  vec2 corner = floor(p + 0.5);
  cracked_mud_Look2 look = cracked_mud_Look2(ivec2(corner), p - corner);
  vec2 look_place_dx = uv_dx * 5.0;
  vec2 look_place_dy = uv_dy * 5.0;
  cracked_mud_Near2 near = cracked_mud_nearest_plates(look);
  uint hash_value = cracked_mud_hash(near.bits - 1u);
  vec2 product = 0.9 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  vec2 point = vec2(near.offset) + 0.050000012 + product;
  float border_dx2, border_dy2;
  float border2 = cracked_mud_border_of_plates(look, near, point, look_place_dx, look_place_dy,
      border_dx2, border_dy2);
  border = border2;
  tile = cracked_mud_Tile(near.bits);
  border_dx = border_dx2;
  border_dy = border_dy2;
  tile_local_dx = look_place_dx;
  tile_local_dy = look_place_dy;
}

// point_of_chips, of voronoi (cellular/voronoi.glsl)
vec2 cracked_mud_point_of_chips(cracked_mud_Look2 look, ivec2 offset, out uint bits) {
  uint bits2 = cracked_mud_cell_hash(look.corner + offset, 12);
  uint hash_value = cracked_mud_hash(bits2 - 1u);
  bits = bits2;
  return vec2(offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
}

// visit_chips, of voronoi (cellular/voronoi.glsl)
cracked_mud_Near2 cracked_mud_visit_chips(cracked_mud_Look2 look, ivec2 offset,
    cracked_mud_Near2 near) {
  uint bits;
  vec2 point = cracked_mud_point_of_chips(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  cracked_mud_Near2 near2 = key < near.key ? cracked_mud_Near2(key, offset, bits) : near;
  return near2;
}

// nearest_chips, of voronoi (cellular/voronoi.glsl)
cracked_mud_Near2 cracked_mud_nearest_chips(cracked_mud_Look2 look) {
  cracked_mud_Near2 near = cracked_mud_Near2(1e9, ivec2(0), 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = cracked_mud_visit_chips(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = cracked_mud_visit_chips(look, ivec2(x, y), near);
    }
  }
  return near;
}

// gap_to_chips, of voronoi (cellular/voronoi.glsl)
vec2 cracked_mud_gap_to_chips(cracked_mud_Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.5 - 1e-5;
  return max(difference, 0.0);
}

// border_around_chips, of voronoi (cellular/voronoi.glsl)
cracked_mud_Edge2 cracked_mud_border_around_chips(cracked_mud_Look2 look, cracked_mud_Near2 near,
    vec2 point) {
  float first = distance(point, look.place);
  cracked_mud_Edge2 edge = cracked_mud_Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cracked_mud_gap_to_chips(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cracked_mud_point_of_chips(look, offset, bits);
        float border = cracked_mud_half_way(look, point, other);
        edge = border < edge.border ? cracked_mud_Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_chips, of voronoi (cellular/voronoi.glsl)
cracked_mud_Edge2 cracked_mud_border_around_chips2(cracked_mud_Look2 look, cracked_mud_Near2 near,
    vec2 point, cracked_mud_Edge2 edge) {
  float first = distance(point, look.place);
  cracked_mud_Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cracked_mud_gap_to_chips(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cracked_mud_point_of_chips(look, offset, bits);
        float border = cracked_mud_half_way(look, point, other);
        edge2 = border < edge2.border ? cracked_mud_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_around_chips, of voronoi (cellular/voronoi.glsl)
cracked_mud_Edge2 cracked_mud_border_around_chips3(cracked_mud_Look2 look, cracked_mud_Near2 near,
    vec2 point, cracked_mud_Edge2 edge) {
  float first = distance(point, look.place);
  cracked_mud_Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cracked_mud_gap_to_chips(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cracked_mud_point_of_chips(look, offset, bits);
        float border = cracked_mud_half_way(look, point, other);
        edge2 = border < edge2.border ? cracked_mud_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of_chips, of voronoi (cellular/voronoi.glsl)
float cracked_mud_border_of_chips(cracked_mud_Look2 look, cracked_mud_Near2 near, vec2 point,
    vec2 look_place_dx, vec2 look_place_dy, out float result_dx, out float result_dy) {
  cracked_mud_Edge2 edge = cracked_mud_border_around_chips(look, near, point);
  edge = cracked_mud_border_around_chips2(look, near, point, edge);
  bool test = distance(point, look.place) + 2.0 * edge.border > 1.5;
  edge = test ? cracked_mud_border_around_chips3(look, near, point, edge) : edge;
  float result_dx2, result_dy2;
  float half_way_value = cracked_mud_half_way2(look, point, edge.other, look_place_dx,
      look_place_dy, result_dx2, result_dy2);
  bool test2 = half_way_value < 0.0;
  result_dx = test2 ? 0.0 : result_dx2;
  result_dy = test2 ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void cracked_mud_voronoi_chips(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float border,
    out cracked_mud_Tile tile, out float border_dx, out float border_dy, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * 17.0;
  vec2 corner = floor(p + 0.5);
  cracked_mud_Look2 look = cracked_mud_Look2(ivec2(corner), p - corner);
  vec2 look_place_dx = uv_dx * 17.0;
  vec2 look_place_dy = uv_dy * 17.0;
  cracked_mud_Near2 near = cracked_mud_nearest_chips(look);
  uint hash_value = cracked_mud_hash(near.bits - 1u);
  vec2 point = vec2(near.offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
      * 1.5258789e-5;
  float border_dx2, border_dy2;
  float border2 = cracked_mud_border_of_chips(look, near, point, look_place_dx, look_place_dy,
      border_dx2, border_dy2);
  border = border2;
  tile = cracked_mud_Tile(near.bits);
  border_dx = border_dx2;
  border_dy = border_dy2;
  tile_local_dx = look_place_dx;
  tile_local_dy = look_place_dy;
}

// joint (tiles/joint.glsl)
float cracked_mud_joint(float edge, float width, float edge_dx, float edge_dy) {
  float pixel = max(sqrt(edge_dx * edge_dx + edge_dy * edge_dy), 1e-7);
  float product = 0.5 * pixel;
  float low = max(edge - product, -0.5 * width);
  float high = min(edge + product, 0.5 * width);
  float line = max(high - low, 0.0) / pixel;
  float far = clamp(2.0 * pixel - 1.0, 0.0, 1.0);
  line = min(line / (1.0 - 0.5 * min(pixel, 1.0)), 1.0);
  float brick = max(1.0 - width, 0.0);
  return mix(line, 1.0 - brick * brick, far);
}

// gradient_noise (noise/gradient_noise.glsl)
float cracked_mud_gradient_noise_perlin(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 base = floor(uv);
  vec2 t = uv - base;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = cracked_mud_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = cracked_mud_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = uv_dx.x * x + uv_dx.y * y;
  vec4 corners_dy = uv_dy.x * x + uv_dy.y * y;
  vec2 fade_dx = uv_dx * fade_slope;
  vec2 fade_dy = uv_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * 0.9340967;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * 0.9340967;
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// billow (noise/billow.glsl)
float cracked_mud_billow(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 26.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 26.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 26.0;
  vec2 p_dy = uv_dy * 26.0;
  float weight = 0.43372658;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.0;
  float carry = 1.0;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  float carry_dx = 0.0;
  float carry_dy = 0.0;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 4.0 * width * frequency, 1.0);
    float lump = 0.269;
    float lump_dx = 0.0;
    float lump_dy = 0.0;
    if (near > 0.0) {
      float result_dx2, result_dy2;
      float gradient_noise_perlin_value = cracked_mud_gradient_noise_perlin(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      float difference = 2.0 * gradient_noise_perlin_value - 1.0;
      float direction = sign(difference);
      lump = mix(0.269, abs(difference), near);
      lump_dx = result_dx2 * 2.0 * direction * near;
      lump_dy = result_dy2 * 2.0 * direction * near;
    }
    float lump2 = lump * carry;
    lump_dx = lump_dx * carry + lump * carry_dx;
    lump_dy = lump_dy * carry + lump * carry_dy;
    frequency *= 2.0;
    shift += 37.7;
    sum += weight * lump2;
    carry = mix(1.0, lump2, 0.7);
    sum_dx += lump_dx * weight;
    sum_dy += lump_dy * weight;
    weight *= 0.6;
    carry_dx = lump_dx * 0.7;
    carry_dy = lump_dy * 0.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// secant_rolled, of curve (math/curve.glsl)
float cracked_mud_secant_rolled(int i) {
  vec2 way = cracked_mud_points[clamp(i + 1, 0, 4)] - cracked_mud_points[clamp(i, 0, 4)];
  return way.y / max(way.x, 1e-7);
}

// slope_at_rolled, of curve (math/curve.glsl)
float cracked_mud_slope_at_rolled(int i) {
  int middle = clamp(i, 1, 3);
  int difference = middle - 1;
  float before = cracked_mud_secant_rolled(difference);
  float behind = cracked_mud_secant_rolled(middle);
  float value = cracked_mud_points[middle].x;
  float length_before = max(value - cracked_mud_points[clamp(difference, 0, 4)].x, 1e-7);
  float length_behind = max(cracked_mud_points[middle + 1].x - value, 1e-7);
  float all2 = length_before + length_behind;
  float choice;
  if (i == middle) {
    float parabola = (before * length_behind + behind * length_before) / all2;
    float flatter = min(abs(before), abs(behind));
    choice = (sign(before) + sign(behind)) * min(flatter, 0.5 * abs(parabola));
  } else {
    bool test = i == 0;
    float own = test ? before : behind;
    float share = (test ? length_before : length_behind) / all2;
    float parabola = own + share * (own - (test ? behind : before));
    choice = 0.0;
    if (!(parabola * own <= 0.0)) {
      choice = 2.0 * abs(own) < abs(parabola) ? 2.0 * own : parabola;
    }
  }
  return choice;
}

// part_mean_rolled, of curve (math/curve.glsl)
float cracked_mud_part_mean_rolled(int i, float middle, float reach, float middle_dx,
    float middle_dy, float reach_dx, float reach_dy, out float result_dx, out float result_dy) {
  vec2 from = cracked_mud_points[clamp(i, 0, 4)];
  int sum = i + 1;
  vec2 to = cracked_mud_points[clamp(sum, 0, 4)];
  float way = max(to.x - from.x, 1e-7);
  float ratio = (middle - from.x) / way;
  float t = clamp(ratio, 0.0, 1.0);
  bool test = ratio < 0.0;
  bool test2 = ratio > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : middle_dx / way;
  float t_dy = test ? 0.0 : test2 ? 0.0 : middle_dy / way;
  float rise = to.y - from.y;
  float start = way * cracked_mud_slope_at_rolled(i) - rise;
  float product = way * cracked_mud_slope_at_rolled(sum);
  float end = rise - product;
  float product2 = 6.0 * t;
  float bend = (product2 - 4.0) * start + (2.0 - product2) * end;
  float bend_slope = start + (product - rise);
  float part = reach / way;
  float part_dx = reach_dx / way;
  float part_dy = reach_dy / way;
  float difference = 1.0 - t;
  float product3 = t * difference;
  float blend = mix(start, end, t);
  float sum2 = rise + ((difference - t) * blend + product3 * (end - start));
  float product4 = bend * part;
  float bend_dx = t_dx * 6.0 * bend_slope;
  float bend_dy = t_dy * 6.0 * bend_slope;
  result_dx = t_dx * sum2 + ((bend_dx * part + bend * part_dx) * part + product4 * part_dx) / 6.0;
  result_dy = t_dy * sum2 + ((bend_dy * part + bend * part_dy) * part + product4 * part_dy) / 6.0;
  return from.y + rise * t + product3 * blend + product4 * part / 6.0;
}

// curve (math/curve.glsl)
float cracked_mud_curve_rolled(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float ratio = -value_dx / width;
  float ratio2 = -value_dy / width;
  float sum2 = -value / width + 0.5;
  float below = clamp(sum2, 0.0, 1.0);
  bool test = sum2 < 0.0;
  bool test2 = sum2 > 1.0;
  float below_dx = test ? 0.0 : test2 ? 0.0 : ratio;
  float below_dy = test ? 0.0 : test2 ? 0.0 : ratio2;
  float sum = 0.2 * below;
  float sum_dx = below_dx * 0.2;
  float sum_dy = below_dy * 0.2;
  for (int i = 0; i < 4; ++i) {
    float sum3 = (cracked_mud_points[i + 1].x - value) / width + 0.5;
    float next = clamp(sum3, 0.0, 1.0);
    bool test3 = sum3 < 0.0;
    bool test4 = sum3 > 1.0;
    float next_dx = test3 ? 0.0 : test4 ? 0.0 : ratio;
    float next_dy = test3 ? 0.0 : test4 ? 0.0 : ratio2;
    float reach_slope = width * 0.5;
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float middle_dx = value_dx + (below_dx + next_dx) * reach_slope;
    float middle_dy = value_dy + (below_dy + next_dy) * reach_slope;
    float difference = next - below;
    float difference2 = next_dx - below_dx;
    float difference3 = next_dy - below_dy;
    float reach = 0.5 * difference * width;
    float reach_dx = difference2 * reach_slope;
    float reach_dy = difference3 * reach_slope;
    float result_dx2, result_dy2;
    float part_mean_rolled_value = cracked_mud_part_mean_rolled(i, middle, reach, middle_dx,
        middle_dy, reach_dx, reach_dy, result_dx2, result_dy2);
    below = next;
    sum += difference * part_mean_rolled_value;
    below_dx = next_dx;
    below_dy = next_dy;
    sum_dx += difference2 * part_mean_rolled_value + difference * result_dx2;
    sum_dy += difference3 * part_mean_rolled_value + difference * result_dy2;
  }
  result_dx = sum_dx + below_dx * -0.55;
  result_dy = sum_dy + below_dy * -0.55;
  return sum + (1.0 - below) * 0.55;
}

// tile_near (tiles/tile_near.glsl)
float cracked_mud_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// tile_random (tiles/tile_random.glsl)
float cracked_mud_tile_random(cracked_mud_Tile tile, float low, float high, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  float luck = float(cracked_mud_hash(tile.seed) >> 8u) * 5.9604645e-8;
  return mix(low, high, mix(0.5, luck, cracked_mud_tile_near(tile_local_dx, tile_local_dy)));
}

// fbm (noise/fbm.glsl)
float cracked_mud_fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 4.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 4.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 4.0;
  vec2 p_dy = uv_dy * 4.0;
  float weight = 0.516129;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_perlin_value = cracked_mud_gradient_noise_perlin(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_perlin_value - 0.5);
      sum_dx += result_dx2 * product2;
      sum_dy += result_dy2 * product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// part_mean, of color_ramp (color/color_ramp.glsl)
vec4 cracked_mud_part_mean(vec4 from, vec4 to, float middle, float reach) {
  float square = reach * reach;
  float variance = square / 3.0;
  vec4 color = mix(from, to, middle);
  vec3 sum = color.xyz * color.w + (to.xyz - from.xyz) * ((to.w - from.w) * variance);
  return vec4(sum, color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 cracked_mud_color_ramp(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp((0.3 - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.24, 0.15, 0.09, 1.0) * below;
  for (int i = 0; i < 2; ++i) {
    int sum2 = i + 1;
    float item = cracked_mud_stops[sum2];
    float next = clamp((item - position) / width + 0.5, 0.0, 1.0);
    float item2 = cracked_mud_stops[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float least = min(0.5 * difference * width * part, 0.5);
    vec4 part_mean_value = cracked_mud_part_mean(cracked_mud_colors[i], cracked_mud_colors[sum2],
        clamp(middle * part, 0.0, 1.0), least);
    below = next;
    sum += difference * part_mean_value;
  }
  sum += (1.0 - below) * vec4(0.52, 0.42, 0.31, 1.0);
  vec3 choice = vec3(0.52, 0.42, 0.31);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// level_silt_tone, of levels (color/levels.glsl)
float cracked_mud_level_silt_tone(float value, float value_dx, float value_dy) {
  float t = value * 1.6666666;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 1.6666666, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// level_dust, of levels (color/levels.glsl)
float cracked_mud_level_dust(float value, float value_dx, float value_dy) {
  float t = (value - 0.55) * 2.2222223;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.2222223, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// slope_at_chip_dome, of curve (math/curve.glsl)
float cracked_mud_slope_at_chip_dome(int i) {
  float choice = 0.285714;
  if (i != 1) {
    float parabola = i == 0 ? 3.4238102 : -1.6238102;
    choice = i != 0 ? 0.0 : parabola;
  }
  return choice;
}

// part_mean_chip_dome, of curve (math/curve.glsl)
float cracked_mud_part_mean_chip_dome(int i, float middle, float reach) {
  vec2 from = cracked_mud_points2[clamp(i, 0, 2)];
  int sum = i + 1;
  vec2 to = cracked_mud_points2[clamp(sum, 0, 2)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * cracked_mud_slope_at_chip_dome(i) - rise;
  float end = rise - way * cracked_mud_slope_at_chip_dome(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float cracked_mud_curve_chip_dome(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = 0.82 * below;
  for (int i = 0; i < 2; ++i) {
    float next = clamp((cracked_mud_points2[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * cracked_mud_part_mean_chip_dome(i, middle, reach);
  }
  return sum + (1.0 - below);
}

void cracked_mud(vec2 uv, out vec4 color, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // place: domain_warp (noise/domain_warp.glsl)
  vec2 place_dx, place_dy;
  vec2 place = cracked_mud_domain_warp(uv, uv_dx, uv_dy, place_dx, place_dy);
  // plates: voronoi (cellular/voronoi.glsl)
  float plates_border, plates_border_dx, plates_border_dy;
  cracked_mud_Tile plates_tile;
  vec2 plates_tile_local_dx, plates_tile_local_dy;
  cracked_mud_voronoi_plates(place, place_dx, place_dy, plates_border, plates_tile,
      plates_border_dx, plates_border_dy, plates_tile_local_dx, plates_tile_local_dy);
  // chips: voronoi (cellular/voronoi.glsl)
  float chips_border, chips_border_dx, chips_border_dy;
  cracked_mud_Tile chips_tile;
  vec2 chips_tile_local_dx, chips_tile_local_dy;
  cracked_mud_voronoi_chips(place, place_dx, place_dy, chips_border, chips_tile, chips_border_dx,
      chips_border_dy, chips_tile_local_dx, chips_tile_local_dy);
  // wide: joint (tiles/joint.glsl)
  float wide = cracked_mud_joint(plates_border, width, plates_border_dx, plates_border_dy);
  // fine: joint (tiles/joint.glsl)
  float fine = cracked_mud_joint(chips_border, 0.05, chips_border_dx, chips_border_dy);
  // silt: billow (noise/billow.glsl)
  float silt_dx, silt_dy;
  float silt = cracked_mud_billow(uv, uv_dx, uv_dy, silt_dx, silt_dy);
  // rolled: curve (math/curve.glsl)
  float rolled_dx, rolled_dy;
  float rolled = cracked_mud_curve_rolled(plates_border, plates_border_dx, plates_border_dy,
      rolled_dx, rolled_dy);
  // tone: tile_random (tiles/tile_random.glsl)
  float tone = cracked_mud_tile_random(plates_tile, 0.75, 1.15, plates_tile_local_dx,
      plates_tile_local_dy);
  // chip_tone: tile_random (tiles/tile_random.glsl)
  float chip_tone = cracked_mud_tile_random(chips_tile, 0.86, 1.1, chips_tile_local_dx,
      chips_tile_local_dy);
  // tones: multiply (math/multiply.glsl)
  float tones = tone * chip_tone;
  // clouds: fbm (noise/fbm.glsl)
  float clouds_dx, clouds_dy;
  float clouds = cracked_mud_fbm(uv, uv_dx, uv_dy, clouds_dx, clouds_dy);
  // clay: color_ramp (color/color_ramp.glsl)
  vec4 clay = cracked_mud_color_ramp(clouds, clouds_dx, clouds_dy);
  // silt_tone: levels (color/levels.glsl)
  float silt_tone = mix(0.72, 1.12, cracked_mud_level_silt_tone(silt, silt_dx, silt_dy));
  // dust: levels (color/levels.glsl)
  float dust = mix(0.82, 1.12, cracked_mud_level_dust(rolled, rolled_dx, rolled_dy));
  // light: multiply (math/multiply.glsl)
  float light = silt_tone * dust;
  // lights: multiply (math/multiply.glsl)
  float lights = light * tones;
  // lit: multiply (math/multiply.glsl)
  vec3 lit = clay.xyz * lights;
  // fine_depth: multiply (math/multiply.glsl)
  float fine_depth = fine * 0.6;
  // chipped: lerp (math/lerp.glsl)
  vec3 chipped = mix(lit, vec3(0.1, 0.065, 0.042), fine_depth);
  // ground: lerp (math/lerp.glsl)
  vec3 ground = mix(chipped, vec3(0.022, 0.014, 0.01), wide);
  // color: rgba (channels/rgba.glsl)
  vec4 color2 = vec4(ground, 1.0);
  // chip_dome: curve (math/curve.glsl)
  float chip_dome = cracked_mud_curve_chip_dome(chips_border, chips_border_dx, chips_border_dy);
  // silt_height: multiply (math/multiply.glsl)
  float silt_height = silt * 0.12;
  // cracked: multiply (math/multiply.glsl)
  float cracked = rolled * chip_dome;
  // raised: add (math/add.glsl)
  float raised = cracked + silt_height;
  // between: invert (math/invert.glsl)
  float between = 1.0 - wide;
  // height: multiply (math/multiply.glsl)
  float height2 = raised * between;
  // roughness: lerp (math/lerp.glsl)
  float roughness2 = mix(0.8, 0.95, wide);
  color = color2;
  height = height2;
  roughness = roughness2;
}
