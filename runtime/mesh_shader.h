// SPDX-License-Identifier: Apache-2.0
// The shader that shows a graph on a mesh: the graph as a GLSL function, as the compiler prints it,
// and around it the light. Nothing in the graph's text is changed.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "runtime/manifest.h"

namespace texgraph::runtime {

// The vertex attributes, in the order of Vertex.
enum MeshAttribute : unsigned {
  kPositionAttribute,
  kNormalAttribute,
  kTangentAttribute,
  kUvAttribute
};

struct MeshShader {
  std::string vertex;
  std::string fragment;
  // What all names of these texts begin with that are not the graph's own: uniforms are PREFIXeye
  // and so on, fragment output i is PREFIXout<i>.
  std::string prefix;
};

// `function` is the graph's text, described by `manifest`. `outputs` are drawn in this order: names
// of the graph's outputs, or kLitOutput.
MeshShader ComposeMeshShader(const std::string& function, const Manifest& manifest,
                             std::span<const std::string_view> outputs);

// Averages the samples of each pixel. In its main: the uniforms `samples`, `side`, `is_light`,
// `is_toned` and `background`.
std::string ResolveVertexShader();
std::string ResolveFragmentShader();

}  // namespace texgraph::runtime
