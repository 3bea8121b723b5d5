// spheres: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Types
struct spheres_Tile3 {
  uint seed;
};
struct spheres_Copy {
  uint seed;
  uint luck;
  vec3 from;
};
struct spheres_View {
  vec3 light;
};

// Constants
const vec3 spheres_colors[8] = vec3[8](vec3(0.65, 0.04, 0.03), vec3(0.85, 0.3, 0.02),
    vec3(0.9, 0.65, 0.1), vec3(0.1, 0.35, 0.08), vec3(0.02, 0.25, 0.3), vec3(0.03, 0.1, 0.45),
    vec3(0.3, 0.05, 0.3), vec3(0.85, 0.8, 0.7));

// copy_bits3 (bombing/copy_bits3.glsl)
void spheres_copy_bits3(ivec3 cell, out uvec3 place, out uint luck, out uint bits) {
  uvec3 v = uvec3(cell) * 1664525u + uvec3(129708002u, 817759070u, 2145236065u);
  uint sum = v.x + v.y * v.z;
  uint sum2 = v.y + v.z * sum;
  v = uvec3(sum, sum2, v.z + sum * sum2);
  v ^= v >> 16u;
  uint sum3 = v.x + v.y * v.z;
  uint sum4 = v.y + v.z * sum3;
  uint bits2 = v.z + sum3 * sum4;
  place = uvec3(sum3, sum4, sum3 * 3266489917u + sum4 * 668265263u + bits2 * 374761393u);
  luck = sum3 * 1597334677u + sum4 * 3432918353u + bits2 * 461845907u;
  bits = bits2;
}

// copy_at, of bomb3 (bombing/bomb3.glsl)
spheres_Copy spheres_copy_at(vec3 p, vec3 node) {
  uvec3 place;
  uint luck, bits;
  spheres_copy_bits3(ivec3(node), place, luck, bits);
  spheres_Copy copy = spheres_Copy(bits, luck, p - node - vec3(ivec3(place)) * 2.3283064e-10);
  return copy;
}

// find_next, of bomb3 (bombing/bomb3.glsl)
void spheres_find_next(vec3 p, vec3 corner, uint last, out uint last_out, out spheres_Copy found) {
  spheres_Copy found2 = spheres_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 8; ++i) {
    vec3 node = corner + vec3(ivec3(i % 2, i / 2 % 2, i / 4));
    spheres_Copy copy = spheres_copy_at(p, node);
    bool is_next = best < copy.luck && copy.luck < last;
    bool test = is_next && dot(copy.from, copy.from) < 0.25;
    found2 = test ? copy : found2;
    best = test ? copy.luck : best;
  }
  last_out = best;
  found = found2;
}

// edge_of, of bomb3 (bombing/bomb3.glsl)
float spheres_edge_of(vec3 arm, vec3 arm_dx, vec3 arm_dy) {
  vec2 change = vec2(dot(arm, arm_dx), dot(arm, arm_dy));
  float pixel = 0.0253303 * dot(arm_dx, arm_dx) * dot(arm_dy, arm_dy);
  float width = sqrt(max(max(dot(change, change), pixel), 1e-18));
  return clamp((0.125 - 0.5 * dot(arm, arm)) / width, 0.0, 1.0);
}

// ball (function of the graph)
vec4 spheres_ball(vec3 position, spheres_Tile3 tile) {
  // paint: tile_palette (tiles/tile_palette.glsl)
  vec3 paint = spheres_colors[int(tile.seed >> 29u)];
  // arm: subtract (math/subtract.glsl)
  vec3 arm = position - 0.5;
  // towards_light: dot_product (math/dot_product.glsl)
  float towards_light = dot(arm, vec3(0.5, 0.75, 0.3));
  // factor: remap (math/remap.glsl)
  float factor = mix(0.3, 1.0, towards_light);
  // lit: multiply (math/multiply.glsl)
  vec3 lit = paint * factor;
  // opaque: rgba (channels/rgba.glsl)
  vec4 opaque = vec4(lit, 1.0);
  return opaque;
}

// paint, of bomb3 (bombing/bomb3.glsl)
vec4 spheres_paint(spheres_Copy copy, vec3 copy_from_dx, vec3 copy_from_dy) {
  spheres_Tile3 tile = spheres_Tile3(copy.seed);
  float edge = spheres_edge_of(copy.from, copy_from_dx, copy_from_dy);
  vec4 seen = spheres_ball(copy.from + 0.5, tile);
  seen = vec4(seen.xyz, edge);
  return seen;
}

// by_rank, of bomb3 (bombing/bomb3.glsl)
spheres_View spheres_by_rank(vec3 p, vec3 corner, vec3 p_dx, vec3 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    spheres_Copy copy;
    spheres_find_next(p, corner, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = spheres_paint(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return spheres_View(sum.xyz);
}

// bomb3 (bombing/bomb3.glsl)
vec4 spheres_bomb3(vec3 uv, vec3 uv_dx, vec3 uv_dy) {
  vec3 p = uv * 8.0 - 0.5;
  vec3 corner = floor(p);
  vec3 p_dx = uv_dx * 8.0;
  vec3 p_dy = uv_dy * 8.0;
  spheres_View view = spheres_by_rank(p, corner, p_dx, p_dy);
  vec4 color = vec4(view.light, 1.0);
  return color;
}

vec4 spheres(vec3 position) {
  vec3 position_dx = dFdx(position), position_dy = dFdy(position);
  // balls: bomb3 (bombing/bomb3.glsl)
  vec4 balls_color = spheres_bomb3(position, position_dx, position_dy);
  return balls_color;
}
