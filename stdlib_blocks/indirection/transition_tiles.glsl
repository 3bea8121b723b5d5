// SPDX-License-Identifier: Apache-2.0
/// Which transition a tile needs between families of materials that do not fit each other: from the
/// families of the tile, of the next one to the right, of the upper one and of the one between.
/// Materials are of one family where their patterns match at the borders. Draw the tile's own
/// pattern where the transition is -1, else the transition's. For m families, 0 to m - 1, there are
/// m^4 of them, in the order of their numbers families[here] + m families[right] +
/// m^2 families[up] + m^3 families[both]. They match where each border depends on the families of
/// its two corners alone.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.3, Transition
///   Tiles, and figure 11
/// @param material the material of the tile, and of the tiles around it; an areas map that takes
///   a tile map
/// @param families the family of each material, from 0 @range 0 4
/// @param transitions the pattern of each number. What stands where all four are of one family,
///   number 0 for one, is never shown: -1, say @range -1 65535 @transitions families
/// @param material_here the tile's material @one_of material
/// @param transition the transition's pattern; -1 where all four are of one family
///   @one_of transitions
int material(ivec2 neighbour);

// The family of a material. Nothing, -1, is of the first one's.
int family_of(int which, const int families[]) { return families[which]; }

void transition_tiles(const int families[], const int transitions[], out int material_here,
                      out int transition) {
  // There are m^4 transitions.
  const int m = int(sqrt(sqrt(float(transitions.length()))) + 0.5);
  material_here = material(ivec2(0));
  int here = family_of(material_here, families);
  int right = family_of(material(ivec2(1, 0)), families);
  int up = family_of(material(ivec2(0, 1)), families);
  int both = family_of(material(ivec2(1, 1)), families);
  int number = here + m * (right + m * (up + m * both));
  bool plain = number == here * (1 + m * (1 + m * (1 + m)));
  transition = plain ? -1 : transitions[number];
}
