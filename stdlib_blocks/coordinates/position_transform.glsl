// SPDX-License-Identifier: Apache-2.0
/// Moves, turns and scales whatever is drawn in space at its result: `uv_transform` of three
/// dimensions.
/// What is drawn is scaled and then turned about the pivot, and then moved; so the coordinate is
/// taken the opposite way.
/// @param position coordinate @default position
/// @param translate how far to move @default vec3(0)
/// @param angle how far to turn about the axis, counter-clockwise as seen from its tip @default 0
///   @unit degrees
/// @param axis of any length above 0 @default vec3(0, 1, 0)
/// @param scale how many times as large, along each axis of the coordinate; not 0
///   @default vec3(1)
/// @param pivot the place that stays where it is while turning and scaling @default vec3(0)
vec3 position_transform(vec3 position, vec3 translate, float angle, vec3 axis, vec3 scale,
                        vec3 pivot) {
  return rotate3d(position - (pivot + translate), -angle, axis, vec3(0.0)) / scale + pivot;
}
