// SPDX-License-Identifier: Apache-2.0
/// The pattern that a tile shows where `transition_tiles` chose between its own and a transition.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.3, Transition
///   Tiles
/// @param plain the tile's own pattern, where no transition is needed
/// @param transition the number of the transition, -1 for none
/// @param first the pattern of transition 0. The plain tiles among the numbers, 0 for one, never
///   come up: with two families, and transitions 1 to 14 as patterns 16 to 29, it is 15
/// @return a pattern
int transition_pattern(int plain, int transition, const int first) {
  return transition < 0 ? plain : first + transition;
}
