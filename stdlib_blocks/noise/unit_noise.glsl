// SPDX-License-Identifier: Apache-2.0
/// Perlin's noise with one cell for each unit of the coordinate: what fractals add up where no
/// other noise is connected.
/// From 0 to 1, with the mean 0.5. It is `gradient_noise` with a scale of 1.
/// @source Perlin, Improving Noise, SIGGRAPH 2002
/// @param uv coordinate @default uv
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
float unit_noise(vec2 uv, uint faded_cells) {
  vec2 gradient;
  float value = gradient_noise(uv, vec2(1.0), 0, ivec2(0), true, faded_cells, gradient);
  return value;
}

/// @param uv coordinate
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
float unit_noise(float uv, uint faded_cells) {
  float gradient;
  float value = gradient_noise(uv, 1.0, 0, 0, true, faded_cells, gradient);
  return value;
}

/// @param uv coordinate @default position
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
float unit_noise(vec3 uv, uint faded_cells) {
  vec3 gradient;
  float value = gradient_noise(uv, vec3(1.0), 0, ivec3(0), true, faded_cells, gradient);
  return value;
}

/// @param uv coordinate
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
float unit_noise(vec4 uv, uint faded_cells) {
  vec4 gradient;
  float value = gradient_noise(uv, vec4(1.0), 0, ivec4(0), true, faded_cells, gradient);
  return value;
}
