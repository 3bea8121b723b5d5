/// The length of a line with corners.
/// @param points the corners @length 2 4
/// @param weights of the segments @range 0 1
float polyline_length(const vec2 points[], const float weights[]) {
  float sum = 0.0;
  for (int i = 1; i < points.length(); i++) {
    sum += distance(points[i - 1], points[i]) * weights[i - 1];
  }
  return sum + weights[points.length() - 2];
}
