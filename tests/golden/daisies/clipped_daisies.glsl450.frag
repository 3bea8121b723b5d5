// clipped_daisies: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D daisy;

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Copy {
  vec2 from;
};
struct View {
  vec3 light;
  float through;
};

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
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  Copy copy = Copy(p - node - moved);
  return copy;
}

// paint, of bomb (bombing/bomb.glsl)
vec4 paint(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec4 seen = textureGrad(daisy, copy.from + 0.5, copy_from_dx, copy_from_dy);
  return seen;
}

// in_order, of bomb (bombing/bomb.glsl)
View in_order(vec2 p, vec2 p_dx, vec2 p_dy) {
  vec2 node = floor(p);
  Copy copy = copy_at(p, node);
  vec3 light = vec3(0.0);
  float through = 1.0;
  if (dot(copy.from, copy.from) < 0.25) {
    vec4 seen = paint(copy, p_dx, p_dy);
    light = seen.xyz * seen.w;
    through = 1.0 - seen.w;
  }
  return View(light, max(through, 0.0));
}

// bomb (bombing/bomb.glsl)
vec4 bomb(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0 - 0.5;
  vec2 p_dx = uv_dx * 8.0;
  vec2 p_dy = uv_dy * 8.0;
  View view = in_order(p, p_dx, p_dy);
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
