// SPDX-License-Identifier: Apache-2.0
/// The pattern that a tile shows where `transition_tiles` says whether it needs a transition.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.3, Transition
///   Tiles
/// @param plain the tile's own pattern, where no transition is needed
/// @param transition the transition's pattern, -1 for none
/// @return one of the two @one_of plain transition
int transition_pattern(int plain, int transition) { return transition < 0 ? plain : transition; }
