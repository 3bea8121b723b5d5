/// A loop that does not move.
float endless(float x) {
  for (int i = 0; i < 10; i += 0) x += 1.0;
  return x;
}
