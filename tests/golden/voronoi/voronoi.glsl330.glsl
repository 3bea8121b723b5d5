// voronoi: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float darkness;  // default 0.9

// Types
struct voronoi_Tile {
  uint seed;
};
struct voronoi_Look2 {
  ivec2 corner;
  vec2 place;
};
struct voronoi_Near2 {
  float key;
  uint bits;
};

// cell_hash (indirection/cell_hash.glsl)
uint voronoi_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(2161170183u, 2614696773u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint voronoi_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// point_of, of voronoi (cellular/voronoi.glsl)
vec2 voronoi_point_of(voronoi_Look2 look, ivec2 offset, out uint bits) {
  uint bits2 = voronoi_cell_hash(look.corner + offset);
  uint hash_value = voronoi_hash(bits2 - 1u);
  bits = bits2;
  return vec2(offset) + vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
}

// visit, of voronoi (cellular/voronoi.glsl)
voronoi_Near2 voronoi_visit(voronoi_Look2 look, ivec2 offset, voronoi_Near2 near) {
  uint bits;
  vec2 point = voronoi_point_of(look, offset, bits);
  vec2 difference = point - look.place;
  float key = dot(difference, difference);
  voronoi_Near2 near2 = key < near.key ? voronoi_Near2(key, bits) : near;
  return near2;
}

// nearest, of voronoi (cellular/voronoi.glsl)
voronoi_Near2 voronoi_nearest(voronoi_Look2 look) {
  voronoi_Near2 near = voronoi_Near2(1e9, 0u);
  for (int y = -1; y < 1; ++y) {
    for (int x = -2; x < 2; ++x) {
      near = voronoi_visit(look, ivec2(x, y), near);
    }
  }
  for (int y = -2; y < 4; y += 3) {
    for (int x = -1; x < 1; ++x) {
      near = voronoi_visit(look, ivec2(x, y), near);
    }
  }
  return near;
}

// voronoi (cellular/voronoi.glsl)
void voronoi_voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float f1, out voronoi_Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 12.0;
  vec2 corner = floor(p + 0.5);
  voronoi_Look2 look = voronoi_Look2(ivec2(corner), p - corner);
  voronoi_Near2 near = voronoi_nearest(look);
  float near_1 = sqrt(near.key);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 12.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  f1 = mix(near_1, 0.4298, blur);
  tile = voronoi_Tile(near.bits);
  tile_local_dx = uv_dx * 12.0;
  tile_local_dy = uv_dy * 12.0;
}

// random3 (random/random3.glsl)
vec3 voronoi_random3(uint seed) {
  uint bits = voronoi_hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(voronoi_hash(bits) >> 8u) * 5.9604645e-8);
}

// tile_near (tiles/tile_near.glsl)
float voronoi_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

vec4 voronoi(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // cells: voronoi (cellular/voronoi.glsl)
  float cells_f1;
  voronoi_Tile cells_tile;
  vec2 cells_tile_local_dx, cells_tile_local_dy;
  voronoi_voronoi(uv, uv_dx, uv_dy, cells_f1, cells_tile, cells_tile_local_dx, cells_tile_local_dy);
  // region: tile_random_color (tiles/tile_random_color.glsl)
  vec3 vector = vec3(voronoi_tile_near(cells_tile_local_dx, cells_tile_local_dy));
  vec3 blend = mix(vec3(0.5), voronoi_random3(cells_tile.seed), vector);
  vec3 region = mix(vec3(0.35, 0.2, 0.1), vec3(1.0, 0.9, 0.6), blend);
  // square: multiply (math/multiply.glsl)
  float square = cells_f1 * cells_f1;
  // shade: multiply (math/multiply.glsl)
  float shade = square * darkness;
  // light: invert (math/invert.glsl)
  float light = 1.0 - shade;
  // lit: multiply (math/multiply.glsl)
  vec3 lit = region * light;
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(lit, 1.0);
  return color;
}
