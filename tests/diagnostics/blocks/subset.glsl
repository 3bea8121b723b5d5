/// What the block language leaves out.
uniform float speed;
float subset(float x) {
  while (x > 1.0) x -= 1.0;
  for (int i = 0; i < int(x); i++) x += 1.0;
  if (x > 0.5) discard;
  x += dFdx(x);
  return fract(sin(x) * 43758.5453);
}
