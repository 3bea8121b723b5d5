// SPDX-License-Identifier: Apache-2.0
// The inputs that every graph has, by name: type and meaning. Graphs refer to them, and blocks name
// them as defaults of ports.
#pragma once

#include <cstdint>
#include <string_view>

namespace texgraph {

enum class BuiltinKind : uint8_t {
  kVarying,  // varies over the surface
  kUniform,  // the same for a whole frame
  kZero,     // 0 but where a function port gives another
};

struct BuiltinInput {
  std::string_view name;
  std::string_view type;
  std::string_view help;
  BuiltinKind kind = BuiltinKind::kVarying;
};

// In this order in manifests and shaders.
inline constexpr BuiltinInput kBuiltinInputs[] = {
    {"uv", "vec2", "texture coordinate"},
    {"position", "vec3", "position on the surface, in object space"},
    {"normal", "vec3", "unit normal of the surface, in object space"},
    {"time", "float", "seconds since the start", BuiltinKind::kUniform},
    {"neighbour", "ivec2",
     "which of the tiles around a place is asked for, as columns and rows further; (0, 0), the "
     "tile "
     "that it is in, unless a block such as layer looks around",
     BuiltinKind::kZero},
};

}  // namespace texgraph
