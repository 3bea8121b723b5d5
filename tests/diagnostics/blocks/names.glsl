/// Names that are not there, or not allowed.
float names(float x, float sample) {
  float gl_y = undefined_name + missing_function(x) + x;
  float y = noise(x);
  return gl_y.q;
}
