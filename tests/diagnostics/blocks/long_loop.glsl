/// More rounds than any driver makes.
/// @param x start
/// @param n rounds @default 300
float long_loop(float x, const int n) {
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) x = sin(x);
  }
  return x;
}
