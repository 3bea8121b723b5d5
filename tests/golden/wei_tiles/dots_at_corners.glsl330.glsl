// dots_at_corners: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2D dots;

// hash (random/hash.glsl)
uvec2 dots_at_corners_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 dots_at_corners_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// corner_tile_place (by_example/corner_tile_place.glsl)
ivec2 dots_at_corners_corner_tile_place(ivec4 corners) {
  int bit = 2 * (corners.x + 2 * corners.y + 4 * corners.z + 8 * corners.w);
  return ivec2(uvec2(825968358u >> uint(bit), 259139418u >> uint(bit)) & 3u);
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 dots_at_corners_corner_tiles(sampler2D tiles, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 6.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 cell = ivec2(whole);
  ivec2 next = cell + 1;
  uvec2 rows = dots_at_corners_hash(uvec2(uint(cell.y), uint(next.y)) + 2131687100u);
  uvec4 sum = uvec4(uint(cell.x), uint(next.x), uint(cell.x), uint(next.x)) + rows.xxyy;
  uvec4 bits = dots_at_corners_hash(sum);
  ivec2 place = dots_at_corners_corner_tile_place(ivec4(bits & 1u));
  vec4 color = textureGrad(tiles, (vec2(place) + local) * 0.25, uv_dx * 1.5, uv_dy * 1.5);
  return color;
}

vec4 dots_at_corners(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // spots: corner_tiles (by_example/corner_tiles.glsl)
  vec4 spots_color = dots_at_corners_corner_tiles(dots, uv, uv_dx, uv_dy);
  return spots_color;
}
