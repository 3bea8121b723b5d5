// circles: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Types
struct circles_Copy {
  uint seed;
  uint luck;
  vec2 from;
};
struct circles_View {
  vec3 light;
  float through;
};

// Constants
const vec3 circles_colors[8] = vec3[8](vec3(0.65, 0.04, 0.03), vec3(0.85, 0.3, 0.02),
    vec3(0.9, 0.65, 0.1), vec3(0.1, 0.35, 0.08), vec3(0.02, 0.25, 0.3), vec3(0.03, 0.1, 0.45),
    vec3(0.3, 0.05, 0.3), vec3(0.85, 0.8, 0.7));

// copy_bits (bombing/copy_bits.glsl)
uvec4 circles_copy_bits(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at, of bomb (bombing/bomb.glsl)
circles_Copy circles_copy_at(vec2 p, vec2 node) {
  uvec4 bits = circles_copy_bits(ivec2(node));
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  circles_Copy copy = circles_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// find_next, of bomb (bombing/bomb.glsl)
void circles_find_next(vec2 p, uint last, out uint last_out, out circles_Copy found) {
  circles_Copy found2 = circles_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 4; ++i) {
    vec2 node = floor(p) + vec2(ivec2(i % 2, i / 2));
    circles_Copy copy = circles_copy_at(p, node);
    uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25));
    bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
    found2 = is_next ? copy : found2;
    best = is_next ? copy.luck : best;
  }
  last_out = best;
  found = found2;
}

// edge_of, of bomb (bombing/bomb.glsl)
float circles_edge_of(vec2 arm, vec2 arm_dx, vec2 arm_dy) {
  vec2 change = vec2(dot(arm, arm_dx), dot(arm, arm_dy));
  return clamp((0.125 - 0.5 * dot(arm, arm)) / max(length(change), 1e-9), 0.0, 1.0);
}

// paint, of bomb (bombing/bomb.glsl)
vec4 circles_paint(circles_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  float edge = circles_edge_of(copy.from, copy_from_dx, copy_from_dy);
  vec4 seen = vec4(circles_colors[int(copy.seed >> 29u)], edge);
  return seen;
}

// by_rank, of bomb (bombing/bomb.glsl)
circles_View circles_by_rank(vec2 p, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    circles_Copy copy;
    circles_find_next(p, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = circles_paint(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return circles_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 circles_bomb(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0 - 0.5;
  vec2 p_dx = uv_dx * 8.0;
  vec2 p_dy = uv_dy * 8.0;
  circles_View view = circles_by_rank(p, p_dx, p_dy);
  vec3 below = vec3(0.02, 0.03, 0.08) * view.through;
  vec4 color = vec4(view.light + below, 1.0);
  return color;
}

vec4 circles(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // discs: bomb (bombing/bomb.glsl)
  vec4 discs_color = circles_bomb(uv, uv_dx, uv_dy);
  return discs_color;
}
