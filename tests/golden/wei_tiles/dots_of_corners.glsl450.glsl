// dots_of_corners: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2D dot_corners;

// hash (random/hash.glsl)
uvec2 dots_of_corners_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uint dots_of_corners_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// tile_index (by_example/tile_index.glsl)
int dots_of_corners_tile_index(int first, int second) {
  int low;
  if (second > 0) {
    low = first * first + 2 * second - 1;
  } else {
    low = first * (first + 2);
  }
  return first < second ? 2 * first + second * second : low;
}

// wang_corners (by_example/wang_corners.glsl)
vec4 dots_of_corners_wang_corners(sampler2D corners, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 6.0;
  ivec2 corner = ivec2(floor(p + 0.5));
  vec2 away = p - vec2(corner);
  ivec2 before = corner - 1;
  uvec2 rows = dots_of_corners_hash(uvec2(uint(before.y), uint(corner.y)) + 2131687100u);
  uint own = dots_of_corners_hash(uint(corner.x) + rows.y);
  int right = int(own & 1u);
  int left = int(dots_of_corners_hash(uint(before.x) + rows.y) & 1u);
  int top = int((own >> 16u) & 1u);
  int bottom = int((dots_of_corners_hash(uint(corner.x) + rows.x) >> 16u) & 1u);
  ivec2 place = ivec2(dots_of_corners_tile_index(left, right),
      dots_of_corners_tile_index(bottom, top));
  vec2 product = (vec2(place) + (away + 1.0)) * 0.25;
  vec4 color = textureGrad(corners, product, uv_dx * 1.5, uv_dy * 1.5);
  return color;
}

vec4 dots_of_corners(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // around: wang_corners (by_example/wang_corners.glsl)
  vec4 around_color = dots_of_corners_wang_corners(dot_corners, uv, uv_dx, uv_dy);
  return around_color;
}
