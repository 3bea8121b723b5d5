// aperiodic_tiling: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Textures
uniform sampler2DArray grounds;

// Outputs
layout(location = 0) out vec4 out_color;

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

void main() {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 64.0;
  // pattern: virtual_indirection_map (indirection/virtual_indirection_map.glsl)
  int pattern = int(cell_hash(ivec2(floor(product))) >> 28u);
  // meadow: reference_texture (indirection/reference_texture.glsl)
  vec4 meadow = texture(grounds, vec3(product, float(pattern)));
  out_color = meadow;
}
