// leaf_litter: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float fallen;  // default 0.85

// Textures
uniform sampler2DArray leaves;
uniform sampler2D forest_floor;

// Types
struct leaf_litter_Tile {
  uint seed;
};
struct leaf_litter_Copy {
  uint seed;
  uint luck;
  vec2 from;
};
struct leaf_litter_View {
  vec3 light;
  float through;
};

// Constants
const vec2 leaf_litter_points[3] = vec2[3](vec2(0.25, 0.1), vec2(0.45, 0.6), vec2(0.62, 1.0));

// wrap_cell (tiles/wrap_cell.glsl)
int leaf_litter_wrap_cell(int cell, int count) {
  int flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}

// hash (random/hash.glsl)
uint leaf_litter_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// copy_bits (bombing/copy_bits.glsl)
uvec4 leaf_litter_copy_bits(ivec2 cell, int copy, int seed) {
  uint first = leaf_litter_hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 sum = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(first, leaf_litter_hash(first));
  uvec2 v = sum + uint(copy) * uvec2(2654435769u, 1540483477u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at_old, of bomb (bombing/bomb.glsl)
leaf_litter_Copy leaf_litter_copy_at_old(vec2 p, vec2 node, int index) {
  ivec2 numbers = ivec2(node);
  uvec4 bits = leaf_litter_copy_bits(ivec2(leaf_litter_wrap_cell(numbers.x, 7),
      leaf_litter_wrap_cell(numbers.y, 7)), index, 1);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  leaf_litter_Copy copy = leaf_litter_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// pose_of_old, of bomb (bombing/bomb.glsl)
vec2 leaf_litter_pose_of_old(leaf_litter_Copy copy) {
  uint hash_value = leaf_litter_hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.8, 1.3, luck.x), mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// find_next_old, of bomb (bombing/bomb.glsl)
void leaf_litter_find_next_old(vec2 p, vec2 low, uint last, out uint last_out,
    out leaf_litter_Copy found) {
  leaf_litter_Copy found2 = leaf_litter_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 9; ++i) {
    vec2 node = floor(low) + vec2(ivec2(i % 3, i / 3));
    for (int index = 0; index < 2; ++index) {
      leaf_litter_Copy copy = leaf_litter_copy_at_old(p, node, index);
      vec2 pose = leaf_litter_pose_of_old(copy);
      uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
      bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
      found2 = is_next ? copy : found2;
      best = is_next ? copy.luck : best;
    }
  }
  last_out = best;
  found = found2;
}

// arm_of, of bomb (bombing/bomb.glsl)
vec2 leaf_litter_arm_of(leaf_litter_Copy copy, vec2 pose, vec2 copy_from_dx, vec2 copy_from_dy,
    out vec2 result_dx, out vec2 result_dy) {
  float c = cos(pose.y);
  float s = sin(pose.y);
  vec2 sum = copy_from_dx * c + vec2(copy_from_dx.y, -copy_from_dx.x) * s;
  vec2 sum2 = copy_from_dy * c + vec2(copy_from_dy.y, -copy_from_dy.x) * s;
  bool test = pose.x != 0.0;
  result_dx = test ? sum / pose.x : vec2(0.0);
  result_dy = test ? sum2 / pose.x : vec2(0.0);
  return (c * copy.from + s * vec2(copy.from.y, -copy.from.x)) / pose.x;
}

// choice, of tile_weighted_choice (tiles/tile_weighted_choice.glsl)
int leaf_litter_choice(uint seed) {
  float place = float(leaf_litter_hash(seed) >> 8u) * 5.9604645e-8 * 9.0;
  return int(place >= 2.0) + int(place >= 4.0) + int(place >= 5.0);
}

// blur (filters/blur.glsl)
vec4 leaf_litter_blur(vec4 picture, vec4 picture_dx, vec4 picture_dy, out vec4 result_dx,
    out vec4 result_dy) {
  float share = 1.0;
  for (int i = 1; i < 3; ++i) {
    share *= 0.25;
  }
  vec4 sum = vec4(0.0);
  vec4 sum_dx = vec4(0.0);
  vec4 sum_dy = vec4(0.0);
  for (int y = 0; y < 3; ++y) {
    float weight = share;
    for (int x = 0; x < 3; ++x) {
      vec4 vector = vec4(picture_dx.xyz * picture.w + picture.xyz * picture_dx.w, picture_dx.w);
      vec4 vector2 = vec4(picture_dy.xyz * picture.w + picture.xyz * picture_dy.w, picture_dy.w);
      sum += weight * vec4(picture.xyz * picture.w, picture.w);
      sum_dx += vector * weight;
      sum_dy += vector2 * weight;
      weight *= float(2 - x) / float(x + 1);
    }
    share *= float(2 - y) / float(y + 1);
  }
  bool test = sum.w < 1e-20;
  vec3 vector = vec3(max(sum.w, 1e-20));
  vec3 ratio = sum.xyz / vector;
  result_dx = vec4((sum_dx.xyz - ratio * (test ? 0.0 : sum_dx.w)) / vector, sum_dx.w);
  result_dy = vec4((sum_dy.xyz - ratio * (test ? 0.0 : sum_dy.w)) / vector, sum_dy.w);
  return vec4(ratio, sum.w);
}

// level, of levels (color/levels.glsl)
float leaf_litter_level(float value, float value_dx, float value_dy) {
  float t = value * 1.25;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 1.25, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// tile_near (tiles/tile_near.glsl)
float leaf_litter_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 leaf_litter_random3(uint seed) {
  uint bits = leaf_litter_hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(leaf_litter_hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 leaf_litter_rgb_to_hsv(vec3 color) {
  float value = max(max(color.x, color.y), color.z);
  float range = value - min(min(color.x, color.y), color.z);
  float part = 1.0 / max(range, 1e-20);
  float sector = (color.x - color.y) * part + 4.0;
  float sector2;
  if (color.x == value) {
    sector2 = (color.y - color.z) * part;
  } else {
    if (color.y == value) {
      sector = (color.z - color.x) * part + 2.0;
    }
    sector2 = sector;
  }
  return vec3(fract(sector2 / 6.0), range / max(value, 1e-20), value);
}

// hsv_to_rgb (color/hsv_to_rgb.glsl)
vec3 leaf_litter_hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 leaf_litter_hsv_adjust(vec3 color, float hue, float saturation, float value) {
  float top = max(max(color.x, color.y), color.z);
  float range = top - min(min(color.x, color.y), color.z);
  float pull = 1.0;
  if (saturation != 1.0) {
    pull = min(saturation, top / max(range, 1e-20));
  }
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = leaf_litter_rgb_to_hsv(pulled);
  vec3 turned = leaf_litter_hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 leaf_litter_varied(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), leaf_litter_random3(seed), near);
  vec3 one = leaf_litter_hsv_adjust(color, mix(-3.0, 5.0, luck.x), mix(0.9, 1.03, luck.y),
      mix(0.55, 1.1, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9991878), one, near);
}

// leaf (function of the graph)
vec4 leaf_litter_leaf_withered(vec2 uv, leaf_litter_Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // kind: tile_weighted_choice (tiles/tile_weighted_choice.glsl)
  int kind = leaf_litter_choice(tile.seed);
  // place: uv_transform (images/uv_transform.glsl)
  vec2 place_dx = mat2(1.1363636, -0.0, 0.0, 1.1363636) * uv_dx;
  vec2 place_dy = mat2(1.1363636, -0.0, 0.0, 1.1363636) * uv_dy;
  vec2 place = mat2(1.1363636, -0.0, 0.0, 1.1363636) * (uv - 0.5) + 0.5;
  // picture: image (images/image.glsl)
  vec3 vector = vec3(place, float(kind));
  vec4 picture = textureGrad(leaves, vector, place_dx, place_dy);
  vec4 texel = textureGrad(leaves, vector + vec3(place_dx, 0.0), place_dx, place_dy);
  vec4 picture_dx = texel - picture;
  vec4 texel2 = textureGrad(leaves, vector + vec3(place_dy, 0.0), place_dx, place_dy);
  vec4 picture_dy = texel2 - picture;
  // soft: blur (filters/blur.glsl)
  vec4 soft_dx, soft_dy;
  vec4 soft = leaf_litter_blur(picture, picture_dx, picture_dy, soft_dx, soft_dy);
  // shade: levels (color/levels.glsl)
  float shade = 0.75 * leaf_litter_level(soft.w, soft_dx.w, soft_dy.w);
  // dull: brightness_contrast (color/brightness_contrast.glsl)
  vec3 product = leaf_litter_varied(tile.seed, leaf_litter_tile_near(uv_dx, uv_dy), picture.xyz)
      * 0.34;
  // old: saturate (color/saturate.glsl)
  vec3 blend = mix(vec3(dot(product, vec3(0.2126, 0.7152, 0.0722))), product, 0.75);
  // lying: over (layers/over.glsl)
  float blend2 = mix(shade, 1.0, picture.w);
  vec3 blend3 = mix(vec3(0.01, 0.006, 0.003), blend, picture.w / max(blend2, 1e-20));
  vec4 lying = vec4(blend3, blend2);
  return lying;
}

// paint_old, of bomb (bombing/bomb.glsl)
vec4 leaf_litter_paint_old(leaf_litter_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = leaf_litter_pose_of_old(copy);
  vec2 tile_local_dx, tile_local_dy;
  vec2 arm_of_value = leaf_litter_arm_of(copy, pose, copy_from_dx, copy_from_dy, tile_local_dx,
      tile_local_dy);
  leaf_litter_Tile tile = leaf_litter_Tile(copy.seed);
  vec4 seen = leaf_litter_leaf_withered(arm_of_value + 0.5, tile, tile_local_dx, tile_local_dy);
  return seen;
}

// by_rank_old, of bomb (bombing/bomb.glsl)
leaf_litter_View leaf_litter_by_rank_old(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    leaf_litter_Copy copy;
    leaf_litter_find_next_old(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = leaf_litter_paint_old(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return leaf_litter_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 leaf_litter_bomb_old(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 7.0 - 0.5;
  vec2 low = p - 0.14999998;
  vec2 p_dx = uv_dx * 7.0;
  vec2 p_dy = uv_dy * 7.0;
  leaf_litter_View view = leaf_litter_by_rank_old(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// copy_at_fresh, of bomb (bombing/bomb.glsl)
leaf_litter_Copy leaf_litter_copy_at_fresh(vec2 p, vec2 node, int index) {
  ivec2 numbers = ivec2(node);
  uvec4 bits = leaf_litter_copy_bits(ivec2(leaf_litter_wrap_cell(numbers.x, 6),
      leaf_litter_wrap_cell(numbers.y, 6)), index, 2);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  leaf_litter_Copy copy = leaf_litter_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// pose_of_fresh, of bomb (bombing/bomb.glsl)
vec2 leaf_litter_pose_of_fresh(leaf_litter_Copy copy) {
  uint hash_value = leaf_litter_hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.85, 1.5, luck.x), mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// hash (random/hash.glsl)
uvec2 leaf_litter_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 leaf_litter_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float leaf_litter_gradient_noise(vec2 uv) {
  vec2 p = uv * 3.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(leaf_litter_wrap_cell(int(cell.x), 3));
  uint choice = number == 2u ? 0u : number + 1u;
  uint number2 = uint(leaf_litter_wrap_cell(int(cell.y), 3));
  uvec2 rows = leaf_litter_hash(uvec2(number2, number2 == 2u ? 0u : number2 + 1u) + 678955108u);
  uvec4 hash_value = leaf_litter_hash(uvec4(number, choice, number, choice) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// slope_at, of curve (math/curve.glsl)
float leaf_litter_slope_at(int i) {
  return i == 1 ? 2.4205086 : i == 0 ? 2.5794919 : 2.285373;
}

// part_mean, of curve (math/curve.glsl)
float leaf_litter_part_mean(int i, float middle, float reach) {
  vec2 from = leaf_litter_points[clamp(i, 0, 2)];
  int sum = i + 1;
  vec2 to = leaf_litter_points[clamp(sum, 0, 2)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * leaf_litter_slope_at(i) - rise;
  float end = rise - way * leaf_litter_slope_at(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float leaf_litter_curve(float value) {
  float below = clamp((0.25 - value) / 1e-7 + 0.5, 0.0, 1.0);
  float sum = 0.1 * below;
  for (int i = 0; i < 2; ++i) {
    float next = clamp((leaf_litter_points[i + 1].x - value) / 1e-7 + 0.5, 0.0, 1.0);
    float middle = value + 1e-7 * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * 1e-7;
    below = next;
    sum += difference * leaf_litter_part_mean(i, middle, reach);
  }
  return sum + (1.0 - below);
}

// is_there_fresh, of bomb (bombing/bomb.glsl)
bool leaf_litter_is_there_fresh(leaf_litter_Copy copy, vec2 p) {
  vec2 center = p - copy.from;
  float chance = leaf_litter_curve(leaf_litter_gradient_noise((center + 0.5) / 6.0)) * fallen;
  bool test = float(leaf_litter_hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < chance;
  bool stays = chance >= 1.0 || test;
  return stays;
}

// find_next_fresh, of bomb (bombing/bomb.glsl)
void leaf_litter_find_next_fresh(vec2 p, vec2 low, uint last, out uint last_out,
    out leaf_litter_Copy found) {
  leaf_litter_Copy found2 = leaf_litter_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 9; ++i) {
    vec2 node = floor(low) + vec2(ivec2(i % 3, i / 3));
    for (int index = 0; index < 2; ++index) {
      leaf_litter_Copy copy = leaf_litter_copy_at_fresh(p, node, index);
      vec2 pose = leaf_litter_pose_of_fresh(copy);
      uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
      bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
      bool test = is_next && leaf_litter_is_there_fresh(copy, p);
      found2 = test ? copy : found2;
      best = test ? copy.luck : best;
    }
  }
  last_out = best;
  found = found2;
}

// leaf (function of the graph)
vec4 leaf_litter_leaf_fresh(vec2 uv, leaf_litter_Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // kind: tile_weighted_choice (tiles/tile_weighted_choice.glsl)
  int kind = leaf_litter_choice(tile.seed);
  // place: uv_transform (images/uv_transform.glsl)
  vec2 place_dx = mat2(1.1363636, -0.0, 0.0, 1.1363636) * uv_dx;
  vec2 place_dy = mat2(1.1363636, -0.0, 0.0, 1.1363636) * uv_dy;
  vec2 place = mat2(1.1363636, -0.0, 0.0, 1.1363636) * (uv - 0.5) + 0.5;
  // picture: image (images/image.glsl)
  vec3 vector = vec3(place, float(kind));
  vec4 picture = textureGrad(leaves, vector, place_dx, place_dy);
  vec4 texel = textureGrad(leaves, vector + vec3(place_dx, 0.0), place_dx, place_dy);
  vec4 picture_dx = texel - picture;
  vec4 texel2 = textureGrad(leaves, vector + vec3(place_dy, 0.0), place_dx, place_dy);
  vec4 picture_dy = texel2 - picture;
  // soft: blur (filters/blur.glsl)
  vec4 soft_dx, soft_dy;
  vec4 soft = leaf_litter_blur(picture, picture_dx, picture_dy, soft_dx, soft_dy);
  // shade: levels (color/levels.glsl)
  float shade = 0.75 * leaf_litter_level(soft.w, soft_dx.w, soft_dy.w);
  // own: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 varied_value = leaf_litter_varied(tile.seed, leaf_litter_tile_near(uv_dx, uv_dy),
      picture.xyz);
  // lying: over (layers/over.glsl)
  float blend = mix(shade, 1.0, picture.w);
  vec3 blend2 = mix(vec3(0.01, 0.006, 0.003), varied_value, picture.w / max(blend, 1e-20));
  vec4 lying = vec4(blend2, blend);
  return lying;
}

// paint_fresh, of bomb (bombing/bomb.glsl)
vec4 leaf_litter_paint_fresh(leaf_litter_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = leaf_litter_pose_of_fresh(copy);
  vec2 tile_local_dx, tile_local_dy;
  vec2 arm_of_value = leaf_litter_arm_of(copy, pose, copy_from_dx, copy_from_dy, tile_local_dx,
      tile_local_dy);
  leaf_litter_Tile tile = leaf_litter_Tile(copy.seed);
  vec4 seen = leaf_litter_leaf_fresh(arm_of_value + 0.5, tile, tile_local_dx, tile_local_dy);
  return seen;
}

// by_rank_fresh, of bomb (bombing/bomb.glsl)
leaf_litter_View leaf_litter_by_rank_fresh(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    leaf_litter_Copy copy;
    leaf_litter_find_next_fresh(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = leaf_litter_paint_fresh(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return leaf_litter_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 leaf_litter_bomb_fresh(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 6.0 - 0.5;
  vec2 low = p - 0.25;
  vec2 p_dx = uv_dx * 6.0;
  vec2 p_dy = uv_dy * 6.0;
  leaf_litter_View view = leaf_litter_by_rank_fresh(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

vec4 leaf_litter(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // soil: tiled_image (images/tiled_image.glsl)
  vec4 soil = texture(forest_floor, uv * 3.0);
  // old: bomb (bombing/bomb.glsl)
  vec4 old_color = leaf_litter_bomb_old(uv, soil, uv_dx, uv_dy);
  // fresh: bomb (bombing/bomb.glsl)
  vec4 fresh_color = leaf_litter_bomb_fresh(uv, old_color, uv_dx, uv_dy);
  return fresh_color;
}
