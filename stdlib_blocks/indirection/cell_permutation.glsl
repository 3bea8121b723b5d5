// SPDX-License-Identifier: Apache-2.0
// A permutation of 0 to 255: the numbers in the order of their `hash`.
const int SIGMA[256] = int[256](
    246, 224, 89, 207, 124, 252, 133, 62, 0, 145, 96, 32, 14, 163, 37, 117, 188, 66, 48, 165, 97,
    166, 8, 229, 158, 175, 150, 19, 215, 194, 13, 111, 171, 107, 126, 232, 4, 178, 23, 114, 30,
    131, 50, 67, 20, 177, 15, 248, 112, 98, 169, 212, 185, 74, 100, 162, 251, 54, 16, 213, 134,
    38, 135, 181, 140, 123, 36, 196, 21, 244, 11, 120, 78, 200, 193, 58, 42, 119, 170, 47, 12,
    149, 9, 199, 174, 143, 28, 156, 227, 153, 142, 231, 34, 29, 204, 132, 155, 101, 195, 141, 184,
    192, 157, 125, 180, 39, 190, 129, 68, 56, 253, 233, 82, 10, 53, 234, 115, 151, 201, 211, 206,
    90, 84, 2, 92, 7, 103, 223, 3, 230, 5, 77, 219, 138, 197, 173, 210, 64, 209, 147, 235, 238,
    118, 249, 57, 160, 35, 94, 137, 71, 130, 237, 187, 243, 104, 255, 22, 216, 51, 99, 108, 186,
    91, 176, 65, 87, 63, 40, 1, 24, 167, 198, 128, 136, 52, 102, 220, 146, 214, 75, 205, 60, 116,
    168, 43, 88, 144, 236, 93, 46, 250, 85, 242, 59, 26, 44, 61, 41, 25, 72, 113, 203, 172, 33,
    122, 17, 152, 139, 161, 86, 27, 106, 154, 164, 83, 76, 79, 225, 221, 18, 218, 55, 127, 191,
    73, 240, 80, 226, 239, 121, 254, 179, 183, 110, 217, 49, 159, 245, 222, 6, 105, 45, 189, 109,
    182, 247, 228, 69, 202, 148, 241, 31, 81, 70, 208, 95);

int sigma(int index) { return SIGMA[index & 255]; }

/// A number from 0 to 255 for a cell of a line, from the paper's table of permutations.
/// The sum s0 = sigma(x), s1 = sigma(x / 256 + s0), s2 = sigma(x / 65536 + s1): lines of 2^24 cells
/// before it repeats. In each run of 256 cells from a multiple of 256 on every number comes once:
/// it is more even than chance, with hardly two equal neighbours, and has periods that the eye
/// finds. `cell_hash` has none of that and is the default of the blocks; the table is there to
/// compare, and for machines that multiply integers slowly.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Virtual
///   Indirection Map; Perlin, An Image Synthesizer, SIGGRAPH 1985
/// @param cell which cell
/// @return from 0 to 255
uint cell_permutation(int cell) {
  int s = sigma(cell);
  s = sigma((cell >> 8) + s);
  return uint(sigma((cell >> 16) + s));
}

/// In a grid each step is Perlin's sigma(x + sigma(y)). The paper's vector of two tables makes x
/// depend on the column alone, and whole columns alike.
/// @param cell column and row
uint cell_permutation(ivec2 cell) {
  int s = sigma(cell.x + sigma(cell.y));
  s = sigma((cell.x >> 8) + sigma((cell.y >> 8) + s));
  return uint(sigma((cell.x >> 16) + sigma((cell.y >> 16) + s)));
}

/// @param cell column, row and slice
uint cell_permutation(ivec3 cell) {
  int s = sigma(cell.x + sigma(cell.y + sigma(cell.z)));
  s = sigma((cell.x >> 8) + sigma((cell.y >> 8) + sigma((cell.z >> 8) + s)));
  return uint(sigma((cell.x >> 16) + sigma((cell.y >> 16) + sigma((cell.z >> 16) + s))));
}
