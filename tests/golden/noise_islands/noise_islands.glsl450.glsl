// noise_islands: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float sea_level;  // default 0.5

// hash (random/hash.glsl)
uvec2 noise_islands_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 noise_islands_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float noise_islands_value_noise(vec2 uv, vec2 scale, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * scale;
  vec2 t_dy = uv_dy * scale;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = noise_islands_hash(uvec2(cell.y, cell.y + 1u) + 2120684060u);
  uvec4 bits = noise_islands_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  float low = mix(corners.x, corners.y, fade.x);
  float low_slope = corners.y - corners.x;
  float high = mix(corners.z, corners.w, fade.x);
  float high_slope = corners.w - corners.z;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float blend = mix(low_slope, high_slope, fade.y);
  float difference2 = high - low;
  result_dx = mix(fade_dx.x * blend + fade_dx.y * difference2, 0.0, blur);
  result_dy = mix(fade_dy.x * blend + fade_dy.y * difference2, 0.0, blur);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// remap (math/remap.glsl)
float noise_islands_remap_depth(float value, float in_high) {
  float t = in_high == 0.0 ? 0.0 : value / in_high;
  return t;
}

// progress, of color_ramp (color/color_ramp.glsl)
float noise_islands_progress(float position) {
  float t = clamp(position, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// remap (math/remap.glsl)
float noise_islands_remap_altitude(float value, float in_low) {
  float difference = 0.85 - in_low;
  float t = difference == 0.0 ? 0.0 : (value - in_low) / difference;
  return t;
}

// color_ramp (color/color_ramp.glsl)
vec4 noise_islands_color_ramp(float position) {
  vec4 vector = vec4(clamp((position - 0.03) / 0.089999996, 0.0, 1.0));
  vec4 color = mix(vec4(0.58, 0.47, 0.26, 1.0), vec4(0.12, 0.24, 0.06, 1.0), vector);
  color = mix(color, vec4(0.09, 0.15, 0.05, 1.0), clamp((position - 0.12) / 0.32999998, 0.0, 1.0));
  return mix(color, vec4(0.42, 0.38, 0.34, 1.0), clamp((position - 0.45) / 0.3, 0.0, 1.0));
}

// threshold (math/threshold.glsl)
float noise_islands_threshold(float value, float edge, float value_dx, float value_dy) {
  float ratio = (value - edge) / max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  return clamp(ratio + 0.5, 0.0, 1.0);
}

void noise_islands(vec2 uv, out vec4 color, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // lands: value_noise (noise/value_noise.glsl)
  float lands_dx, lands_dy;
  float lands = noise_islands_value_noise(uv, vec2(4.0), uv_dx, uv_dy, lands_dx, lands_dy);
  // hills: value_noise (noise/value_noise.glsl)
  float hills_dx, hills_dy;
  float hills = noise_islands_value_noise(uv, vec2(9.0), uv_dx, uv_dy, hills_dx, hills_dy);
  // rocks: value_noise (noise/value_noise.glsl)
  float rocks_dx, rocks_dy;
  float rocks = noise_islands_value_noise(uv, vec2(21.0), uv_dx, uv_dy, rocks_dx, rocks_dy);
  // stones: value_noise (noise/value_noise.glsl)
  float stones_dx, stones_dy;
  float stones = noise_islands_value_noise(uv, vec2(50.0), uv_dx, uv_dy, stones_dx, stones_dy);
  // coarse: lerp (math/lerp.glsl)
  float coarse = mix(lands, hills, 0.35);
  float coarse_dx = mix(lands_dx, hills_dx, 0.35);
  float coarse_dy = mix(lands_dy, hills_dy, 0.35);
  // fine: lerp (math/lerp.glsl)
  float fine = mix(rocks, stones, 0.35);
  float fine_dx = mix(rocks_dx, stones_dx, 0.35);
  float fine_dy = mix(rocks_dy, stones_dy, 0.35);
  // height: lerp (math/lerp.glsl)
  float height2 = mix(coarse, fine, 0.25);
  float height_dx = mix(coarse_dx, fine_dx, 0.25);
  float height_dy = mix(coarse_dy, fine_dy, 0.25);
  // depth: remap (math/remap.glsl)
  float depth = noise_islands_remap_depth(height2, sea_level);
  // water: color_ramp (color/color_ramp.glsl)
  vec4 water = mix(vec4(0.01, 0.03, 0.09, 1.0), vec4(0.03, 0.28, 0.36, 1.0),
      noise_islands_progress(depth));
  // altitude: remap (math/remap.glsl)
  float altitude = noise_islands_remap_altitude(height2, sea_level);
  // land: color_ramp (color/color_ramp.glsl)
  vec4 land = noise_islands_color_ramp(altitude);
  // shore: threshold (math/threshold.glsl)
  float shore = noise_islands_threshold(height2, sea_level, height_dx, height_dy);
  // map: lerp (math/lerp.glsl)
  vec4 map = mix(water, land, shore);
  // gloss: lerp (math/lerp.glsl)
  float gloss = mix(0.1, 0.9, shore);
  color = map;
  height = height2;
  roughness = gloss;
}
