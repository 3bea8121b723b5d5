// SPDX-License-Identifier: Apache-2.0
// Graphs of any size for benchmarks, as JSON texts.
#pragma once

#include <string>

namespace texgraph::bench {

// n additions, each of the one before and a number that none of them shares.
std::string ChainOfAdds(int n);
// n pairs of a noise, no two alike, and a mix of it with the pair before.
std::string NoiseAndMixPairs(int n);
// n samples of tiled pictures over `files` files, no two alike, summed up. The files need not exist
// to make the text.
std::string TiledImages(int n, int files);
// A chain in which each node takes the one before twice: 2^n paths through n nodes.
std::string Diamond(int n);
// Copies of noise are the image of a bombing, which is the image of the next, and so on: `depth`
// bombings inside of one another.
std::string BombingInsideBombing(int depth);

}  // namespace texgraph::bench
