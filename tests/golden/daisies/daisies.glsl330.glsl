// daisies: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2D daisy;

// Types
struct daisies_Copy {
  uint luck;
  vec2 from;
};
struct daisies_View {
  vec3 light;
  float through;
};

// copy_bits (bombing/copy_bits.glsl)
uvec4 daisies_copy_bits(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at, of bomb (bombing/bomb.glsl)
daisies_Copy daisies_copy_at(vec2 p, vec2 node) {
  uvec4 bits = daisies_copy_bits(ivec2(node));
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  daisies_Copy copy = daisies_Copy(bits.z, p - node - moved);
  return copy;
}

// find_next, of bomb (bombing/bomb.glsl)
void daisies_find_next(vec2 p, uint last, out uint last_out, out daisies_Copy found) {
  daisies_Copy found2 = daisies_Copy(0u, p);
  uint best = 0u;
  for (int i = 0; i < 4; ++i) {
    vec2 node = floor(p) + vec2(ivec2(i % 2, i / 2));
    daisies_Copy copy = daisies_copy_at(p, node);
    uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25));
    bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
    found2 = is_next ? copy : found2;
    best = is_next ? copy.luck : best;
  }
  last_out = best;
  found = found2;
}

// paint, of bomb (bombing/bomb.glsl)
vec4 daisies_paint(daisies_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec4 seen = textureGrad(daisy, copy.from + 0.5, copy_from_dx, copy_from_dy);
  return seen;
}

// by_rank, of bomb (bombing/bomb.glsl)
daisies_View daisies_by_rank(vec2 p, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    daisies_Copy copy;
    daisies_find_next(p, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = daisies_paint(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return daisies_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 daisies_bomb(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0 - 0.5;
  vec2 p_dx = uv_dx * 8.0;
  vec2 p_dy = uv_dy * 8.0;
  daisies_View view = daisies_by_rank(p, p_dx, p_dy);
  vec3 below = vec3(0.07, 0.2, 0.03) * view.through;
  vec4 color = vec4(view.light + below, 1.0);
  return color;
}

vec4 daisies(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // meadow: bomb (bombing/bomb.glsl)
  vec4 meadow_color = daisies_bomb(uv, uv_dx, uv_dy);
  return meadow_color;
}
