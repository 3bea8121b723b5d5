// spread: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D daisy;

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Copy {
  uint seed;
  uint luck;
  vec2 from;
};
struct View {
  vec3 light;
  float through;
};

// node_at, of bomb (bombing/bomb.glsl)
vec2 node_at(vec2 low, int number) {
  vec2 node = vec2(ivec2(number % 2, number / 2));
  float sum = node.y + floor(low.y);
  float whole = floor(low.x + 0.5 * float(int(sum) & 1));
  node = vec2(node.x + whole, sum);
  return node;
}

// copy_bits (bombing/copy_bits.glsl)
uvec4 copy_bits(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at, of bomb (bombing/bomb.glsl)
Copy copy_at(vec2 p, vec2 node) {
  uvec4 bits = copy_bits(ivec2(node));
  vec2 middle = vec2(node.x - 0.5 * float(int(node.y) & 1), node.y);
  vec2 moved = vec2(1.0, 0.8660254) * (vec2(ivec2(bits.xy)) * 1.3969839e-10);
  Copy copy = Copy(bits.w, bits.z, p - vec2(1.0, 0.8660254) * middle - moved);
  return copy;
}

// find_next, of bomb (bombing/bomb.glsl)
void find_next(vec2 p, vec2 low, uint last, out uint last_out, out Copy found) {
  Copy found2 = Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 4; ++i) {
    vec2 node = node_at(low, i);
    Copy copy = copy_at(p, node);
    uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.16000001));
    bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
    found2 = is_next ? copy : found2;
    best = is_next ? copy.luck : best;
  }
  last_out = best;
  found = found2;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// pose_of, of bomb (bombing/bomb.glsl)
vec2 pose_of(Copy copy) {
  uint hash_value = hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(0.8, mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// arm_of, of bomb (bombing/bomb.glsl)
vec2 arm_of(Copy copy, vec2 pose, vec2 copy_from_dx, vec2 copy_from_dy, out vec2 result_dx,
    out vec2 result_dy) {
  float c = cos(pose.y);
  float s = sin(pose.y);
  vec2 sum = copy_from_dx * c + vec2(copy_from_dx.y, -copy_from_dx.x) * s;
  vec2 sum2 = copy_from_dy * c + vec2(copy_from_dy.y, -copy_from_dy.x) * s;
  bool test = pose.x != 0.0;
  result_dx = test ? sum / pose.x : vec2(0.0);
  result_dy = test ? sum2 / pose.x : vec2(0.0);
  return (c * copy.from + s * vec2(copy.from.y, -copy.from.x)) / pose.x;
}

// paint, of bomb (bombing/bomb.glsl)
vec4 paint(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = pose_of(copy);
  vec2 result_dx, result_dy;
  vec2 arm_of_value = arm_of(copy, pose, copy_from_dx, copy_from_dy, result_dx, result_dy);
  vec4 seen = textureGrad(daisy, arm_of_value + 0.5, result_dx, result_dy);
  return seen;
}

// by_rank, of bomb (bombing/bomb.glsl)
View by_rank(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    Copy copy;
    find_next(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = paint(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 bomb(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0 - vec2(0.5, 0.4330127);
  vec2 low = p / vec2(1.0, 0.8660254) + vec2(0.29999995, 0.23811972);
  vec2 p_dx = uv_dx * 8.0;
  vec2 p_dy = uv_dy * 8.0;
  View view = by_rank(p, low, p_dx, p_dy);
  vec3 below = vec3(0.07, 0.2, 0.03) * view.through;
  vec4 color = vec4(view.light + below, 1.0);
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // meadow: bomb (bombing/bomb.glsl)
  vec4 meadow_color = bomb(uv, uv_dx, uv_dy);
  out_color = meadow_color;
}
