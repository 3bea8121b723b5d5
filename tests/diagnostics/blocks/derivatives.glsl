/// What the compiler does itself, and what differs between machines.
float derivatives(float x) {
  x += dFdx(x) + fwidth(x);
  return fract(sin(x) * 43758.5453);
}
