// grass_permutation: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Textures
uniform sampler2D grass_atlas;
uniform sampler2D permuted;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

// tile_index (by_example/tile_index.glsl)
int tile_index(int first, int second) {
  int low;
  if (second > 0) {
    low = first * first + 2 * second - 1;
  } else {
    low = first * (first + 2);
  }
  return first < second ? 2 * first + second * second : low;
}

// permutation_wang_tiles (by_example/permutation_wang_tiles.glsl)
vec4 permutation_wang_tiles(sampler2D tiles, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 16.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 numbers = ivec2(whole);
  ivec2 cell = numbers & 63;
  ivec2 next = (numbers + 1) & 63;
  int column = int(texelFetch(permuted, ivec2(cell.x & 63, 0), 0).x);
  int row = int(texelFetch(permuted, ivec2((2 * cell.y) & 63, 0), 0).x);
  int number = int(texelFetch(permuted, ivec2((column + cell.y) % 64, 0), 0).x);
  int south = number % 2;
  int east = int(texelFetch(permuted, ivec2((next.x + row) % 64, 0), 0).x) % 2;
  int number2 = int(texelFetch(permuted, ivec2((column + next.y) % 64, 0), 0).x);
  int north = number2 % 2;
  int west = int(texelFetch(permuted, ivec2((cell.x + row) % 64, 0), 0).x) % 2;
  ivec2 place = ivec2(tile_index(west, east), tile_index(south, north));
  vec4 color = textureGrad(tiles, (vec2(place) + local) * 0.25, uv_dx * 4.0, uv_dy * 4.0);
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // meadow: permutation_wang_tiles (by_example/permutation_wang_tiles.glsl)
  vec4 meadow_color = permutation_wang_tiles(grass_atlas, uv, uv_dx, uv_dy);
  out_color = meadow_color;
  out_roughness = 0.9;
}
