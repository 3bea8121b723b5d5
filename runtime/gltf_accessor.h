// SPDX-License-Identifier: Apache-2.0
// The numbers behind an accessor of a glTF file, checked: tinygltf hands out whatever the file says
// of offsets, counts and indices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace texgraph::runtime {

// `count` elements of `components` floats, sparse ones put in and integers turned into numbers as
// the accessor says. False, with what is wrong in `why_not`, if any of it is outside of the file,
// not finite, of another shape, or more than `limit` elements.
bool ReadFloats(const tinygltf::Model& model, int accessor, uint32_t components, size_t limit,
                std::vector<float>& floats, std::string& why_not);

// The same for indices.
bool ReadIndices(const tinygltf::Model& model, int accessor, size_t limit,
                 std::vector<uint32_t>& indices, std::string& why_not);

}  // namespace texgraph::runtime
