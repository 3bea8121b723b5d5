/// Arrays where there are none.
float total(float values[]) { return values[0]; }
vec2 field(const vec2 points[]);
float array_misuse(float heights[2], const bool flags[], const vec2 points[]) {
  vec2 copy[2] = points;
  return points[0] == points[1] ? 1.0 : 0.0;
}
