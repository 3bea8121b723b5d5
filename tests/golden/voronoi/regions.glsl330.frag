// regions: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Tile {
  uint seed;
};
struct Copy {
  uint seed;
  vec2 from;
};
struct View {
  vec3 light;
  float through;
};

// Constants
const vec3 colors[8] = vec3[8](vec3(0.62, 0.12, 0.05), vec3(0.8, 0.36, 0.06), vec3(0.86, 0.62, 0.2),
    vec3(0.34, 0.42, 0.12), vec3(0.08, 0.3, 0.24), vec3(0.05, 0.2, 0.36), vec3(0.2, 0.1, 0.3),
    vec3(0.75, 0.68, 0.52));

// copy_bits (bombing/copy_bits.glsl)
uvec4 copy_bits(ivec2 cell, int copy) {
  uvec2 c = uvec2(cell);
  uvec2 sum = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(2161170183u, 2614696773u);
  uvec2 v = sum + uint(copy) * uvec2(2654435769u, 1540483477u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at, of bomb (bombing/bomb.glsl)
Copy copy_at(vec2 p, vec2 node, int index) {
  uvec4 bits = copy_bits(ivec2(node), index);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  Copy copy = Copy(bits.w, p - node - moved);
  return copy;
}

// find_next, of bomb (bombing/bomb.glsl)
void find_next(vec2 p, vec2 low, uint last, int last_number, out uint last_out,
    out int last_number_out, out Copy found) {
  Copy found2 = Copy(0u, p);
  uint best = 0u;
  int best_number = 0;
  for (int i = 0; i < 16; ++i) {
    vec2 node = floor(low) + vec2(ivec2(i % 4, i / 4));
    for (int index = 0; index < 3; ++index) {
      Copy copy = copy_at(p, node, index);
      float projection = dot(copy.from, copy.from);
      uint rank = ~floatBitsToUint(projection);
      int number = i * 3 + index;
      uvec2 away = floatBitsToUint(vec2(projection, 2.25));
      bool is_next = away.x < away.y && best <= rank
          && (rank < last || (rank == last && number < last_number));
      found2 = is_next ? copy : found2;
      best = is_next ? rank : best;
      best_number = is_next ? number : best_number;
    }
  }
  last_out = best;
  last_number_out = best_number;
  found = found2;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// tile_random (tiles/tile_random.glsl)
float tile_random(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  float luck = float(hash(tile.seed) >> 8u) * 5.9604645e-8;
  return mix(0.55, 1.2, mix(0.5, luck, tile_near(tile_local_dx, tile_local_dy)));
}

// region (function of the graph)
vec4 region(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  // paint: tile_palette (tiles/tile_palette.glsl)
  vec3 paint2 = colors[int(tile.seed >> 29u)];
  // tone: tile_random (tiles/tile_random.glsl)
  float tone = tile_random(tile, tile_local_dx, tile_local_dy);
  // paint_toned: multiply (math/multiply.glsl)
  vec3 paint_toned = paint2 * tone;
  // opaque: rgba (channels/rgba.glsl)
  vec4 opaque = vec4(paint_toned, 1.0);
  return opaque;
}

// paint, of bomb (bombing/bomb.glsl)
vec4 paint(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 tile_local_dx = copy_from_dx / 3.0;
  vec2 tile_local_dy = copy_from_dy / 3.0;
  Tile tile = Tile(copy.seed);
  vec4 seen = region(tile, tile_local_dx, tile_local_dy);
  seen = vec4(seen.xyz, 1.0);
  return seen;
}

// by_rank, of bomb (bombing/bomb.glsl)
View by_rank(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  int last_number = 2147483647;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    int last_number2;
    Copy copy;
    find_next(p, low, last, last_number, last2, last_number2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = paint(copy, p_dx, p_dy);
      sum += vec4(seen.xyz, 1.0) * through;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
    last_number = last_number2;
  }
  return View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 bomb(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 5.773503 - 0.5;
  vec2 low = p - 1.0;
  vec2 p_dx = uv_dx * 5.773503;
  vec2 p_dy = uv_dy * 5.773503;
  View view = by_rank(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  vec4 color = vec4(view.light / max(covered, 1e-20), covered);
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // map: bomb (bombing/bomb.glsl)
  vec4 map_color = bomb(uv, uv_dx, uv_dy);
  out_color = map_color;
}
