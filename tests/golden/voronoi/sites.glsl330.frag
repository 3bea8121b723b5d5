// sites: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float line;  // default 0.03
uniform float dots_radius;  // default 0.07

// Outputs
layout(location = 0) out vec4 out_color;

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

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(2161170183u, 2614696773u);
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
  uint bits2 = cell_hash(look.corner + offset);
  uint hash_value = hash(bits2 - 1u);
  bits = bits2;
  return vec2(offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
}

// visit, of voronoi (cellular/voronoi.glsl)
void visit(Look2 look, ivec2 offset, Near2 near, vec2 look_place_dx, vec2 look_place_dy,
    float near_key_dx, float near_key_dy, out Near2 near_out, out float near_out_key_dx,
    out float near_out_key_dy) {
  uint bits;
  vec2 point = point_of(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  float projection = dot(-look_place_dx, difference);
  float key_dx = projection + projection;
  float projection2 = dot(-look_place_dy, difference);
  float key_dy = projection2 + projection2;
  Near2 near2 = near;
  float near_key_dx2 = near_key_dx;
  float near_key_dy2 = near_key_dy;
  if (key < near.key) {
    near2 = Near2(key, offset, bits);
    near_key_dx2 = key_dx;
    near_key_dy2 = key_dy;
  }
  near_out = near2;
  near_out_key_dx = near_key_dx2;
  near_out_key_dy = near_key_dy2;
}

// nearest, of voronoi (cellular/voronoi.glsl)
Near2 nearest(Look2 look, vec2 look_place_dx, vec2 look_place_dy, out float result_key_dx,
    out float result_key_dy) {
  Near2 near = Near2(1e9, ivec2(0), 0u);
  float near_key_dx = 0.0;
  float near_key_dy = 0.0;
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      Near2 near2;
      float near_key_dx2, near_key_dy2;
      visit(look, ivec2(x, y), near, look_place_dx, look_place_dy, near_key_dx, near_key_dy, near2,
          near_key_dx2, near_key_dy2);
      near = near2;
      near_key_dx = near_key_dx2;
      near_key_dy = near_key_dy2;
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      Near2 near2;
      float near_key_dx2, near_key_dy2;
      visit(look, ivec2(x, y), near, look_place_dx, look_place_dy, near_key_dx, near_key_dy, near2,
          near_key_dx2, near_key_dy2);
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
vec2 gap_to(Look2 look, ivec2 offset) {
  vec2 difference = abs(vec2(offset) + 0.5 - look.place) - 0.5 - 1e-5;
  return max(difference, 0.0);
}

// half_way, of voronoi (cellular/voronoi.glsl)
float half_way(Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  vec2 product = across * inversesqrt(max(dot(across, across), 1e-12));
  return dot(0.5 * (point + other) - look.place, product);
}

// border_around_cells, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_cells(Look2 look, Near2 near, vec2 point) {
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

// border_around_cells, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_cells2(Look2 look, Near2 near, vec2 point, Edge2 edge) {
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

// border_around_cells, of voronoi (cellular/voronoi.glsl)
Edge2 border_around_cells3(Look2 look, Near2 near, vec2 point, Edge2 edge) {
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
  Edge2 edge = border_around_cells(look, near, point);
  edge = border_around_cells2(look, near, point, edge);
  bool test = distance(point, look.place) + 2.0 * edge.border > 1.5;
  edge = test ? border_around_cells3(look, near, point, edge) : edge;
  float result_dx2, result_dy2;
  float half_way_value = half_way2(look, point, edge.other, look_place_dx, look_place_dy,
      result_dx2, result_dy2);
  bool test2 = half_way_value < 0.0;
  result_dx = test2 ? 0.0 : result_dx2;
  result_dy = test2 ? 0.0 : result_dy2;
  return max(half_way_value, 0.0);
}

// voronoi (cellular/voronoi.glsl)
void voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float f1, out float border, out Tile tile,
    out float f1_dx, out float f1_dy, out float border_dx, out float border_dy,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 6.0;
  vec2 corner = floor(p + 0.5);
  Look2 look = Look2(ivec2(corner), p - corner);
  vec2 look_place_dx = uv_dx * 6.0;
  vec2 look_place_dy = uv_dy * 6.0;
  float near_key_dx, near_key_dy;
  Near2 near = nearest(look, look_place_dx, look_place_dy, near_key_dx, near_key_dy);
  uint hash_value = hash(near.bits - 1u);
  vec2 point = vec2(near.offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
      * 1.5258789e-5;
  float near_1 = sqrt(near.key);
  bool test = near.key > 0.0;
  float greatest = max(near_1, 1e-20);
  float near_1_dx = test ? 0.5 * near_key_dx / greatest : 0.0;
  float near_1_dy = test ? 0.5 * near_key_dy / greatest : 0.0;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 6.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float f1_slope = 1.0 - blur;
  float border_dx2, border_dy2;
  float border2 = border_of(look, near, point, look_place_dx, look_place_dy, border_dx2,
      border_dy2);
  f1 = mix(near_1, 0.4298, blur);
  border = border2;
  tile = Tile(near.bits);
  f1_dx = near_1_dx * f1_slope;
  f1_dy = near_1_dy * f1_slope;
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

// sdf_fill (shapes/sdf_fill.glsl)
float sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// random3 (random/random3.glsl)
vec3 random3(uint seed) {
  uint bits = hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // cells: voronoi (cellular/voronoi.glsl)
  float cells_f1, cells_border, cells_f1_dx, cells_f1_dy, cells_border_dx, cells_border_dy;
  Tile cells_tile;
  vec2 cells_tile_local_dx, cells_tile_local_dy;
  voronoi(uv, uv_dx, uv_dy, cells_f1, cells_border, cells_tile, cells_f1_dx, cells_f1_dy,
      cells_border_dx, cells_border_dy, cells_tile_local_dx, cells_tile_local_dy);
  // lines: joint (tiles/joint.glsl)
  float lines = joint(cells_border, line, cells_border_dx, cells_border_dy);
  // from_rim: subtract (math/subtract.glsl)
  float from_rim = cells_f1 - dots_radius;
  // dots: sdf_fill (shapes/sdf_fill.glsl)
  float dots = sdf_fill(from_rim, cells_f1_dx, cells_f1_dy);
  // ink: maximum (math/maximum.glsl)
  float ink = max(lines, dots);
  // wash: tile_random_color (tiles/tile_random_color.glsl)
  vec3 vector = vec3(tile_near(cells_tile_local_dx, cells_tile_local_dy));
  vec3 blend = mix(vec3(0.5), random3(cells_tile.seed), vector);
  vec3 wash = mix(vec3(0.78, 0.76, 0.68), vec3(0.9, 0.87, 0.78), blend);
  // paper: lerp (math/lerp.glsl)
  vec3 paper = mix(wash, vec3(0.02, 0.025, 0.05), ink);
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(paper, 1.0);
  out_color = color;
}
