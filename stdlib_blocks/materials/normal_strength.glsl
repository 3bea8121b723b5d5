// SPDX-License-Identifier: Apache-2.0
/// Makes the relief that a normal shows steeper or flatter, of length 1.
/// The slopes are multiplied, as if the heights were. Slopes steeper than 100 count as 100.
/// @source Blender, "Normal Map", Strength
/// @param normal of the relief, in texture space
/// @param strength how many times as steep: 0 is flat, below 0 hollows become hills @default 1
vec3 normal_strength(vec3 normal, float strength) {
  vec3 n = vec3(strength * normal.xy / max(normal.z, 0.01), 1.0);
  return n * inversesqrt(dot(n, n));
}
