/// Bounds that are not known, indexes that are outside.
const float SIZE[2] = float[2](1.0, 2.0);
float folded_index(float x, int n) {
  for (int i = 0; i < n; i++) x += 1.0;
  return x + SIZE[5];
}
