/// Types that do not fit.
float wrong_types(vec3 v, float x) {
  vec2 a = v;
  bool b = x;
  int i = 1.5;
  if (x) x = 1.0;
  x = mix(v, x, 1);
  return v;
}
