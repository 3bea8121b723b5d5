/// A mistake in the middle of the file.
float broken_syntax(float x) {
  float y = x +;
  return y * (2.0;
}
