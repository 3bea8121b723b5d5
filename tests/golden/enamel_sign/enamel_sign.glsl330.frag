// enamel_sign: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec3 enamel;  // default vec3(0.008, 0.045, 0.17)
uniform vec3 cream;  // default vec3(0.8, 0.74, 0.58)
uniform vec3 gold;  // default vec3(0.83, 0.45, 0.05)
uniform vec3 red;  // default vec3(0.42, 0.02, 0.014)
uniform float wear;  // default 0.02

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

// Types
struct Tile {
  vec2 local;
  vec2 size;
  uint seed;
};

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// sdf_rounded_rectangle (shapes/sdf_rounded_rectangle.glsl)
float sdf_rounded_rectangle_behind(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(0.512, 0.484);
  vec2 quarter = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 q = p * quarter - 0.45 + 0.12;
  vec2 q_dx = uv_dx * quarter;
  vec2 q_dy = uv_dy * quarter;
  float outward, outward_dx, outward_dy;
  if (q.x > 0.0 && q.y > 0.0) {
    outward = length(q);
    float greatest = max(outward, 1e-20);
    outward_dx = dot(q, q_dx) / greatest;
    outward_dy = dot(q, q_dy) / greatest;
  } else {
    bool test = q.x < q.y;
    outward = max(q.x, q.y);
    outward_dx = test ? q_dx.y : q_dx.x;
    outward_dy = test ? q_dy.y : q_dy.x;
  }
  result_dx = outward_dx;
  result_dy = outward_dy;
  return outward - 0.12;
}

// sdf_fill (shapes/sdf_fill.glsl)
float sdf_fill_shadow(float shape, float softness, float shape_dx, float shape_dy) {
  float width = max(softness, 0.0) + max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// sdf_rounded_rectangle (shapes/sdf_rounded_rectangle.glsl)
float sdf_rounded_rectangle_plate(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - 0.5;
  vec2 quarter = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 q = p * quarter - 0.45 + 0.12;
  vec2 q_dx = uv_dx * quarter;
  vec2 q_dy = uv_dy * quarter;
  float outward, outward_dx, outward_dy;
  if (q.x > 0.0 && q.y > 0.0) {
    outward = length(q);
    float greatest = max(outward, 1e-20);
    outward_dx = dot(q, q_dx) / greatest;
    outward_dy = dot(q, q_dy) / greatest;
  } else {
    bool test = q.x < q.y;
    outward = max(q.x, q.y);
    outward_dx = test ? q_dx.y : q_dx.x;
    outward_dy = test ? q_dy.y : q_dy.x;
  }
  result_dx = outward_dx;
  result_dy = outward_dy;
  return outward - 0.12;
}

// sdf_fill (shapes/sdf_fill.glsl)
float sdf_fill_plate_mask(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// sdf_stroke (shapes/sdf_stroke.glsl)
float sdf_stroke(float shape, float width, float offset, float shape_dx, float shape_dy) {
  float pixel = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float center = shape - offset;
  float product = 0.5 * pixel;
  float low = max(center - product, -0.5 * width);
  float high = min(center + product, 0.5 * width);
  return clamp((high - low) / pixel, 0.0, 1.0);
}

// sdf_ring (shapes/sdf_ring.glsl)
float sdf_ring(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 difference = uv - vec2(0.5, 0.53);
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float outward_dx = dot(difference, uv_dx) / greatest;
  float outward_dy = dot(difference, uv_dy) / greatest;
  float outward = norm - 0.285;
  float side = outward < 0.0 ? -1.0 : 1.0;
  result_dx = outward_dx * side;
  result_dy = outward_dy * side;
  return side * outward - 0.02;
}

// sdf_arc (shapes/sdf_arc.glsl)
float sdf_arc(vec2 uv, float start, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  float middle = start * 0.017453292 + 0.8290314;
  float cosine = cos(middle);
  float sine = sin(middle);
  vec2 axis = vec2(cosine, sine);
  vec2 p = uv - vec2(0.5, 0.53);
  float from_axis = p.y * cosine - p.x * sine;
  float from_axis_dx = uv_dx.y * cosine - uv_dx.x * sine;
  float from_axis_dy = uv_dy.y * cosine - uv_dy.x * sine;
  float projection = dot(p, axis);
  float choice = from_axis < 0.0 ? -1.0 : 1.0;
  float product = from_axis * choice;
  vec2 q = vec2(projection, product);
  vec2 q_dx = vec2(dot(uv_dx, axis), from_axis_dx * choice);
  vec2 q_dy = vec2(dot(uv_dy, axis), from_axis_dy * choice);
  float norm = length(p);
  float greatest = max(norm, 1e-20);
  float outward_dx = dot(p, uv_dx) / greatest;
  float outward_dy = dot(p, uv_dy) / greatest;
  float outward = norm - 0.335;
  float from_circle_slope = outward < 0.0 ? -1.0 : 1.0;
  float from_circle = outward * from_circle_slope;
  bool beside = product * 0.6755902 < projection * 0.7372773;
  float from_circle_dx = outward_dx * from_circle_slope;
  float from_circle_dy = outward_dy * from_circle_slope;
  if (!beside) {
    vec2 difference = q - vec2(0.22632273, 0.24698791);
    from_circle = length(difference);
    float greatest2 = max(from_circle, 1e-20);
    from_circle_dx = dot(difference, q_dx) / greatest2;
    from_circle_dy = dot(difference, q_dy) / greatest2;
  }
  result_dx = from_circle_dx;
  result_dy = from_circle_dy;
  return from_circle - 0.006;
}

// sdf_regular_polygon (shapes/sdf_regular_polygon.glsl)
float sdf_regular_polygon(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(0.5, 0.865);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - 1.5707964;
  float side = 1.5707964 + 1.5707964 * (floor(turned / 1.5707964) + 0.5);
  float cosine = cos(side);
  float sine = sin(side);
  vec2 outward = vec2(cosine, sine);
  float projection = dot(uv_dx, outward);
  float projection2 = dot(uv_dy, outward);
  float difference = p.y * cosine - p.x * sine;
  float direction = sign(difference);
  vec2 q = vec2(dot(p, outward), abs(difference));
  vec2 q_dx = vec2(projection, (uv_dx.y * cosine - uv_dx.x * sine) * direction);
  vec2 q_dy = vec2(projection2, (uv_dy.y * cosine - uv_dy.x * sine) * direction);
  vec2 beyond = q - 0.016970562;
  float choice = beyond.x;
  if (beyond.y > 0.0 && beyond.x > 0.0) {
    choice = length(beyond);
    float greatest = max(choice, 1e-20);
    projection = dot(beyond, q_dx) / greatest;
    projection2 = dot(beyond, q_dy) / greatest;
  }
  result_dx = projection;
  result_dy = projection2;
  return choice;
}

// sdf_star (shapes/sdf_star.glsl)
float sdf_star(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv - vec2(0.5, 0.545);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - 1.5707964;
  float toward = 1.5707964 + 1.2566371 * floor(turned / 1.2566371 + 0.5);
  float cosine = cos(toward);
  float sine = sin(toward);
  vec2 ahead = vec2(cosine, sine);
  float from_axis = p.y * cosine - p.x * sine;
  float from_axis_dx = uv_dx.y * cosine - uv_dx.x * sine;
  float from_axis_dy = uv_dy.y * cosine - uv_dy.x * sine;
  float projection = dot(uv_dx, ahead);
  float projection2 = dot(uv_dy, ahead);
  float difference = dot(p, ahead) - 0.2;
  float choice = from_axis < 0.0 ? -1.0 : 1.0;
  float product = from_axis * choice;
  vec2 q = vec2(difference, product);
  float product2 = from_axis_dx * choice;
  float product3 = from_axis_dy * choice;
  vec2 q_dx = vec2(projection, product2);
  vec2 q_dy = vec2(projection2, product3);
  float side = difference * 0.35579637 - product * -0.9345635;
  float side_dx = projection * 0.35579637 - product2 * -0.9345635;
  float side_dy = projection2 * 0.35579637 - product3 * -0.9345635;
  float place = dot(q, vec2(-0.9345635, 0.35579637));
  bool test = place > 0.0;
  if (!(test && place < 0.1404223)) {
    vec2 choice2 = test ? q - vec2(-0.13123356, 0.049961746) : q;
    float to_end = length(choice2);
    float greatest = max(to_end, 1e-20);
    float to_end_dx = dot(choice2, q_dx) / greatest;
    float to_end_dy = dot(choice2, q_dy) / greatest;
    bool test2 = side < 0.0;
    side = test2 ? -to_end : to_end;
    side_dx = test2 ? -to_end_dx : to_end_dx;
    side_dy = test2 ? -to_end_dy : to_end_dy;
  }
  result_dx = side_dx;
  result_dy = side_dy;
  return side;
}

// sdf_quadratic_curve (shapes/sdf_quadratic_curve.glsl)
float sdf_quadratic_curve(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 from_a = vec2(0.185, 0.285) - uv;
  vec2 from_a_dx = -uv_dx;
  vec2 from_a_dy = -uv_dy;
  float k0 = dot(from_a, vec2(0.315, -0.14));
  float k1 = 0.23765 + from_a.y * 0.28;
  vec2 t = vec2(0.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    vec2 slope = ((0.0784 * t - 0.1176) * t + k1) * t + k0;
    vec2 rise = (0.2352 * t - 0.2352) * t + k1;
    t = clamp(t - slope / max(rise, 1e-20), vec2(0.0, 0.5), vec2(0.5, 1.0));
  }
  t = floor(t * 16777216.0 + 0.5) * 5.9604645e-8;
  vec2 first = (vec2(0.0, 0.28) * t.x + vec2(0.63, -0.28)) * t.x + from_a;
  vec2 last = (vec2(0.0, 0.28) * t.y + vec2(0.63, -0.28)) * t.y + from_a;
  float norm = length(first);
  float greatest = max(norm, 1e-20);
  float norm2 = length(last);
  float greatest2 = max(norm2, 1e-20);
  float least = min(norm, norm2);
  bool test = norm2 < norm;
  float choice = test ? dot(last, from_a_dx) / greatest2 : dot(first, from_a_dx) / greatest;
  float choice2 = test ? dot(last, from_a_dy) / greatest2 : dot(first, from_a_dy) / greatest;
  float norm3 = length(from_a);
  float greatest3 = max(norm3, 1e-20);
  float gap = distance(uv, vec2(0.815, 0.285));
  vec2 difference = uv - vec2(0.815, 0.285);
  float greatest4 = max(gap, 1e-20);
  float least2 = min(norm3, gap);
  bool test2 = gap < norm3;
  float choice3 = test2 ? dot(difference, uv_dx) / greatest4 : dot(from_a, from_a_dx) / greatest3;
  float choice4 = test2 ? dot(difference, uv_dy) / greatest4 : dot(from_a, from_a_dy) / greatest3;
  float from_curve = min(least, least2);
  bool test3 = least2 < least;
  result_dx = test3 ? choice3 : choice;
  result_dy = test3 ? choice4 : choice2;
  return from_curve - 0.06;
}

// from_segment, of sdf_triangle (shapes/sdf_triangle.glsl)
float from_segment(vec2 p, vec2 a, vec2 b, vec2 p_dx, vec2 p_dy, out float result_dx,
    out float result_dy) {
  float edge_length = distance(a, b);
  vec2 along = (b - a) / max(edge_length, 1e-20);
  float place = dot(p - a, along);
  bool test = place > 0.0;
  float choice, choice2, choice3;
  if (test && place < edge_length) {
    float side = (p.x - a.x) * along.y - (p.y - a.y) * along.x;
    float side_dx = p_dx.x * along.y - p_dx.y * along.x;
    float side_dy = p_dy.x * along.y - p_dy.y * along.x;
    float choice4 = side < 0.0 ? -1.0 : 1.0;
    choice = side * choice4;
    choice2 = side_dx * choice4;
    choice3 = side_dy * choice4;
  } else {
    vec2 difference = p - (test ? b : a);
    choice = length(difference);
    float greatest = max(choice, 1e-20);
    choice2 = dot(difference, p_dx) / greatest;
    choice3 = dot(difference, p_dy) / greatest;
  }
  result_dx = choice2;
  result_dy = choice3;
  return choice;
}

// right_of, of sdf_triangle (shapes/sdf_triangle.glsl)
float right_of(vec2 p, vec2 a, vec2 b) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// sdf_triangle (shapes/sdf_triangle.glsl)
float sdf_triangle(vec2 uv, vec2 a, vec2 b, vec2 c, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  float result_dx2, result_dy2;
  float from_segment_value = from_segment(uv, a, b, uv_dx, uv_dy, result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float from_segment_value2 = from_segment(uv, b, c, uv_dx, uv_dy, result_dx3, result_dy3);
  float result_dx4, result_dy4;
  float from_segment_value3 = from_segment(uv, c, a, uv_dx, uv_dy, result_dx4, result_dy4);
  float least = min(from_segment_value2, from_segment_value3);
  bool test = from_segment_value3 < from_segment_value2;
  float outline = min(from_segment_value, least);
  bool test2 = least < from_segment_value;
  float outline_dx = test2 ? (test ? result_dx4 : result_dx3) : result_dx2;
  float outline_dy = test2 ? (test ? result_dy4 : result_dy3) : result_dy2;
  float turn = right_of(c, a, b) < 0.0 ? -1.0 : 1.0;
  float inside = min(turn * right_of(uv, a, b),
      min(turn * right_of(uv, b, c), turn * right_of(uv, c, a)));
  bool test3 = inside > 0.0;
  result_dx = test3 ? -outline_dx : outline_dx;
  result_dy = test3 ? -outline_dy : outline_dy;
  return test3 ? -outline : outline;
}

// smooth_step (math/smooth_step.glsl)
float smooth_step(float value) {
  float t = clamp((value + 0.022) / 0.026, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// value_noise (noise/value_noise.glsl)
float value_noise2(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy, out float result_dx,
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
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy) >> 8u;
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

// brick_grid (tiles/brick_grid.glsl)
void brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out Tile tile, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * 2.0;
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + 2161170183u);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = Tile(p - corner, vec2(0.5), hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * 2.0;
  tile_local_dy = uv_dy * 2.0;
}

// box_share (layers/box_share.glsl)
float box_share(vec2 q, vec2 local, vec2 q_dx, vec2 q_dy, vec2 local_dx, vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), 1e-5, 9.523809);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void layer_element_heads(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  vec2 p = tile.local - 0.5;
  vec2 q = 9.523809 * p + 0.5;
  vec2 q_dx = tile_local_dx * 9.523809;
  vec2 q_dy = tile_local_dy * 9.523809;
  float alpha2 = box_share(q, tile.local, q_dx, q_dy, tile_local_dx, tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.011024999, far);
  inner = Tile(q, 0.105 * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// screw_head (function of the graph)
vec4 screw_head(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  // disc: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float disc_dx = dot(difference, uv_dx) / greatest;
  float disc_dy = dot(difference, uv_dy) / greatest;
  float disc = norm - 0.3;
  // lower: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference2 = uv - vec2(0.53, 0.44);
  float norm2 = length(difference2);
  float greatest2 = max(norm2, 1e-20);
  float lower_dx = dot(difference2, uv_dx) / greatest2;
  float lower_dy = dot(difference2, uv_dy) / greatest2;
  float lower = norm2 - 0.28;
  // shine: ramp (patterns/ramp.glsl)
  vec3 shine = mix(vec3(0.03), vec3(0.75, 0.73, 0.7), clamp(uv.y, 0.0, 1.0));
  // plane: sdf_fill (shapes/sdf_fill.glsl)
  float plane = sdf_fill_shadow(disc, 0.12, disc_dx, disc_dy);
  // steel: lerp (math/lerp.glsl)
  vec3 steel = mix(shine, vec3(0.3, 0.29, 0.27), plane);
  // head: sdf_fill (shapes/sdf_fill.glsl)
  float head = sdf_fill_plate_mask(disc, disc_dx, disc_dy);
  // shade: sdf_fill (shapes/sdf_fill.glsl)
  float shade = sdf_fill_shadow(lower, 0.2, lower_dx, lower_dy);
  // shadow: multiply (math/multiply.glsl)
  float shadow = shade * 0.8;
  // covered: maximum (math/maximum.glsl)
  float covered = max(head, shadow);
  // lit: lerp (math/lerp.glsl)
  vec3 lit = steel * head;
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(lit, covered);
  return color;
}

// layer_element (layers/layer_element.glsl)
void layer_element_slots(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 180.0 * pose.y * 0.017453292;
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  vec2 p = tile.local - 0.5;
  vec2 point = vec2(cos(angle) * 9.523809);
  vec2 product = sin(angle) * 9.523809 * across;
  vec2 q = point * p + (product * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product;
  float alpha2 = box_share(q, tile.local, q_dx, q_dy, tile_local_dx, tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.011024999, far);
  inner = Tile(q, 0.105 * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// sdf_line (shapes/sdf_line.glsl)
float sdf_line(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv - vec2(0.3, 0.5);
  float side = -p.y;
  bool test = p.x < 0.0;
  bool test2 = p.x > 0.39999998;
  float beyond = p.x - clamp(p.x, 0.0, 0.39999998);
  float beyond_dx = uv_dx.x - (test ? 0.0 : test2 ? 0.0 : uv_dx.x);
  float beyond_dy = uv_dy.x - (test ? 0.0 : test2 ? 0.0 : uv_dy.x);
  bool test3 = p.y > -0.0;
  float beside = side * (test3 ? -1.0 : 1.0);
  float beside_slope = test3 ? 1.0 : -1.0;
  float side_dx = -uv_dx.y;
  float side_dy = -uv_dy.y;
  float beside_dx = uv_dx.y * beside_slope;
  float beside_dy = uv_dy.y * beside_slope;
  if (beyond != 0.0) {
    vec2 point = vec2(beyond, side);
    beside = length(point);
    float greatest = max(beside, 1e-20);
    beside_dx = dot(point, vec2(beyond_dx, side_dx)) / greatest;
    beside_dy = dot(point, vec2(beyond_dy, side_dy)) / greatest;
  }
  result_dx = beside_dx;
  result_dy = beside_dy;
  return beside - 0.045;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // plaster_coarse: value_noise (noise/value_noise.glsl)
  float plaster_coarse = value_noise(uv, vec2(7.0), 3, uv_dx, uv_dy);
  // plaster_fine: value_noise (noise/value_noise.glsl)
  float plaster_fine = value_noise(uv, vec2(90.0), 4, uv_dx, uv_dy);
  // plaster: lerp (math/lerp.glsl)
  float plaster = mix(plaster_coarse, plaster_fine, 0.4);
  // wall: lerp (math/lerp.glsl)
  vec3 wall = mix(vec3(0.5, 0.44, 0.34), vec3(0.66, 0.6, 0.49), plaster);
  // behind: sdf_rounded_rectangle (shapes/sdf_rounded_rectangle.glsl)
  float behind_dx, behind_dy;
  float behind = sdf_rounded_rectangle_behind(uv, uv_dx, uv_dy, behind_dx, behind_dy);
  // shadow: sdf_fill (shapes/sdf_fill.glsl)
  float shadow = sdf_fill_shadow(behind, 0.05, behind_dx, behind_dy);
  // shaded_wall: lerp (math/lerp.glsl)
  vec3 shaded_wall = mix(wall, vec3(0.09, 0.075, 0.06), shadow);
  // plate: sdf_rounded_rectangle (shapes/sdf_rounded_rectangle.glsl)
  float plate_dx, plate_dy;
  float plate = sdf_rounded_rectangle_plate(uv, uv_dx, uv_dy, plate_dx, plate_dy);
  // plate_mask: sdf_fill (shapes/sdf_fill.glsl)
  float plate_mask = sdf_fill_plate_mask(plate, plate_dx, plate_dy);
  // border: sdf_stroke (shapes/sdf_stroke.glsl)
  float border = sdf_stroke(plate, 0.014, -0.035, plate_dx, plate_dy);
  // hairline: sdf_stroke (shapes/sdf_stroke.glsl)
  float hairline = sdf_stroke(plate, 0.004, -0.052, plate_dx, plate_dy);
  // lines: maximum (math/maximum.glsl)
  float lines = max(border, hairline);
  // lined: lerp (math/lerp.glsl)
  vec3 lined = mix(enamel, cream, lines);
  // ring: sdf_ring (shapes/sdf_ring.glsl)
  float ring_dx, ring_dy;
  float ring = sdf_ring(uv, uv_dx, uv_dy, ring_dx, ring_dy);
  // arc_left: sdf_arc (shapes/sdf_arc.glsl)
  float arc_left_dx, arc_left_dy;
  float arc_left = sdf_arc(uv, 115.0, uv_dx, uv_dy, arc_left_dx, arc_left_dy);
  // arc_right: sdf_arc (shapes/sdf_arc.glsl)
  float arc_right_dx, arc_right_dy;
  float arc_right = sdf_arc(uv, -30.0, uv_dx, uv_dy, arc_right_dx, arc_right_dy);
  // jewel: sdf_regular_polygon (shapes/sdf_regular_polygon.glsl)
  float jewel_dx, jewel_dy;
  float jewel = sdf_regular_polygon(uv, uv_dx, uv_dy, jewel_dx, jewel_dy);
  // arcs: sdf_union (shapes/sdf_union.glsl)
  float arcs = min(arc_left, arc_right);
  bool test = arc_right < arc_left;
  float arcs_dx = test ? arc_right_dx : arc_left_dx;
  float arcs_dy = test ? arc_right_dy : arc_left_dy;
  // ring_and_arcs: sdf_union (shapes/sdf_union.glsl)
  float ring_and_arcs = min(ring, arcs);
  bool test2 = arcs < ring;
  float ring_and_arcs_dx = test2 ? arcs_dx : ring_dx;
  float ring_and_arcs_dy = test2 ? arcs_dy : ring_dy;
  // ornament: sdf_union (shapes/sdf_union.glsl)
  float ornament = min(ring_and_arcs, jewel);
  bool test3 = jewel < ring_and_arcs;
  float ornament_dx = test3 ? jewel_dx : ring_and_arcs_dx;
  float ornament_dy = test3 ? jewel_dy : ring_and_arcs_dy;
  // ornament_mask: sdf_fill (shapes/sdf_fill.glsl)
  float ornament_mask = sdf_fill_plate_mask(ornament, ornament_dx, ornament_dy);
  // ornamented: lerp (math/lerp.glsl)
  vec3 ornamented = mix(lined, cream, ornament_mask);
  // sharp_star: sdf_star (shapes/sdf_star.glsl)
  float sharp_star_dx, sharp_star_dy;
  float sharp_star = sdf_star(uv, uv_dx, uv_dy, sharp_star_dx, sharp_star_dy);
  // star: sdf_round (shapes/sdf_round.glsl)
  float star = sharp_star - 0.012;
  // star_height: remap (math/remap.glsl)
  float star_height = star / -0.07;
  // star_color: lerp (math/lerp.glsl)
  vec3 star_color = mix(vec3(0.55, 0.22, 0.015), gold, star_height);
  // star_mask: sdf_fill (shapes/sdf_fill.glsl)
  float star_mask = sdf_fill_plate_mask(star, sharp_star_dx, sharp_star_dy);
  // star_line: sdf_stroke (shapes/sdf_stroke.glsl)
  float star_line = sdf_stroke(star, 0.006, 0.014, sharp_star_dx, sharp_star_dy);
  // starred: lerp (math/lerp.glsl)
  vec3 starred = mix(ornamented, star_color, star_mask);
  // star_lined: lerp (math/lerp.glsl)
  vec3 star_lined = mix(starred, gold, star_line);
  // band: sdf_quadratic_curve (shapes/sdf_quadratic_curve.glsl)
  float band_dx, band_dy;
  float band = sdf_quadratic_curve(uv, uv_dx, uv_dy, band_dx, band_dy);
  // notch_left: sdf_triangle (shapes/sdf_triangle.glsl)
  float notch_left_dx, notch_left_dy;
  float notch_left = sdf_triangle(uv, vec2(0.105, 0.345), vec2(0.105, 0.205), vec2(0.205, 0.28),
      uv_dx, uv_dy, notch_left_dx, notch_left_dy);
  // notch_right: sdf_triangle (shapes/sdf_triangle.glsl)
  float notch_right_dx, notch_right_dy;
  float notch_right = sdf_triangle(uv, vec2(0.895, 0.345), vec2(0.895, 0.205), vec2(0.795, 0.28),
      uv_dx, uv_dy, notch_right_dx, notch_right_dy);
  // notches: sdf_union (shapes/sdf_union.glsl)
  float notches = min(notch_left, notch_right);
  bool test4 = notch_right < notch_left;
  float notches_dx = test4 ? notch_right_dx : notch_left_dx;
  float notches_dy = test4 ? notch_right_dy : notch_left_dy;
  // ribbon: sdf_difference (shapes/sdf_difference.glsl)
  float ribbon = max(band, -notches);
  bool test5 = band < -notches;
  float ribbon_dx = test5 ? -notches_dx : band_dx;
  float ribbon_dy = test5 ? -notches_dy : band_dy;
  // ribbon_mask: sdf_fill (shapes/sdf_fill.glsl)
  float ribbon_mask = sdf_fill_plate_mask(ribbon, ribbon_dx, ribbon_dy);
  // ribbon_line: sdf_stroke (shapes/sdf_stroke.glsl)
  float ribbon_line = sdf_stroke(ribbon, 0.006, -0.012, ribbon_dx, ribbon_dy);
  // halo: sdf_round (shapes/sdf_round.glsl)
  float halo = ribbon - 0.012;
  // halo_mask: sdf_fill (shapes/sdf_fill.glsl)
  float halo_mask = sdf_fill_plate_mask(halo, ribbon_dx, ribbon_dy);
  // cleared: lerp (math/lerp.glsl)
  vec3 cleared = mix(star_lined, enamel, halo_mask);
  // ribboned: lerp (math/lerp.glsl)
  vec3 ribboned = mix(cleared, red, ribbon_mask);
  // painted: lerp (math/lerp.glsl)
  vec3 painted = mix(ribboned, cream, ribbon_line);
  // bulge: smooth_step (math/smooth_step.glsl)
  float bulge = smooth_step(plate);
  // light: ramp (patterns/ramp.glsl)
  float clamped = clamp(uv.y, 0.0, 1.0);
  float light = mix(0.75, 1.35, clamped);
  // gloss: multiply (math/multiply.glsl)
  vec3 gloss = painted * light;
  // light_up: ramp (patterns/ramp.glsl)
  float light_up = mix(-0.4, 1.0, clamped);
  // rim: lerp (math/lerp.glsl)
  vec3 rim = mix(vec3(0.03, 0.03, 0.035), vec3(0.3, 0.32, 0.36), light_up);
  // rim_amount: multiply (math/multiply.glsl)
  float rim_amount = bulge * 0.6;
  // bulged: lerp (math/lerp.glsl)
  vec3 bulged = mix(gloss, rim, rim_amount);
  // bites_coarse: value_noise (noise/value_noise.glsl)
  float bites_coarse_dx, bites_coarse_dy;
  float bites_coarse = value_noise2(uv, vec2(13.0), 8, uv_dx, uv_dy, bites_coarse_dx,
      bites_coarse_dy);
  // bites_fine: value_noise (noise/value_noise.glsl)
  float bites_fine_dx, bites_fine_dy;
  float bites_fine = value_noise2(uv, vec2(70.0), 9, uv_dx, uv_dy, bites_fine_dx, bites_fine_dy);
  // bites: lerp (math/lerp.glsl)
  float bites = mix(bites_coarse, bites_fine, 0.3);
  float bites_dx = mix(bites_coarse_dx, bites_fine_dx, 0.3);
  float bites_dy = mix(bites_coarse_dy, bites_fine_dy, 0.3);
  // bite_depth: remap (math/remap.glsl)
  float bite_depth = mix(-0.01, wear, (bites - 0.55) / 0.3);
  float bite_depth_slope = wear + 0.01;
  // eaten: add (math/add.glsl)
  float eaten = plate + bite_depth;
  float bite_depth_dx = bites_dx / 0.3 * bite_depth_slope;
  float bite_depth_dy = bites_dy / 0.3 * bite_depth_slope;
  float eaten_dx = plate_dx + bite_depth_dx;
  float eaten_dy = plate_dy + bite_depth_dy;
  // intact: negate (math/negate.glsl)
  float intact = -eaten;
  // rust_mask: sdf_fill (shapes/sdf_fill.glsl)
  float intact_dx = -eaten_dx;
  float intact_dy = -eaten_dy;
  float rust_mask = sdf_fill_plate_mask(intact, intact_dx, intact_dy);
  // rust_color: lerp (math/lerp.glsl)
  vec3 rust_color = mix(vec3(0.06, 0.018, 0.006), vec3(0.28, 0.085, 0.02), bites_fine);
  // rusty: lerp (math/lerp.glsl)
  vec3 rusty = mix(bulged, rust_color, rust_mask);
  // hung: lerp (math/lerp.glsl)
  vec3 hung = mix(shaded_wall, rusty, plate_mask);
  // screw_uv_scaled: multiply (math/multiply.glsl)
  vec2 screw_uv_scaled = uv * 0.724638;
  // screw_uv: add (math/add.glsl)
  vec2 screw_uv = screw_uv_scaled + 0.137681;
  // corners: brick_grid (tiles/brick_grid.glsl)
  vec2 screw_uv_dx = uv_dx * 0.724638;
  vec2 screw_uv_dy = uv_dy * 0.724638;
  Tile corners;
  vec2 corners_local_dx, corners_local_dy;
  brick_grid(screw_uv, screw_uv_dx, screw_uv_dy, corners, corners_local_dx, corners_local_dy);
  // heads: layer (layers/layer.glsl)
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_heads(corners, corners_local_dx, corners_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 screw_head_value = screw_head(inner.local, inner_local_dx, inner_local_dy);
  float heads_alpha = screw_head_value.w * alpha;
  // slots: layer (layers/layer.glsl)
  float alpha2;
  Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  layer_element_slots(corners, corners_local_dx, corners_local_dy, alpha2, inner2, inner_local_dx2,
      inner_local_dy2);
  float result_dx, result_dy;
  float sdf_line_value = sdf_line(inner2.local, inner_local_dx2, inner_local_dy2, result_dx,
      result_dy);
  float slots_alpha = sdf_fill_plate_mask(sdf_line_value, result_dx, result_dy) * alpha2;
  // heads_mask: multiply (math/multiply.glsl)
  float heads_mask = heads_alpha * plate_mask;
  // screwed: lerp (math/lerp.glsl)
  vec3 screwed = mix(hung, screw_head_value.xyz, heads_mask);
  // slots_mask: multiply (math/multiply.glsl)
  float slots_mask = slots_alpha * plate_mask;
  // slotted: lerp (math/lerp.glsl)
  vec3 slotted = mix(screwed, vec3(0.01), slots_mask);
  // finished: rgba (channels/rgba.glsl)
  vec4 finished = vec4(slotted, 1.0);
  // enamel_roughness: lerp (math/lerp.glsl)
  float enamel_roughness = mix(0.15, 0.9, rust_mask);
  // roughness: lerp (math/lerp.glsl)
  float roughness = mix(0.95, enamel_roughness, plate_mask);
  out_color = finished;
  out_roughness = roughness;
}
