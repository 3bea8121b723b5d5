// plain: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec2 plain_tiles;  // default vec2(48.0)
uniform float raggedness;  // default 0.35

// Textures
uniform sampler2DArray green;
uniform sampler2DArray straw;
uniform sampler2DArray soil;
uniform sampler2D shares;

// hash (random/hash.glsl)
uint plain_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec2 plain_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 plain_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// corner_tiles (by_example/corner_tiles.glsl)
void plain_corner_tiles(sampler2DArray tiles, vec2 uv, vec2 tiling, int seed, vec2 uv_dx,
    vec2 uv_dy, out vec4 color, out vec4 color_dx, out vec4 color_dy) {
  vec2 p = uv * tiling;
  ivec2 cell = ivec2(floor(p));
  ivec2 even = (cell + 1) & -2;
  ivec2 odd = cell | 1;
  uvec2 rows = plain_hash(uvec2(uint(even.y), uint(odd.y)) + plain_hash(uint(seed)));
  uvec4 sum = uvec4(uint(even.x), uint(odd.x), uint(even.x), uint(odd.x)) + rows.xxyy;
  uvec4 bits = plain_hash(sum);
  ivec4 around = ivec4(bits & 1u);
  int layer = around.x + 2 * (around.y + 2 * (around.z + 2 * around.w));
  vec2 place = p * 0.5;
  vec2 place_slope = tiling * 0.5;
  vec2 place_dx = uv_dx * place_slope;
  vec2 place_dy = uv_dy * place_slope;
  vec3 vector = vec3(place, float(layer));
  vec4 color2 = texture(tiles, vector);
  vec4 texel = textureGrad(tiles, vector + vec3(place_dx, 0.0), place_dx, place_dy);
  vec4 texel2 = textureGrad(tiles, vector + vec3(place_dy, 0.0), place_dx, place_dy);
  color = color2;
  color_dx = texel - color2;
  color_dy = texel2 - color2;
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 plain_corner_tiles2(sampler2DArray tiles, vec2 uv, vec2 tiling) {
  vec2 p = uv * tiling;
  ivec2 cell = ivec2(floor(p));
  ivec2 even = (cell + 1) & -2;
  ivec2 odd = cell | 1;
  uvec2 rows = plain_hash(uvec2(uint(even.y), uint(odd.y)) + 2055130248u);
  uvec4 sum = uvec4(uint(even.x), uint(odd.x), uint(even.x), uint(odd.x)) + rows.xxyy;
  uvec4 bits = plain_hash(sum);
  ivec4 around = ivec4(bits & 1u);
  int layer = around.x + 2 * (around.y + 2 * (around.z + 2 * around.w));
  vec2 place = p * 0.5;
  vec4 color = texture(tiles, vec3(place, float(layer)));
  return color;
}

// gradient_noise (noise/gradient_noise.glsl)
float plain_gradient_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 base = floor(uv);
  vec2 t = uv - base;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = plain_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = plain_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = uv_dx.x * x + uv_dx.y * y;
  vec4 corners_dy = uv_dy.x * x + uv_dy.y * y;
  vec2 fade_dx = uv_dx * fade_slope;
  vec2 fade_dy = uv_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * 0.9340967;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * 0.9340967;
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float plain_fbm_bend(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 14.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 14.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 14.0;
  vec2 p_dy = uv_dy * 14.0;
  float weight = 0.5714286;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 3; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = plain_gradient_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_value - 0.5);
      sum_dx += result_dx2 * product2;
      sum_dy += result_dy2 * product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// fbm (noise/fbm.glsl)
float plain_fbm_clumps(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 150.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 150.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 150.0;
  vec2 p_dy = uv_dy * 150.0;
  float weight = 0.53333336;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 4; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = plain_gradient_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_value - 0.5);
      sum_dx += result_dx2 * product2;
      sum_dy += result_dy2 * product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// smooth_step (math/smooth_step.glsl)
float plain_smooth_step_is_dry(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float ratio = (value - 0.42) / 0.16;
  float t = clamp(ratio, 0.0, 1.0);
  bool test = ratio < 0.0;
  bool test2 = ratio > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : value_dx / 0.16;
  float t_dy = test ? 0.0 : test2 ? 0.0 : value_dy / 0.16;
  float product = t * t;
  float difference = 3.0 - 2.0 * t;
  float sum = (t + t) * difference + product * -2.0;
  result_dx = t_dx * sum;
  result_dy = t_dy * sum;
  return product * difference;
}

// part_mean_blades, of curve (math/curve.glsl)
float plain_part_mean_blades(float middle) {
  float t = clamp((middle - 0.03) / 0.27, 0.0, 1.0);
  return 0.25 + -0.5 * t;
}

// curve (math/curve.glsl)
float plain_curve_blades(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp((0.03 - value) / width + 0.5, 0.0, 1.0);
  float sum = 0.25 * below;
  float next = clamp((0.3 - value) / width + 0.5, 0.0, 1.0);
  float middle = value + width * (0.5 * (below + next) - 0.5);
  sum += (next - below) * plain_part_mean_blades(middle);
  return sum + (1.0 - next) * -0.25;
}

// smooth_step (math/smooth_step.glsl)
float plain_smooth_step_is_bare(float value) {
  float t = clamp((value - 0.45) / 0.100000024, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// smooth_step (math/smooth_step.glsl)
float plain_smooth_step_far_dry(float value) {
  float t = clamp((value - 0.1) / 0.79999995, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// tile_near (tiles/tile_near.glsl)
float plain_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// fbm (noise/fbm.glsl)
float plain_fbm_weather(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 6.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 6.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 6.0;
  vec2 p_dy = uv_dy * 6.0;
  float weight = 0.516129;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = plain_gradient_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_value - 0.5);
      sum_dx += result_dx2 * product2;
      sum_dy += result_dy2 * product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// part_mean_light, of curve (math/curve.glsl)
float plain_part_mean_light(float middle) {
  float t = clamp((middle - 0.25) * 2.0, 0.0, 1.0);
  return 0.75 + 0.45000005 * t;
}

// curve (math/curve.glsl)
float plain_curve_light(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp((0.25 - value) / width + 0.5, 0.0, 1.0);
  float sum = 0.75 * below;
  float next = clamp((0.75 - value) / width + 0.5, 0.0, 1.0);
  float middle = value + width * (0.5 * (below + next) - 0.5);
  sum += (next - below) * plain_part_mean_light(middle);
  return sum + (1.0 - next) * 1.2;
}

void plain(vec2 uv, out vec4 color, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grass: corner_tiles (by_example/corner_tiles.glsl)
  vec4 grass_color, grass_color_dx, grass_color_dy;
  plain_corner_tiles(green, uv, plain_tiles, 0, uv_dx, uv_dy, grass_color, grass_color_dx,
      grass_color_dy);
  // dry: corner_tiles (by_example/corner_tiles.glsl)
  vec4 dry_color, dry_color_dx, dry_color_dy;
  plain_corner_tiles(straw, uv, plain_tiles, 1, uv_dx, uv_dy, dry_color, dry_color_dx,
      dry_color_dy);
  // earth: corner_tiles (by_example/corner_tiles.glsl)
  vec4 earth_color = plain_corner_tiles2(soil, uv, plain_tiles);
  // grass_light: luminance (channels/luminance.glsl)
  float grass_light = dot(grass_color.xyz, vec3(0.2126, 0.7152, 0.0722));
  float grass_light_dx = dot(grass_color_dx.xyz, vec3(0.2126, 0.7152, 0.0722));
  float grass_light_dy = dot(grass_color_dy.xyz, vec3(0.2126, 0.7152, 0.0722));
  // dry_light: luminance (channels/luminance.glsl)
  float dry_light = dot(dry_color.xyz, vec3(0.2126, 0.7152, 0.0722));
  float dry_light_dx = dot(dry_color_dx.xyz, vec3(0.2126, 0.7152, 0.0722));
  float dry_light_dy = dot(dry_color_dy.xyz, vec3(0.2126, 0.7152, 0.0722));
  // bend: fbm (noise/fbm.glsl)
  float bend_dx, bend_dy;
  float bend = plain_fbm_bend(uv, uv_dx, uv_dy, bend_dx, bend_dy);
  // elsewhere: add (math/add.glsl)
  vec2 elsewhere = uv + vec2(7.3, 4.1);
  // bend2: fbm (noise/fbm.glsl)
  float bend2_dx, bend2_dy;
  float bend2 = plain_fbm_bend(elsewhere, uv_dx, uv_dy, bend2_dx, bend2_dy);
  // bent: combine2 (channels/combine2.glsl)
  vec2 bent = vec2(bend, bend2);
  vec2 bent_dx = vec2(bend_dx, bend2_dx);
  vec2 bent_dy = vec2(bend_dy, bend2_dy);
  // shift: remap (math/remap.glsl)
  vec2 shift = mix(vec2(-0.08), vec2(0.08), bent);
  // place: add (math/add.glsl)
  vec2 place = uv + shift;
  vec2 shift_dx = bent_dx * 0.16;
  vec2 shift_dy = bent_dy * 0.16;
  vec2 place_dx = uv_dx + shift_dx;
  vec2 place_dy = uv_dy + shift_dy;
  // share_texel: image (images/image.glsl)
  vec4 share_texel = textureGrad(shares, place, place_dx, place_dy);
  vec4 share_texel_dx = textureGrad(shares, place + place_dx, place_dx, place_dy) - share_texel;
  vec4 share_texel_dy = textureGrad(shares, place + place_dy, place_dx, place_dy) - share_texel;
  // meadow_share: add (math/add.glsl)
  float meadow_share = share_texel.x + share_texel.y;
  float meadow_share_dx = share_texel_dx.x + share_texel_dx.y;
  float meadow_share_dy = share_texel_dy.x + share_texel_dy.y;
  // some_meadow: maximum (math/maximum.glsl)
  float some_meadow = max(meadow_share, 0.001);
  bool test = meadow_share < 0.001;
  float some_meadow_dx = test ? 0.0 : meadow_share_dx;
  float some_meadow_dy = test ? 0.0 : meadow_share_dy;
  // dry_share: divide (math/divide.glsl)
  float dry_share = share_texel.y / some_meadow;
  float dry_share_dx = (share_texel_dx.y - dry_share * some_meadow_dx) / some_meadow;
  float dry_share_dy = (share_texel_dy.y - dry_share * some_meadow_dy) / some_meadow;
  // clumps: fbm (noise/fbm.glsl)
  float clumps_dx, clumps_dy;
  float clumps = plain_fbm_clumps(uv, uv_dx, uv_dy, clumps_dx, clumps_dy);
  // clump: remap (math/remap.glsl)
  float clump = mix(-1.0, 1.0, clumps);
  // clump_reach: multiply (math/multiply.glsl)
  float clump_reach = clump * raggedness;
  float clump_reach_slope = 2.0 * raggedness;
  // dry_level: add (math/add.glsl)
  float dry_level = dry_share + clump_reach;
  float clump_reach_dx = clumps_dx * clump_reach_slope;
  float clump_reach_dy = clumps_dy * clump_reach_slope;
  float dry_level_dx = dry_share_dx + clump_reach_dx;
  float dry_level_dy = dry_share_dy + clump_reach_dy;
  // is_dry: smooth_step (math/smooth_step.glsl)
  float is_dry_dx, is_dry_dy;
  float is_dry = plain_smooth_step_is_dry(dry_level, dry_level_dx, dry_level_dy, is_dry_dx,
      is_dry_dy);
  // meadow_light: lerp (math/lerp.glsl)
  float meadow_light = mix(grass_light, dry_light, is_dry);
  float difference = dry_light - grass_light;
  float meadow_light_dx = mix(grass_light_dx, dry_light_dx, is_dry) + difference * is_dry_dx;
  float meadow_light_dy = mix(grass_light_dy, dry_light_dy, is_dry) + difference * is_dry_dy;
  // blades: curve (math/curve.glsl)
  float blades = plain_curve_blades(meadow_light, meadow_light_dx, meadow_light_dy);
  // bare_level: add (math/add.glsl)
  float bare_level = share_texel.z + clump_reach;
  // bare_here: add (math/add.glsl)
  float bare_here = bare_level + blades;
  // is_bare: smooth_step (math/smooth_step.glsl)
  float is_bare = plain_smooth_step_is_bare(bare_here);
  // far_dry: smooth_step (math/smooth_step.glsl)
  float far_dry = plain_smooth_step_far_dry(dry_share);
  // far_bare: smooth_step (math/smooth_step.glsl)
  float far_bare = plain_smooth_step_far_dry(share_texel.z);
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 grid_local_dx = uv_dx * 512.0;
  vec2 grid_local_dy = uv_dy * 512.0;
  // near: tile_near (tiles/tile_near.glsl)
  float near = plain_tile_near(grid_local_dx, grid_local_dy);
  // dry_amount: lerp (math/lerp.glsl)
  float dry_amount = mix(far_dry, is_dry, near);
  // bare_amount: lerp (math/lerp.glsl)
  float bare_amount = mix(far_bare, is_bare, near);
  // meadow: lerp (math/lerp.glsl)
  vec4 meadow = mix(grass_color, dry_color, dry_amount);
  // ground: lerp (math/lerp.glsl)
  vec4 ground = mix(meadow, earth_color, bare_amount);
  // weather: fbm (noise/fbm.glsl)
  float weather_dx, weather_dy;
  float weather = plain_fbm_weather(elsewhere, uv_dx, uv_dy, weather_dx, weather_dy);
  // light: curve (math/curve.glsl)
  float light = plain_curve_light(weather, weather_dx, weather_dy);
  // color: brightness_contrast (color/brightness_contrast.glsl)
  vec4 color2 = vec4(ground.xyz * light, ground.w);
  color = color2;
  roughness = 0.95;
}
