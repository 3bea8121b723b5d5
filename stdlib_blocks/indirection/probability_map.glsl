// SPDX-License-Identifier: Apache-2.0
/// A pattern that comes up as often as it stands in a list.
/// In a list of P numbers, one that stands there n times has the probability n / P exactly.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Probability
///   Map
/// @param random a random number, at least 0 and below 1; beyond, it counts as the nearest such
/// @param patterns the list; -1 is nothing @range -1 65535
/// @return one of the list @one_of patterns
int probability_map(float random, const int patterns[]) {
  return patterns[int(clamp(random, 0.0, 1.0) * float(patterns.length()))];
}

/// From a texture with several lists one is taken, a row.
/// @param random a random number, at least 0 and below 1; beyond, it counts as the nearest such
/// @param lists a list a row, from the row v = 0, in the first channel
/// @param list which list, from 0; below 0 there is none, and the result is -1. Beyond the last it
///   is the last @below lists
/// @return one of the list, or -1 @one_of lists
int probability_map(float random, sampler2D lists, int list) {
  ivec2 size = textureSize(lists, 0);
  ivec2 place = ivec2(int(clamp(random, 0.0, 1.0) * float(size.x)), list);
  int pattern = int(texelFetch(lists, clamp(place, ivec2(0), size - 1), 0).r);
  return list < 0 ? -1 : pattern;
}
