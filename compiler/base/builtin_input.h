// SPDX-License-Identifier: Apache-2.0
// The inputs that every graph has, by name: type and meaning. Graphs refer to them, and blocks name
// them as defaults of ports.
#pragma once

#include <string_view>

namespace texgraph {

struct BuiltinInput {
  std::string_view name;
  std::string_view type;
  std::string_view help;
};

// In this order in manifests and shaders.
inline constexpr BuiltinInput kBuiltinInputs[] = {
    {"uv", "vec2", "texture coordinate"},
    {"position", "vec3", "position on the surface, in object space"},
    {"normal", "vec3", "unit normal of the surface, in object space"},
    {"time", "float", "seconds since the start"},
};

}  // namespace texgraph
