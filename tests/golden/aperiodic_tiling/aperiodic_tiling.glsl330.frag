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
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 64.0;
  vec2 whole = floor(product);
  // pattern: virtual_indirection_map (indirection/virtual_indirection_map.glsl)
  int pattern = int(cell_hash(ivec2(whole)) >> 28u);
  // meadow: reference_texture (indirection/reference_texture.glsl)
  vec3 vector = vec3(product - whole, float(pattern));
  vec4 meadow = textureGrad(grounds, vector, uv_dx * 64.0, uv_dy * 64.0);
  out_color = meadow;
}
