// aperiodic_tiling: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2DArray grounds;

// cell_hash (indirection/cell_hash.glsl)
uint aperiodic_tiling_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

vec4 aperiodic_tiling(vec2 uv) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 64.0;
  // pattern: virtual_indirection_map (indirection/virtual_indirection_map.glsl)
  int pattern = int(aperiodic_tiling_cell_hash(ivec2(floor(product))) >> 28u);
  // meadow: reference_texture (indirection/reference_texture.glsl)
  vec4 meadow = texture(grounds, vec3(product, float(pattern)));
  return meadow;
}
