// SPDX-License-Identifier: Apache-2.0
// A shader's manifest as a structure: what texgraphc writes beside the shader, and all that a
// renderer must know to bind it. Any manifest may come from strangers; what is read here has been
// checked. docs/manifest.schema.json has the format.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/graph/document.h"
#include "compiler/ir/type.h"
#include "compiler/textures/prepare.h"
#include "compiler/textures/texels.h"

namespace texgraph::runtime {

enum class ShaderDialect : uint8_t { kGlsl330, kGlsl450, kSpirv };

struct ManifestInput {
  std::string name;      // uv, position, normal or time
  std::string variable;  // in the shader, an identifier; "" is the name
  ir::TypeId type;
  std::optional<uint32_t> location;
};

struct ManifestOutput {
  std::string name;      // "color"
  std::string variable;  // "out_color"
  ir::TypeId type;       // float, vec2, vec3 or vec4
};

struct ManifestParameter {
  std::string name;
  std::string variable;  // the uniform in the shader; "" is the name
  ir::TypeId type;
  bool is_uniform =
      false;  // of the shader; the others were folded, dropped or are specialisation constants
  std::string status;  // "uniform", "folded", "unused", "specialization"
  std::vector<double>
      value;  // one number for each component, matrices column by column, bools 0 or 1
  std::optional<std::array<double, 2>> range;
  SourceRange place;
};

// What the texels of a map are: docs/manifest.md.
enum class MapContents : uint8_t { kPatterns, kLists, kTiles, kNumbers, kSprites };

struct ManifestMap {
  MapContents holds = MapContents::kNumbers;
  std::optional<uint32_t> count;  // numbers, and patterns of sprites, are below it
};

struct ManifestTexture {
  std::string name;
  std::string variable;  // the sampler in the shader; textures that are alike share one
  bool is_used = true;
  std::vector<std::string> files;  // relative to the manifest's folder
  bool has_levels = false;         // one KTX 2.0 file, with all that is uploaded
  // What is still to be done with the files: none, one or a mask for each; relative paths, too.
  std::vector<textures::MaskSource> masks;
  std::optional<textures::ColorKey> key;
  textures::TextureOptions options;
  std::optional<ManifestMap> map;
  bool is_folded = false;  // a map whose numbers are part of the shader
  SourceRange place;
};

struct Manifest {
  std::string name;
  std::string shader;  // the file, relative to the manifest's folder; empty if it was never one
  ShaderDialect dialect = ShaderDialect::kGlsl330;
  bool is_function = false;  // --emit=function: to be pasted into a shader, as --mesh does
  std::string entry_point;   // the function's name; "" or main otherwise
  std::vector<ManifestInput> inputs;
  std::vector<ManifestOutput> outputs;
  std::vector<ManifestParameter> parameters;
  std::vector<ManifestTexture> textures;
};

// Whether the document is a manifest (and not a graph).
bool IsManifest(const graph::Document& document);
// Every mistake is reported as kManifest; nothing is returned if there was any. Keys that it
// doesn't know are ignored, so that later versions may add some.
std::optional<Manifest> ReadManifest(const graph::Document& document, Diagnostics& diagnostics);

// Applies "name=value" texts to uniform parameters: a number, true, false, or [numbers]. Reports
// unknown names, parameters that are no uniforms, wrong types and values out of range; false then.
bool ApplySettings(const std::vector<std::string>& settings, Sources& sources, Manifest& manifest,
                   Diagnostics& diagnostics);
// The same for numbers: one for each component, or one for all; a bool is 0 or not.
bool SetParameter(std::string_view name, std::span<const double> numbers, Manifest& manifest,
                  Diagnostics& diagnostics);

}  // namespace texgraph::runtime
