// moving_sprites: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2DArray insects;
uniform sampler2DArray crowd;
uniform sampler2DArray meadows;

// Types
struct moving_sprites_Tile {
  ivec2 cell;
  vec2 local;
};

// cell_hash (indirection/cell_hash.glsl)
uint moving_sprites_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(2131687100u, 3540083553u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// explicit_positioning (indirection/explicit_positioning.glsl)
void moving_sprites_explicit_positioning(moving_sprites_Tile tile, int layer, vec2 tile_local_dx,
    vec2 tile_local_dy, out int pattern, out moving_sprites_Tile inner, out float coverage) {
  ivec2 cell = tile.cell & 7;
  vec4 sprite = texelFetch(crowd, ivec3(cell, clamp(layer, 0, 3)), 0);
  vec2 q = tile.local - sprite.xy;
  int pattern2 = layer < 0 || layer >= 4 ? -1 : int(sprite.z);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  vec2 sum = (0.5 - abs(q - 0.5)) / clamp(width, 1e-5, 1.0) + 0.5;
  vec2 share = clamp(sum, 0.0, 1.0);
  vec2 part = max(1.0 - abs(sprite.xy), 0.0);
  float away = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float coverage2 = 0.0;
  if (!(pattern2 < 0)) {
    coverage2 = mix(share.x * share.y, part.x * part.y, away);
  }
  pattern = pattern2;
  inner = moving_sprites_Tile(cell + ivec2(floor(sprite.xy + 0.5)), q);
  coverage = coverage2;
}

// texture_sprites (indirection/texture_sprites.glsl)
vec4 moving_sprites_texture_sprites(sampler2DArray patterns, moving_sprites_Tile tile,
    vec2 tile_local_dx, vec2 tile_local_dy) {
  vec4 sum = vec4(0.0);
  for (int layer = 3; layer > -1 && sum.w < 0.999; --layer) {
    int pattern;
    moving_sprites_Tile inner;
    float coverage;
    moving_sprites_explicit_positioning(tile, layer, tile_local_dx, tile_local_dy, pattern, inner,
        coverage);
    vec4 texel = textureGrad(patterns, vec3(inner.local, float(pattern)), tile_local_dx,
        tile_local_dy);
    vec4 color = pattern < 0 ? vec4(0.0) : texel;
    float below = color.w * coverage * (1.0 - sum.w);
    sum += vec4(color.xyz * below, below);
  }
  return vec4(sum.xyz / max(sum.w, 1e-20), sum.w);
}

vec4 moving_sprites(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grass_cells: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 4.0;
  // grass_pattern: virtual_indirection_map (indirection/virtual_indirection_map.glsl)
  int grass_pattern = int(moving_sprites_cell_hash(ivec2(floor(product))) >> 28u);
  // grass: reference_texture (indirection/reference_texture.glsl)
  vec4 grass = texture(meadows, vec3(product, float(grass_pattern)));
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product2 = uv * 8.0;
  vec2 whole = floor(product2);
  moving_sprites_Tile grid = moving_sprites_Tile(ivec2(whole), product2 - whole);
  vec2 grid_local_dx = uv_dx * 8.0;
  vec2 grid_local_dy = uv_dy * 8.0;
  // seen: texture_sprites (indirection/texture_sprites.glsl)
  vec4 seen = moving_sprites_texture_sprites(insects, grid, grid_local_dx, grid_local_dy);
  // garden: over (layers/over.glsl)
  float blend = mix(grass.w, 1.0, seen.w);
  vec4 garden = vec4(mix(grass.xyz, seen.xyz, seen.w / max(blend, 1e-20)), blend);
  return garden;
}
