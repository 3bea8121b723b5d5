// SPDX-License-Identifier: Apache-2.0
// A map of whole numbers, of patterns, materials or lists: as a graph has it, and as a texture is
// made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace texgraph {

struct NumberMap {
  uint32_t width = 0;
  uint32_t height = 0;
  // Row 0 is v = 0; -1 is nothing. None while a picture is not decoded.
  std::vector<int32_t> numbers;

  int32_t At(uint32_t x, uint32_t y) const { return numbers[size_t{y} * width + x]; }
  bool operator==(const NumberMap&) const = default;
};

// A map from rows as people write them, the first at the top. All have equally many numbers.
NumberMap MapOfRows(std::span<const std::vector<int32_t>> rows);

// Row i, counted from v = 0, is list i. Lists may have different lengths if each divides the
// longest: shorter ones are repeated, so that a number's share is the same. No list is empty.
// Nothing if a length does not divide the longest.
std::optional<NumberMap> MapOfLists(std::span<const std::vector<int32_t>> lists);

}  // namespace texgraph
