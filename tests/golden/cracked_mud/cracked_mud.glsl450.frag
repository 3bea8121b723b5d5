// cracked_mud: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Parameters
layout(location = 0) uniform float width;  // default 0.1

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;
layout(location = 2) out float out_roughness;

// Types
struct Tile {
  uint seed;
};
struct Look2 {
  ivec2 corner;
  vec2 place;
};
struct Near2 {
  float key;
  ivec2 offset;
  uint bits;
};
struct Edge2 {
  float border;
  vec2 other;
};

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float value_noise(vec2 uv, int seed, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 24.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * 24.0;
  vec2 t_dy = uv_dy * 24.0;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  float low = mix(corners.x, corners.y, fade.x);
  float low_slope = corners.y - corners.x;
  float high = mix(corners.z, corners.w, fade.x);
  float high_slope = corners.w - corners.z;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 24.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float blend = mix(low_slope, high_slope, fade.y);
  float difference2 = high - low;
  result_dx = mix(fade_dx.x * blend + fade_dx.y * difference2, 0.0, blur);
  result_dy = mix(fade_dy.x * blend + fade_dy.y * difference2, 0.0, blur);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell, int seed) {
  uint first = hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(first, hash(first));
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// point_of_plates, of voronoi (cellular/voronoi.glsl)
vec2 point_of_plates(Look2 look, ivec2 offset, out uint bits) {
  uint bits2 = cell_hash(look.corner + offset, 11);
  uint hash_value = hash(bits2 - 1u);
  vec2 product = 0.9 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  bits = bits2;
  return vec2(offset) + 0.050000012 + product;
}

// visit_plates, of voronoi (cellular/voronoi.glsl)
Near2 visit_plates(Look2 look, ivec2 offset, Near2 near) {
  uint bits;
  vec2 point = point_of_plates(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  Near2 near2 = key < near.key ? Near2(key, offset, bits) : near;
  return near2;
}

// nearest_plates, of voronoi (cellular/voronoi.glsl)
Near2 nearest_plates(Look2 look) {
  Near2 near = Near2(1e9, ivec2(0), 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = visit_plates(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = visit_plates(look, ivec2(x, y), near);
    }
  }
  return near;
}

// gap_to_plates, of voronoi (cellular/voronoi.glsl)
vec2 gap_to_plates(Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.45 - 1e-5;
  return max(difference, 0.0);
}

// half_way, of voronoi (cellular/voronoi.glsl)
float half_way(Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_plates, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_plates(Look2 look, Near2 near, vec2 point) {
  float first = distance(point, look.place);
  Edge2 edge = Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to_plates(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of_plates(look, offset, bits);
        float border = half_way(look, point, other);
        edge = border < edge.border ? Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_plates, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_plates2(Look2 look, Near2 near, vec2 point, Edge2 edge) {
  float first = distance(point, look.place);
  Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to_plates(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of_plates(look, offset, bits);
        float border = half_way(look, point, other);
        edge2 = border < edge2.border ? Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// half_way, of voronoi (cellular/voronoi.glsl)
float half_way2(Look2 look, vec2 point, vec2 other, vec2 look_place_dx, vec2 look_place_dy,
    out float result_dx, out float result_dy) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  result_dx = dot(-look_place_dx, product);
  result_dy = dot(-look_place_dy, product);
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_plates, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_plates3(Look2 look, Near2 near, vec2 point, Edge2 edge) {
  float first = distance(point, look.place);
  Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to_plates(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of_plates(look, offset, bits);
        float border = half_way(look, point, other);
        edge2 = border < edge2.border ? Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of_plates, of voronoi (cellular/voronoi.glsl)
float border_of_plates(Look2 look, Near2 near, vec2 point, vec2 look_place_dx, vec2 look_place_dy,
    out float result_dx, out float result_dy) {
  Edge2 edge = border_around_plates(look, near, point);
  edge = border_around_plates2(look, near, point, edge);
  if (distance(point, look.place) + 2.0 * edge.border > 1.5) {
    edge = border_around_plates3(look, near, point, edge);
  }
  float result_dx2, result_dy2;
  float half_way_value = half_way2(look, point, edge.other, look_place_dx, look_place_dy,
      result_dx2, result_dy2);
  bool test = half_way_value < 0.0;
  result_dx = test ? 0.0 : result_dx2;
  result_dy = test ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void voronoi_plates(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float border, out Tile tile,
    out float border_dx, out float border_dy, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 5.0;
  vec2 corner = floor(p + 0.5);
  Look2 look = Look2(ivec2(corner), p - corner);
  vec2 look_place_dx = uv_dx * 5.0;
  vec2 look_place_dy = uv_dy * 5.0;
  Near2 near = nearest_plates(look);
  uint hash_value = hash(near.bits - 1u);
  vec2 product = 0.9 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  vec2 point = vec2(near.offset) + 0.050000012 + product;
  float border_dx2, border_dy2;
  float border2 = border_of_plates(look, near, point, look_place_dx, look_place_dy, border_dx2,
      border_dy2);
  border = border2;
  tile = Tile(near.bits);
  border_dx = border_dx2;
  border_dy = border_dy2;
  tile_local_dx = look_place_dx;
  tile_local_dy = look_place_dy;
}

// point_of_chips, of voronoi (cellular/voronoi.glsl)
vec2 point_of_chips(Look2 look, ivec2 offset, out uint bits) {
  uint bits2 = cell_hash(look.corner + offset, 12);
  uint hash_value = hash(bits2 - 1u);
  bits = bits2;
  return vec2(offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
}

// visit_chips, of voronoi (cellular/voronoi.glsl)
Near2 visit_chips(Look2 look, ivec2 offset, Near2 near) {
  uint bits;
  vec2 point = point_of_chips(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  Near2 near2 = key < near.key ? Near2(key, offset, bits) : near;
  return near2;
}

// nearest_chips, of voronoi (cellular/voronoi.glsl)
Near2 nearest_chips(Look2 look) {
  Near2 near = Near2(1e9, ivec2(0), 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = visit_chips(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = visit_chips(look, ivec2(x, y), near);
    }
  }
  return near;
}

// gap_to_chips, of voronoi (cellular/voronoi.glsl)
vec2 gap_to_chips(Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.5 - 1e-5;
  return max(difference, 0.0);
}

// border_around_chips, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_chips(Look2 look, Near2 near, vec2 point) {
  float first = distance(point, look.place);
  Edge2 edge = Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to_chips(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of_chips(look, offset, bits);
        float border = half_way(look, point, other);
        edge = border < edge.border ? Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_chips, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_chips2(Look2 look, Near2 near, vec2 point, Edge2 edge) {
  float first = distance(point, look.place);
  Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to_chips(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of_chips(look, offset, bits);
        float border = half_way(look, point, other);
        edge2 = border < edge2.border ? Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_around_chips, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_chips3(Look2 look, Near2 near, vec2 point, Edge2 edge) {
  float first = distance(point, look.place);
  Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to_chips(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of_chips(look, offset, bits);
        float border = half_way(look, point, other);
        edge2 = border < edge2.border ? Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of_chips, of voronoi (cellular/voronoi.glsl)
float border_of_chips(Look2 look, Near2 near, vec2 point, vec2 look_place_dx, vec2 look_place_dy,
    out float result_dx, out float result_dy) {
  Edge2 edge = border_around_chips(look, near, point);
  edge = border_around_chips2(look, near, point, edge);
  bool test = distance(point, look.place) + 2.0 * edge.border > 1.5;
  edge = test ? border_around_chips3(look, near, point, edge) : edge;
  float result_dx2, result_dy2;
  float half_way_value = half_way2(look, point, edge.other, look_place_dx, look_place_dy,
      result_dx2, result_dy2);
  bool test2 = half_way_value < 0.0;
  result_dx = test2 ? 0.0 : result_dx2;
  result_dy = test2 ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void voronoi_chips(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float border, out Tile tile,
    out float border_dx, out float border_dy, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 17.0;
  vec2 corner = floor(p + 0.5);
  Look2 look = Look2(ivec2(corner), p - corner);
  vec2 look_place_dx = uv_dx * 17.0;
  vec2 look_place_dy = uv_dy * 17.0;
  Near2 near = nearest_chips(look);
  uint hash_value = hash(near.bits - 1u);
  vec2 point = vec2(near.offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
      * 1.5258789e-5;
  float border_dx2, border_dy2;
  float border2 = border_of_chips(look, near, point, look_place_dx, look_place_dy, border_dx2,
      border_dy2);
  border = border2;
  tile = Tile(near.bits);
  border_dx = border_dx2;
  border_dy = border_dy2;
  tile_local_dx = look_place_dx;
  tile_local_dy = look_place_dy;
}

// joint (tiles/joint.glsl)
float joint(float edge, float width, float edge_dx, float edge_dy) {
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

// smooth_step (math/smooth_step.glsl)
float smooth_step(float value, float high) {
  float t = clamp(value / max(high, 1e-7), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// value_noise (noise/value_noise.glsl)
float value_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 180.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 2131687100u);
  uvec4 bits = hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 180.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// tile_random (tiles/tile_random.glsl)
float tile_random(Tile tile, float low, float high, vec2 tile_local_dx, vec2 tile_local_dy) {
  float luck = float(hash(tile.seed) >> 8u) * 5.9604645e-8;
  return mix(low, high, mix(0.5, luck, tile_near(tile_local_dx, tile_local_dy)));
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // bend_x: value_noise (noise/value_noise.glsl)
  float bend_x_dx, bend_x_dy;
  float bend_x = value_noise(uv, 7, uv_dx, uv_dy, bend_x_dx, bend_x_dy);
  // bend_y: value_noise (noise/value_noise.glsl)
  float bend_y_dx, bend_y_dy;
  float bend_y = value_noise(uv, 8, uv_dx, uv_dy, bend_y_dx, bend_y_dy);
  // bend: combine2 (channels/combine2.glsl)
  vec2 bend = vec2(bend_x, bend_y);
  vec2 bend_dx = vec2(bend_x_dx, bend_y_dx);
  vec2 bend_dy = vec2(bend_x_dy, bend_y_dy);
  // offset: multiply (math/multiply.glsl)
  vec2 offset = bend * 0.02;
  // place: add (math/add.glsl)
  vec2 place = uv + offset;
  vec2 offset_dx = bend_dx * 0.02;
  vec2 offset_dy = bend_dy * 0.02;
  vec2 place_dx = uv_dx + offset_dx;
  vec2 place_dy = uv_dy + offset_dy;
  // plates: voronoi (cellular/voronoi.glsl)
  float plates_border, plates_border_dx, plates_border_dy;
  Tile plates_tile;
  vec2 plates_tile_local_dx, plates_tile_local_dy;
  voronoi_plates(place, place_dx, place_dy, plates_border, plates_tile, plates_border_dx,
      plates_border_dy, plates_tile_local_dx, plates_tile_local_dy);
  // chips: voronoi (cellular/voronoi.glsl)
  float chips_border, chips_border_dx, chips_border_dy;
  Tile chips_tile;
  vec2 chips_tile_local_dx, chips_tile_local_dy;
  voronoi_chips(place, place_dx, place_dy, chips_border, chips_tile, chips_border_dx,
      chips_border_dy, chips_tile_local_dx, chips_tile_local_dy);
  // wide: joint (tiles/joint.glsl)
  float wide = joint(plates_border, width, plates_border_dx, plates_border_dy);
  // fine: joint (tiles/joint.glsl)
  float fine = joint(chips_border, 0.05, chips_border_dx, chips_border_dy);
  // dome: smooth_step (math/smooth_step.glsl)
  float dome = smooth_step(plates_border, 0.3);
  // grain: value_noise (noise/value_noise.glsl)
  float grain = value_noise(uv, uv_dx, uv_dy);
  // tone: tile_random (tiles/tile_random.glsl)
  float tone = tile_random(plates_tile, 0.85, 1.1, plates_tile_local_dx, plates_tile_local_dy);
  // chip_tone: tile_random (tiles/tile_random.glsl)
  float chip_tone = tile_random(chips_tile, 0.92, 1.06, chips_tile_local_dx, chips_tile_local_dy);
  // grain_tone: remap (math/remap.glsl)
  float grain_tone = mix(0.9, 1.05, grain);
  // dome_tone: remap (math/remap.glsl)
  float dome_tone = mix(0.72, 1.0, dome);
  // tones: multiply (math/multiply.glsl)
  float tones = tone * chip_tone;
  // tones_2: multiply (math/multiply.glsl)
  float tones_2 = grain_tone * dome_tone;
  // light: multiply (math/multiply.glsl)
  float light = tones * tones_2;
  // mud: multiply (math/multiply.glsl)
  vec3 mud = light * vec3(0.42, 0.31, 0.21);
  // fine_depth: multiply (math/multiply.glsl)
  float fine_depth = fine * 0.55;
  // chipped: lerp (math/lerp.glsl)
  vec3 chipped = mix(mud, vec3(0.13, 0.09, 0.06), fine_depth);
  // ground: lerp (math/lerp.glsl)
  vec3 ground = mix(chipped, vec3(0.035, 0.024, 0.017), wide);
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(ground, 1.0);
  // chip_dome: smooth_step (math/smooth_step.glsl)
  float chip_dome = smooth_step(chips_border, 0.2);
  // plate_height: remap (math/remap.glsl)
  float plate_height = mix(0.35, 1.0, dome);
  // chip_height: remap (math/remap.glsl)
  float chip_height = mix(0.9, 1.0, chip_dome);
  // raised: multiply (math/multiply.glsl)
  float raised = plate_height * chip_height;
  // between: invert (math/invert.glsl)
  float between = 1.0 - wide;
  // height: multiply (math/multiply.glsl)
  float height = raised * between;
  // roughness: lerp (math/lerp.glsl)
  float roughness = mix(0.8, 0.95, wide);
  out_color = color;
  out_height = height;
  out_roughness = roughness;
}
