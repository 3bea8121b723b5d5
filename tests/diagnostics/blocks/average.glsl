/// The mean of a hundred places.
/// @param image what is averaged
/// @param uv where @default uv
float image(vec2 uv);
float average(vec2 uv) {
  float sum = 0.0;
  for (int i = 0; i < 100; i++) sum += image(uv + 0.01 * float(i));
  return sum / 100.0;
}
