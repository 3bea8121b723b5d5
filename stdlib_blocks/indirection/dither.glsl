// SPDX-License-Identifier: Apache-2.0
/// One of two numbers at random: in place of a mix, for what cannot be mixed, such as numbers of
/// patterns.
/// For a share of 0 it is always the first, for 1 always the second. The paper's figure 8 has it
/// the other way round than its text; the text is right.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Dithered
///   Areas Map, and figure 8
/// @param a the first
/// @param b the second
/// @param share how often it is the second @range 0 1
/// @param random a random number, at least 0 and below 1
/// @return one of the two @one_of a b
int dither(int a, int b, float share, float random) { return random < share ? b : a; }
