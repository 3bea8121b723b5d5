// cobblestones: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float gap;  // default 0.1
uniform float depth;  // default 0.024
uniform float moss_cover;  // default 0.7

// Types
struct cobblestones_Tile {
  uint seed;
};
struct cobblestones_Look2 {
  ivec2 corner;
  vec2 place;
};
struct cobblestones_Near2 {
  float key;
  ivec2 offset;
  uint bits;
};
struct cobblestones_Edge2 {
  float border;
  vec2 other;
};

// Constants
const vec2 cobblestones_points[5] = vec2[5](vec2(0.0), vec2(0.1, 0.4), vec2(0.35, 0.82),
    vec2(0.7, 0.98), vec2(1.0));

// wrap_cell (tiles/wrap_cell.glsl)
int cobblestones_wrap_cell_stones(int cell, int count) {
  int flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}

// repeated, of voronoi (cellular/voronoi.glsl)
int cobblestones_repeated(int cell) {
  int result = cell + (cell < 0 ? 9 : 0);
  result -= cell >= 9 ? 9 : 0;
  return result;
}

// cell_hash (indirection/cell_hash.glsl)
uint cobblestones_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(678955108u, 3637793521u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint cobblestones_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// point_of, of voronoi (cellular/voronoi.glsl)
vec2 cobblestones_point_of(cobblestones_Look2 look, ivec2 offset, out uint bits) {
  ivec2 sum = look.corner + offset;
  uint bits2 = cobblestones_cell_hash(ivec2(cobblestones_repeated(sum.x),
      cobblestones_repeated(sum.y)));
  uint hash_value = cobblestones_hash(bits2 - 1u);
  vec2 product = 0.6 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  bits = bits2;
  return vec2(offset) + 0.19999999 + product;
}

// visit, of voronoi (cellular/voronoi.glsl)
void cobblestones_visit(cobblestones_Look2 look, ivec2 offset, cobblestones_Near2 near,
    vec2 look_place_dx, vec2 look_place_dy, float near_key_dx, float near_key_dy,
    out cobblestones_Near2 near_out, out float near_out_key_dx, out float near_out_key_dy) {
  uint bits;
  vec2 point = cobblestones_point_of(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  float projection = dot(-look_place_dx, difference);
  float key_dx = projection + projection;
  float projection2 = dot(-look_place_dy, difference);
  float key_dy = projection2 + projection2;
  cobblestones_Near2 near2 = near;
  float near_key_dx2 = near_key_dx;
  float near_key_dy2 = near_key_dy;
  if (key < near.key) {
    near2 = cobblestones_Near2(key, offset, bits);
    near_key_dx2 = key_dx;
    near_key_dy2 = key_dy;
  }
  near_out = near2;
  near_out_key_dx = near_key_dx2;
  near_out_key_dy = near_key_dy2;
}

// nearest, of voronoi (cellular/voronoi.glsl)
cobblestones_Near2 cobblestones_nearest(cobblestones_Look2 look, vec2 look_place_dx,
    vec2 look_place_dy, out float result_key_dx, out float result_key_dy) {
  cobblestones_Near2 near = cobblestones_Near2(1e9, ivec2(0), 0u);
  float near_key_dx = 0.0;
  float near_key_dy = 0.0;
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      cobblestones_Near2 near2;
      float near_key_dx2, near_key_dy2;
      cobblestones_visit(look, ivec2(x, y), near, look_place_dx, look_place_dy, near_key_dx,
          near_key_dy, near2, near_key_dx2, near_key_dy2);
      near = near2;
      near_key_dx = near_key_dx2;
      near_key_dy = near_key_dy2;
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      cobblestones_Near2 near2;
      float near_key_dx2, near_key_dy2;
      cobblestones_visit(look, ivec2(x, y), near, look_place_dx, look_place_dy, near_key_dx,
          near_key_dy, near2, near_key_dx2, near_key_dy2);
      near = near2;
      near_key_dx = near_key_dx2;
      near_key_dy = near_key_dy2;
    }
  }
  result_key_dx = near_key_dx;
  result_key_dy = near_key_dy;
  return near;
}

// gap_to, of voronoi (cellular/voronoi.glsl)
vec2 cobblestones_gap_to(cobblestones_Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.3 - 1e-5;
  return max(difference, 0.0);
}

// half_way, of voronoi (cellular/voronoi.glsl)
float cobblestones_half_way(cobblestones_Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_stones, of voronoi (cellular/voronoi.glsl)
cobblestones_Edge2 cobblestones_border_around_stones(cobblestones_Look2 look,
    cobblestones_Near2 near, vec2 point) {
  float first = distance(point, look.place);
  cobblestones_Edge2 edge = cobblestones_Edge2(1000.0, vec2(0.0));
  for (int y = -1; y < 1; ++y) {
    for (int x = -1; x < 1; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cobblestones_gap_to(look, offset);
      float reach = first + 2.0 * edge.border;
      if (any(notEqual(offset, near.offset)) && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cobblestones_point_of(look, offset, bits);
        float border = cobblestones_half_way(look, point, other);
        edge = border < edge.border ? cobblestones_Edge2(border, other) : edge;
      }
    }
  }
  return edge;
}

// border_around_stones, of voronoi (cellular/voronoi.glsl)
cobblestones_Edge2 cobblestones_border_around_stones2(cobblestones_Look2 look,
    cobblestones_Near2 near, vec2 point, cobblestones_Edge2 edge) {
  float first = distance(point, look.place);
  cobblestones_Edge2 edge2 = edge;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cobblestones_gap_to(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 2 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cobblestones_point_of(look, offset, bits);
        float border = cobblestones_half_way(look, point, other);
        edge2 = border < edge2.border ? cobblestones_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// half_way, of voronoi (cellular/voronoi.glsl)
float cobblestones_half_way2(cobblestones_Look2 look, vec2 point, vec2 other, vec2 look_place_dx,
    vec2 look_place_dy, out float result_dx, out float result_dy) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  result_dx = dot(-look_place_dx, product);
  result_dy = dot(-look_place_dy, product);
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_stones, of voronoi (cellular/voronoi.glsl)
cobblestones_Edge2 cobblestones_border_around_stones3(cobblestones_Look2 look,
    cobblestones_Near2 near, vec2 point, cobblestones_Edge2 edge) {
  float first = distance(point, look.place);
  cobblestones_Edge2 edge2 = edge;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = cobblestones_gap_to(look, offset);
      float reach = first + 2.0 * edge2.border;
      ivec2 magnitude = abs(2 * offset + 1);
      bool test = max(magnitude.x, magnitude.y) >= 4 && any(notEqual(offset, near.offset));
      if (test && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = cobblestones_point_of(look, offset, bits);
        float border = cobblestones_half_way(look, point, other);
        edge2 = border < edge2.border ? cobblestones_Edge2(border, other) : edge2;
      }
    }
  }
  return edge2;
}

// border_of, of voronoi (cellular/voronoi.glsl)
float cobblestones_border_of(cobblestones_Look2 look, cobblestones_Near2 near, vec2 point,
    vec2 look_place_dx, vec2 look_place_dy, out float result_dx, out float result_dy) {
  cobblestones_Edge2 edge = cobblestones_border_around_stones(look, near, point);
  edge = cobblestones_border_around_stones2(look, near, point, edge);
  if (distance(point, look.place) + 2.0 * edge.border > 1.5) {
    edge = cobblestones_border_around_stones3(look, near, point, edge);
  }
  float result_dx2, result_dy2;
  float half_way_value = cobblestones_half_way2(look, point, edge.other, look_place_dx,
      look_place_dy, result_dx2, result_dy2);
  bool test = half_way_value < 0.0;
  result_dx = test ? 0.0 : result_dx2;
  result_dy = test ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void cobblestones_voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float f1, out float border,
    out cobblestones_Tile tile, out float f1_dx, out float f1_dy, out float border_dx,
    out float border_dy, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 9.0;
  vec2 corner = floor(p + 0.5);
  ivec2 numbers = ivec2(corner);
  ivec2 numbers2 = ivec2(cobblestones_wrap_cell_stones(numbers.x, 9),
      cobblestones_wrap_cell_stones(numbers.y, 9));
  cobblestones_Look2 look = cobblestones_Look2(numbers2, p - corner);
  vec2 look_place_dx = uv_dx * 9.0;
  vec2 look_place_dy = uv_dy * 9.0;
  float near_key_dx, near_key_dy;
  cobblestones_Near2 near = cobblestones_nearest(look, look_place_dx, look_place_dy, near_key_dx,
      near_key_dy);
  uint hash_value = cobblestones_hash(near.bits - 1u);
  vec2 product = 0.6 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  vec2 point = vec2(near.offset) + 0.19999999 + product;
  float near_1 = sqrt(near.key);
  bool test = near.key > 0.0;
  float greatest = max(near_1, 1e-20);
  float near_1_dx = test ? 0.5 * near_key_dx / greatest : 0.0;
  float near_1_dy = test ? 0.5 * near_key_dy / greatest : 0.0;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 9.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float f1_slope = 1.0 - blur;
  float border_dx2, border_dy2;
  float border2 = cobblestones_border_of(look, near, point, look_place_dx, look_place_dy,
      border_dx2, border_dy2);
  f1 = mix(near_1, 0.40157345, blur);
  border = border2;
  tile = cobblestones_Tile(near.bits);
  f1_dx = near_1_dx * f1_slope;
  f1_dy = near_1_dy * f1_slope;
  border_dx = border_dx2;
  border_dy = border_dy2;
  tile_local_dx = look_place_dx;
  tile_local_dy = look_place_dy;
}

// joint (tiles/joint.glsl)
float cobblestones_joint(float edge, float width, float edge_dx, float edge_dy) {
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

// secant, of curve (math/curve.glsl)
float cobblestones_secant(int i) {
  vec2 way = cobblestones_points[clamp(i + 1, 0, 4)] - cobblestones_points[clamp(i, 0, 4)];
  return way.y / max(way.x, 1e-7);
}

// slope_at, of curve (math/curve.glsl)
float cobblestones_slope_at(int i) {
  int middle = clamp(i, 1, 3);
  int difference = middle - 1;
  float before = cobblestones_secant(difference);
  float behind = cobblestones_secant(middle);
  float value = cobblestones_points[middle].x;
  float length_before = max(value - cobblestones_points[clamp(difference, 0, 4)].x, 1e-7);
  float length_behind = max(cobblestones_points[middle + 1].x - value, 1e-7);
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

// part_mean, of curve (math/curve.glsl)
float cobblestones_part_mean(int i, float middle, float reach) {
  vec2 from = cobblestones_points[clamp(i, 0, 4)];
  int sum = i + 1;
  vec2 to = cobblestones_points[clamp(sum, 0, 4)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * cobblestones_slope_at(i) - rise;
  float end = rise - way * cobblestones_slope_at(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float cobblestones_curve(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    float next = clamp((cobblestones_points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * cobblestones_part_mean(i, middle, reach);
  }
  return sum + (1.0 - below);
}

// hash (random/hash.glsl)
uvec2 cobblestones_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 cobblestones_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float cobblestones_gradient_noise_perlin(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
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
  uint number = uint(cobblestones_wrap_cell_stones(int(cell.x), 24));
  uint choice = number == 23u ? 0u : number + 1u;
  uint number2 = uint(cobblestones_wrap_cell_stones(int(cell.y), 24));
  uvec2 rows = cobblestones_hash(uvec2(number2, number2 == 23u ? 0u : number2 + 1u) + 129708002u);
  uvec4 hash_value = cobblestones_hash(uvec4(number, choice, number, choice) + rows.xxyy);
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
  vec2 sum2 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum3 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum2.x, sum2.y, fade.y) + difference3 * fade_dx.y) * 0.9340967;
  result_dy = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dy.y) * 0.9340967;
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float cobblestones_fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 24.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 24.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 24.0;
  vec2 p_dy = uv_dy * 24.0;
  float weight = 0.53333336;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 4; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_perlin_value = cobblestones_gradient_noise_perlin(p * frequency + shift,
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

// value_noise (noise/value_noise.glsl)
float cobblestones_value_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 256.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(int(cell.x) & 255);
  uint choice = number == 255u ? 0u : number + 1u;
  uint number2 = uint(int(cell.y) & 255);
  uvec2 rows = cobblestones_hash(uvec2(number2, number2 == 255u ? 0u : number2 + 1u) + 2161170183u);
  uvec4 bits = cobblestones_hash(uvec4(number, choice, number, choice) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 256.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// tile_near (tiles/tile_near.glsl)
float cobblestones_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// tile_random (tiles/tile_random.glsl)
float cobblestones_tile_random_warmth(cobblestones_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  float luck = float(cobblestones_hash(tile.seed + 1u) >> 8u) * 5.9604645e-8;
  return mix(0.5, luck, cobblestones_tile_near(tile_local_dx, tile_local_dy));
}

// tile_random (tiles/tile_random.glsl)
float cobblestones_tile_random_own_tone(cobblestones_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  float luck = float(cobblestones_hash(tile.seed) >> 8u) * 5.9604645e-8;
  return mix(0.55, 1.3, mix(0.5, luck, cobblestones_tile_near(tile_local_dx, tile_local_dy)));
}

// level_dent_tone, of levels (color/levels.glsl)
float cobblestones_level_dent_tone(float value, float value_dx, float value_dy) {
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

// gradient_noise (noise/gradient_noise.glsl)
float cobblestones_gradient_noise_damp(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 5.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * 5.0;
  vec2 t_dy = uv_dy * 5.0;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(cobblestones_wrap_cell_stones(int(cell.x), 5));
  uint choice = number == 4u ? 0u : number + 1u;
  uint number2 = uint(cobblestones_wrap_cell_stones(int(cell.y), 5));
  uvec2 rows = cobblestones_hash(uvec2(number2, number2 == 4u ? 0u : number2 + 1u) + 460041413u);
  uvec4 hash_value = cobblestones_hash(uvec4(number, choice, number, choice) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = t_dx.x * x + t_dx.y * y;
  vec4 corners_dy = t_dy.x * x + t_dy.y * y;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 5.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float amplitude = 0.9340967 * (1.0 - blur);
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum2 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum3 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum2.x, sum2.y, fade.y) + difference3 * fade_dx.y) * amplitude;
  result_dy = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dy.y) * amplitude;
  return mix(blend.x, blend.y, fade.y) * amplitude + 0.5;
}

// level_grown, of levels (color/levels.glsl)
float cobblestones_level_grown(float value, float value_dx, float value_dy) {
  float t = (value - 0.35) * 3.9999995;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 3.9999995, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// voronoi (cellular/voronoi.glsl)
void cobblestones_voronoi2(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float f1, out float border,
    out float f1_dx, out float f1_dy, out float border_dx, out float border_dy) {
  vec2 p = uv * 9.0;
  vec2 corner = floor(p + 0.5);
  ivec2 numbers = ivec2(corner);
  ivec2 numbers2 = ivec2(cobblestones_wrap_cell_stones(numbers.x, 9),
      cobblestones_wrap_cell_stones(numbers.y, 9));
  cobblestones_Look2 look = cobblestones_Look2(numbers2, p - corner);
  vec2 look_place_dx = uv_dx * 9.0;
  vec2 look_place_dy = uv_dy * 9.0;
  float near_key_dx, near_key_dy;
  cobblestones_Near2 near = cobblestones_nearest(look, look_place_dx, look_place_dy, near_key_dx,
      near_key_dy);
  uint hash_value = cobblestones_hash(near.bits - 1u);
  vec2 product = 0.6 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5);
  vec2 point = vec2(near.offset) + 0.19999999 + product;
  float near_1 = sqrt(near.key);
  bool test = near.key > 0.0;
  float greatest = max(near_1, 1e-20);
  float near_1_dx = test ? 0.5 * near_key_dx / greatest : 0.0;
  float near_1_dy = test ? 0.5 * near_key_dy / greatest : 0.0;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 9.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float f1_slope = 1.0 - blur;
  float border_dx2, border_dy2;
  float border2 = cobblestones_border_of(look, near, point, look_place_dx, look_place_dy,
      border_dx2, border_dy2);
  f1 = mix(near_1, 0.40157345, blur);
  border = border2;
  f1_dx = near_1_dx * f1_slope;
  f1_dy = near_1_dy * f1_slope;
  border_dx = border_dx2;
  border_dy = border_dy2;
}

// gradient_noise (noise/gradient_noise.glsl)
float cobblestones_gradient_noise_perlin2(vec2 uv) {
  vec2 base = floor(uv);
  vec2 t = uv - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(cobblestones_wrap_cell_stones(int(cell.x), 24));
  uint choice = number == 23u ? 0u : number + 1u;
  uint number2 = uint(cobblestones_wrap_cell_stones(int(cell.y), 24));
  uvec2 rows = cobblestones_hash(uvec2(number2, number2 == 23u ? 0u : number2 + 1u) + 129708002u);
  uvec4 hash_value = cobblestones_hash(uvec4(number, choice, number, choice) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float cobblestones_fbm2(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 24.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 24.0;
  float width = max(product.x, product.y);
  float weight = 0.53333336;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  for (int octave = 0; octave < 4; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near * (cobblestones_gradient_noise_perlin2(p * frequency + shift)
          - 0.5);
      sum += product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  return sum;
}

// height_at (a function of uv)
float cobblestones_height_at(vec2 uv, float half_gap, vec2 uv_dx, vec2 uv_dy) {
  // stones: voronoi (cellular/voronoi.glsl)
  float stones_f1, stones_border, stones_f1_dx, stones_f1_dy, stones_border_dx, stones_border_dy;
  cobblestones_voronoi2(uv, uv_dx, uv_dy, stones_f1, stones_border, stones_f1_dx, stones_f1_dy,
      stones_border_dx, stones_border_dy);
  // corner: remap (math/remap.glsl)
  float ratio = (stones_f1 - 0.38) / 0.37;
  bool test = ratio < 0.0;
  bool test2 = ratio > 1.0;
  float corner = 0.16 * clamp(ratio, 0.0, 1.0);
  // rounded_border: subtract (math/subtract.glsl)
  float rounded_border = stones_border - corner;
  float corner_dx = (test ? 0.0 : test2 ? 0.0 : stones_f1_dx / 0.37) * 0.16;
  float corner_dy = (test ? 0.0 : test2 ? 0.0 : stones_f1_dy / 0.37) * 0.16;
  float rounded_border_dx = stones_border_dx - corner_dx;
  float rounded_border_dy = stones_border_dy - corner_dy;
  // edge_of_stone: maximum (math/maximum.glsl)
  float edge_of_stone = max(rounded_border, 0.0);
  bool test3 = rounded_border < 0.0;
  float edge_of_stone_dx = test3 ? 0.0 : rounded_border_dx;
  float edge_of_stone_dy = test3 ? 0.0 : rounded_border_dy;
  // sand_between: joint (tiles/joint.glsl)
  float sand_between = cobblestones_joint(edge_of_stone, gap, edge_of_stone_dx, edge_of_stone_dy);
  // inside: subtract (math/subtract.glsl)
  float inside = rounded_border - half_gap;
  // rise: remap (math/remap.glsl)
  float ratio2 = inside / 0.28;
  float rise = clamp(ratio2, 0.0, 1.0);
  bool test4 = ratio2 < 0.0;
  bool test5 = ratio2 > 1.0;
  float rise_dx = test4 ? 0.0 : test5 ? 0.0 : rounded_border_dx / 0.28;
  float rise_dy = test4 ? 0.0 : test5 ? 0.0 : rounded_border_dy / 0.28;
  // edge: curve (math/curve.glsl)
  float edge = cobblestones_curve(rise, rise_dx, rise_dy);
  // from_middle: multiply (math/multiply.glsl)
  float from_middle = stones_f1 * stones_f1;
  // dome: remap (math/remap.glsl)
  float dome = mix(1.0, 0.3, from_middle);
  // rounded: multiply (math/multiply.glsl)
  float rounded = edge * dome;
  // dents: fbm (noise/fbm.glsl)
  float dents = cobblestones_fbm2(uv, uv_dx, uv_dy);
  // grains: value_noise (noise/value_noise.glsl)
  float grains = cobblestones_value_noise(uv, uv_dx, uv_dy);
  // dent_height: multiply (math/multiply.glsl)
  float dent_height = dents * 0.3;
  // stone_height: add (math/add.glsl)
  float stone_height = rounded + dent_height;
  // sand_height: multiply (math/multiply.glsl)
  float sand_height = grains * 0.1;
  // height: lerp (math/lerp.glsl)
  float height = mix(stone_height, sand_height, sand_between);
  return height;
}

// height_to_normal (filters/height_to_normal.glsl)
vec3 cobblestones_height_to_normal(float half_gap, vec2 uv, float strength, vec2 uv_dx,
    vec2 uv_dy) {
  vec2 apart = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.0005);
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  float height_at_value = cobblestones_height_at(uv + across, half_gap, uv_dx, uv_dy);
  float difference = height_at_value - cobblestones_height_at(uv - across, half_gap, uv_dx, uv_dy);
  float height_at_value2 = cobblestones_height_at(uv + along, half_gap, uv_dx, uv_dy);
  vec2 rise = vec2(difference, height_at_value2
      - cobblestones_height_at(uv - along, half_gap, uv_dx, uv_dy));
  vec3 normal = vec3(-strength * rise / apart, 1.0);
  return normal * inversesqrt(dot(normal, normal));
}

void cobblestones(vec2 uv, out vec4 color, out vec3 normal, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // stones: voronoi (cellular/voronoi.glsl)
  float stones_f1, stones_border, stones_f1_dx, stones_f1_dy, stones_border_dx, stones_border_dy;
  cobblestones_Tile stones_tile;
  vec2 stones_tile_local_dx, stones_tile_local_dy;
  cobblestones_voronoi(uv, uv_dx, uv_dy, stones_f1, stones_border, stones_tile, stones_f1_dx,
      stones_f1_dy, stones_border_dx, stones_border_dy, stones_tile_local_dx, stones_tile_local_dy);
  // corner: remap (math/remap.glsl)
  float ratio = (stones_f1 - 0.38) / 0.37;
  bool test = ratio < 0.0;
  bool test2 = ratio > 1.0;
  float corner = 0.16 * clamp(ratio, 0.0, 1.0);
  // rounded_border: subtract (math/subtract.glsl)
  float rounded_border = stones_border - corner;
  float corner_dx = (test ? 0.0 : test2 ? 0.0 : stones_f1_dx / 0.37) * 0.16;
  float corner_dy = (test ? 0.0 : test2 ? 0.0 : stones_f1_dy / 0.37) * 0.16;
  float rounded_border_dx = stones_border_dx - corner_dx;
  float rounded_border_dy = stones_border_dy - corner_dy;
  // edge_of_stone: maximum (math/maximum.glsl)
  float edge_of_stone = max(rounded_border, 0.0);
  bool test3 = rounded_border < 0.0;
  float edge_of_stone_dx = test3 ? 0.0 : rounded_border_dx;
  float edge_of_stone_dy = test3 ? 0.0 : rounded_border_dy;
  // sand_between: joint (tiles/joint.glsl)
  float sand_between = cobblestones_joint(edge_of_stone, gap, edge_of_stone_dx, edge_of_stone_dy);
  // half_gap: multiply (math/multiply.glsl)
  float half_gap = gap * 0.5;
  // inside: subtract (math/subtract.glsl)
  float inside = rounded_border - half_gap;
  // rise: remap (math/remap.glsl)
  float ratio2 = inside / 0.28;
  float rise = clamp(ratio2, 0.0, 1.0);
  bool test4 = ratio2 < 0.0;
  bool test5 = ratio2 > 1.0;
  float rise_dx = test4 ? 0.0 : test5 ? 0.0 : rounded_border_dx / 0.28;
  float rise_dy = test4 ? 0.0 : test5 ? 0.0 : rounded_border_dy / 0.28;
  // edge: curve (math/curve.glsl)
  float edge = cobblestones_curve(rise, rise_dx, rise_dy);
  // from_middle: multiply (math/multiply.glsl)
  float from_middle = stones_f1 * stones_f1;
  // dome: remap (math/remap.glsl)
  float dome = mix(1.0, 0.3, from_middle);
  // rounded: multiply (math/multiply.glsl)
  float rounded = edge * dome;
  // dents: fbm (noise/fbm.glsl)
  float dents_dx, dents_dy;
  float dents = cobblestones_fbm(uv, uv_dx, uv_dy, dents_dx, dents_dy);
  // grains: value_noise (noise/value_noise.glsl)
  float grains = cobblestones_value_noise(uv, uv_dx, uv_dy);
  // warmth: tile_random (tiles/tile_random.glsl)
  float warmth = cobblestones_tile_random_warmth(stones_tile, stones_tile_local_dx,
      stones_tile_local_dy);
  // rock: lerp (math/lerp.glsl)
  vec3 rock = mix(vec3(0.16, 0.175, 0.2), vec3(0.34, 0.27, 0.21), warmth);
  // own_tone: tile_random (tiles/tile_random.glsl)
  float own_tone = cobblestones_tile_random_own_tone(stones_tile, stones_tile_local_dx,
      stones_tile_local_dy);
  // dent_tone: levels (color/levels.glsl)
  float dent_tone = mix(0.7, 1.2, cobblestones_level_dent_tone(dents, dents_dx, dents_dy));
  // wear: remap (math/remap.glsl)
  float wear = mix(0.6, 1.1, rounded);
  // worn: multiply (math/multiply.glsl)
  float worn = dent_tone * wear;
  // tone: multiply (math/multiply.glsl)
  float tone = worn * own_tone;
  // stone: multiply (math/multiply.glsl)
  vec3 stone = rock * tone;
  // sand: lerp (math/lerp.glsl)
  vec3 sand = mix(vec3(0.1, 0.08, 0.055), vec3(0.3, 0.245, 0.17), grains);
  // tufts: lerp (math/lerp.glsl)
  vec3 tufts = mix(vec3(0.018, 0.035, 0.006), vec3(0.1, 0.15, 0.02), grains);
  // damp: gradient_noise (noise/gradient_noise.glsl)
  float damp_dx, damp_dy;
  float damp = cobblestones_gradient_noise_damp(uv, uv_dx, uv_dy, damp_dx, damp_dy);
  // grown: levels (color/levels.glsl)
  float grown = cobblestones_level_grown(damp, damp_dx, damp_dy);
  // moss_there: multiply (math/multiply.glsl)
  float moss_there = grown * moss_cover;
  // ground: lerp (math/lerp.glsl)
  vec3 ground = mix(sand, tufts, moss_there);
  // paving: lerp (math/lerp.glsl)
  vec3 paving = mix(stone, ground, sand_between);
  // color: rgba (channels/rgba.glsl)
  vec4 color2 = vec4(paving, 1.0);
  // relief: height_to_normal (filters/height_to_normal.glsl)
  vec3 relief = cobblestones_height_to_normal(half_gap, uv, depth, uv_dx, uv_dy);
  // dent_height: multiply (math/multiply.glsl)
  float dent_height = dents * 0.3;
  // stone_height: add (math/add.glsl)
  float stone_height = rounded + dent_height;
  // sand_height: multiply (math/multiply.glsl)
  float sand_height = grains * 0.1;
  // height: lerp (math/lerp.glsl)
  float height2 = mix(stone_height, sand_height, sand_between);
  // roughness: lerp (math/lerp.glsl)
  float roughness2 = mix(0.5, 0.95, sand_between);
  color = color2;
  normal = relief;
  height = height2;
  roughness = roughness2;
}
