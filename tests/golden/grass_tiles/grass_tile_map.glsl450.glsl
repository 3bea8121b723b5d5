// grass_tile_map: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2D grass_atlas;
uniform sampler2D plan;

// pack_place (by_example/pack_place.glsl)
vec2 grass_tile_map_pack_place(sampler2D tiles, ivec2 place, vec2 local, vec2 local_dx,
    vec2 local_dy, out vec2 result_dx, out vec2 result_dy) {
  vec2 at = (vec2(place) + local) * 0.25;
  vec2 size = vec2(textureSize(tiles, 0));
  float part = 4.0 * size.x / (4.0 * size.y);
  vec2 at_dx = local_dx * 0.25;
  vec2 at_dy = local_dy * 0.25;
  at = vec2(at.x, 0.5 + (at.y - 0.5) * part);
  result_dx = vec2(at_dx.x, at_dx.y * part);
  result_dy = vec2(at_dy.x, at_dy.y * part);
  return at;
}

// tile_map (by_example/tile_map.glsl)
vec4 grass_tile_map_tile_map(sampler2D tiles, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 cell = ivec2(whole) & 63;
  int index = int(texelFetch(plan, cell, 0).x);
  int which = clamp(index, 0, 15);
  vec2 local_dx = uv_dx * 8.0;
  vec2 local_dy = uv_dy * 8.0;
  vec2 place_dx, place_dy;
  vec2 place = grass_tile_map_pack_place(tiles, ivec2(which & 3, which >> 2), local, local_dx,
      local_dy, place_dx, place_dy);
  vec4 seen = textureGrad(tiles, place, place_dx, place_dy);
  vec4 color = index < 0 ? vec4(0.0) : seen;
  return color;
}

void grass_tile_map(vec2 uv, out vec4 color, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // blades: tile_map (by_example/tile_map.glsl)
  vec4 blades_color = grass_tile_map_tile_map(grass_atlas, uv, uv_dx, uv_dy);
  color = blades_color;
  roughness = 0.9;
}
