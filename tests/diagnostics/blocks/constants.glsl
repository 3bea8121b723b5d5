/// Values that must be known, and are not, or cannot be.
const float SIZE[2] = float[2](1.0, 2.0, 3.0);
const float HALF = 1.0 / 0.0;
float constants(float x, int n) {
  for (int i = 0; i < n; i++) x += 1.0;
  return x + SIZE[5];
}
