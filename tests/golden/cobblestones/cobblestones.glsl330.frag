// cobblestones: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float gap;  // default 0.14

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

// wrap_cell (tiles/wrap_cell.glsl)
int wrap_cell(int cell) {
  int flip = cell >> 31;
  return (((cell ^ flip) % 9) ^ flip) + (flip & 9);
}

// repeated, of voronoi (cellular/voronoi.glsl)
int repeated(int cell) {
  int result = cell + (cell < 0 ? 9 : 0);
  result -= cell >= 9 ? 9 : 0;
  return result;
}

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(678955108u, 3637793521u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// point_of, of voronoi (cellular/voronoi.glsl)
vec2 point_of(Look2 look, ivec2 offset, out uint bits) {
  ivec2 sum = look.corner + offset;
  uint bits2 = cell_hash(ivec2(repeated(sum.x), repeated(sum.y)));
  uint hash_value = hash(bits2 - 1u);
  vec2 product = 0.6 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  bits = bits2;
  return vec2(offset) + 0.19999999 + product;
}

// visit, of voronoi (cellular/voronoi.glsl)
Near2 visit(Look2 look, ivec2 offset, Near2 near) {
  uint bits;
  vec2 point = point_of(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  Near2 near2 = key < near.key ? Near2(key, offset, bits) : near;
  return near2;
}

// nearest, of voronoi (cellular/voronoi.glsl)
Near2 nearest(Look2 look) {
  Near2 near = Near2(1e9, ivec2(0), 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = visit(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = visit(look, ivec2(x, y), near);
    }
  }
  return near;
}

// gap_to, of voronoi (cellular/voronoi.glsl)
vec2 gap_to(Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.3 - 1e-5;
  return max(difference, 0.0);
}

// half_way, of voronoi (cellular/voronoi.glsl)
float half_way(Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_stones, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_stones(Look2 look, Near2 near, vec2 point) {
  float first = distance(point, look.place);
  Edge2 edge = Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of(look, offset, bits);
        float border = half_way(look, point, other);
        edge = border < edge.border ? Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_stones, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_stones2(Look2 look, Near2 near, vec2 point, Edge2 edge) {
  float first = distance(point, look.place);
  Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of(look, offset, bits);
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

// border_around_stones, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_stones3(Look2 look, Near2 near, vec2 point, Edge2 edge) {
  float first = distance(point, look.place);
  Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of(look, offset, bits);
        float border = half_way(look, point, other);
        edge2 = border < edge2.border ? Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of, of voronoi (cellular/voronoi.glsl)
float border_of(Look2 look, Near2 near, vec2 point, vec2 look_place_dx, vec2 look_place_dy,
    out float result_dx, out float result_dy) {
  Edge2 edge = border_around_stones(look, near, point);
  edge = border_around_stones2(look, near, point, edge);
  if (distance(point, look.place) + 2.0 * edge.border > 1.5) {
    edge = border_around_stones3(look, near, point, edge);
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
void voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float f1, out float border, out Tile tile,
    out float border_dx, out float border_dy, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 9.0;
  vec2 corner = floor(p + 0.5);
  ivec2 numbers = ivec2(corner);
  Look2 look = Look2(ivec2(wrap_cell(numbers.x), wrap_cell(numbers.y)), p - corner);
  vec2 look_place_dx = uv_dx * 9.0;
  vec2 look_place_dy = uv_dy * 9.0;
  Near2 near = nearest(look);
  uint hash_value = hash(near.bits - 1u);
  vec2 product = 0.6 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  vec2 point = vec2(near.offset) + 0.19999999 + product;
  float near_1 = sqrt(near.key);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 9.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float border_dx2, border_dy2;
  float border2 = border_of(look, near, point, look_place_dx, look_place_dy, border_dx2,
      border_dy2);
  f1 = mix(near_1, 0.40157345, blur);
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
float value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// tile_random (tiles/tile_random.glsl)
float tile_random_warmth(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  float luck = float(hash(tile.seed + 1u) >> 8u) * 5.9604645e-8;
  return mix(0.5, luck, tile_near(tile_local_dx, tile_local_dy));
}

// tile_random (tiles/tile_random.glsl)
float tile_random_own_tone(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  float luck = float(hash(tile.seed) >> 8u) * 5.9604645e-8;
  return mix(0.6, 1.35, mix(0.5, luck, tile_near(tile_local_dx, tile_local_dy)));
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // stones: voronoi (cellular/voronoi.glsl)
  float stones_f1, stones_border, stones_border_dx, stones_border_dy;
  Tile stones_tile;
  vec2 stones_tile_local_dx, stones_tile_local_dy;
  voronoi(uv, uv_dx, uv_dy, stones_f1, stones_border, stones_tile, stones_border_dx,
      stones_border_dy, stones_tile_local_dx, stones_tile_local_dy);
  // sand_between: joint (tiles/joint.glsl)
  float sand_between = joint(stones_border, gap, stones_border_dx, stones_border_dy);
  // half_gap: multiply (math/multiply.glsl)
  float half_gap = gap * 0.5;
  // inside: subtract (math/subtract.glsl)
  float inside = stones_border - half_gap;
  // rise: remap (math/remap.glsl)
  float rise = clamp(inside / 0.2, 0.0, 1.0);
  // fall: invert (math/invert.glsl)
  float fall = 1.0 - rise;
  // fall_squared: multiply (math/multiply.glsl)
  float fall_squared = fall * fall;
  // edge: invert (math/invert.glsl)
  float edge = 1.0 - fall_squared;
  // from_middle: multiply (math/multiply.glsl)
  float from_middle = stones_f1 * stones_f1;
  // dome: remap (math/remap.glsl)
  float dome = mix(1.0, -0.1, from_middle);
  // rounded: multiply (math/multiply.glsl)
  float rounded = edge * dome;
  // pores: value_noise (noise/value_noise.glsl)
  float pores = value_noise(uv, vec2(150.0), 9, uv_dx, uv_dy);
  // grains: value_noise (noise/value_noise.glsl)
  float grains = value_noise(uv, vec2(256.0), 5, uv_dx, uv_dy);
  // warmth: tile_random (tiles/tile_random.glsl)
  float warmth = tile_random_warmth(stones_tile, stones_tile_local_dx, stones_tile_local_dy);
  // rock: lerp (math/lerp.glsl)
  vec3 rock = mix(vec3(0.2, 0.21, 0.225), vec3(0.29, 0.245, 0.21), warmth);
  // own_tone: tile_random (tiles/tile_random.glsl)
  float own_tone = tile_random_own_tone(stones_tile, stones_tile_local_dx, stones_tile_local_dy);
  // pore_tone: remap (math/remap.glsl)
  float pore_tone = mix(0.75, 1.15, pores);
  // wear: remap (math/remap.glsl)
  float wear = mix(0.6, 1.1, rounded);
  // worn: multiply (math/multiply.glsl)
  float worn = pore_tone * wear;
  // tone: multiply (math/multiply.glsl)
  float tone = worn * own_tone;
  // stone: multiply (math/multiply.glsl)
  vec3 stone = rock * tone;
  // sand: lerp (math/lerp.glsl)
  vec3 sand = mix(vec3(0.16, 0.13, 0.09), vec3(0.36, 0.3, 0.22), grains);
  // paving: lerp (math/lerp.glsl)
  vec3 paving = mix(stone, sand, sand_between);
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(paving, 1.0);
  // dents: value_noise (noise/value_noise.glsl)
  float dents = value_noise(uv, vec2(45.0), 2, uv_dx, uv_dy);
  // dent_height: multiply (math/multiply.glsl)
  float dent_height = dents * 0.12;
  // stone_height: add (math/add.glsl)
  float stone_height = rounded + dent_height;
  // sand_height: multiply (math/multiply.glsl)
  float sand_height = grains * 0.12;
  // height: lerp (math/lerp.glsl)
  float height = mix(stone_height, sand_height, sand_between);
  // roughness: lerp (math/lerp.glsl)
  float roughness = mix(0.55, 0.95, sand_between);
  out_color = color;
  out_height = height;
  out_roughness = roughness;
}
