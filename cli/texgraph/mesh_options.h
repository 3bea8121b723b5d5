// SPDX-License-Identifier: Apache-2.0
// The options of --mesh: camera, light, how the texture lies on the mesh, and what is behind it.
#pragma once

#include <optional>
#include <string>

#include "cli/texgraph/render_options.h"

namespace texgraph::cli {

// Their texts; "" where one was not given.
struct MeshTexts {
  std::string camera;
  std::string field_of_view;
  std::string light;
  std::string tile;
  std::string relief;
  std::string samples;
  std::string background;
};

// Needs options.mesh.mesh and options.mesh.turntable. `has_window`: --uv was given.
void ReadMeshOptions(const MeshTexts& texts, bool has_window, RenderOptions& options,
                     Diagnostics& diagnostics);

// The scene of options.mesh: its mesh made or read, and the camera where it shows all of it, on a
// turntable in every frame. Nothing, with what is wrong reported, if there is no such mesh.
std::optional<runtime::Scene> MakeScene(const RenderOptions& options, Diagnostics& diagnostics);

}  // namespace texgraph::cli
