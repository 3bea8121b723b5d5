/// A loop whose bound is not known.
/// @param x start
/// @param n rounds
float unknown_bound(float x, int n) {
  for (int i = 0; i < n; i++) x = sin(x);
  return x;
}
