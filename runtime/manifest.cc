// SPDX-License-Identifier: Apache-2.0
#include "runtime/manifest.h"

#include <fmt/format.h>

#include "compiler/base/builtin_input.h"
#include "compiler/base/text.h"
#include "compiler/textures/maps.h"

namespace texgraph::runtime {
namespace {

using graph::Document;
using graph::DocumentKind;
using graph::DocumentNode;

constexpr uint32_t kMaxLocation = 255;
constexpr uint32_t kMaxMipLevel = 31;

class Reader {
 public:
  Reader(const Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {}

  Manifest Read();

 private:
  void Error(SourceRange range, std::string message) {
    diagnostics_.Error(DiagnosticKind::kManifest, range, std::move(message));
  }

  // The member of that kind, or null; reported if it is of another kind, or missing and `required`.
  const DocumentNode* Find(const DocumentNode& object, std::string_view key, DocumentKind kind,
                           bool required) {
    const DocumentNode* node = document_.Find(object, key);
    if (node == nullptr) {
      if (required) Error(object.range, fmt::format("the manifest has no '{}' here", key));
      return nullptr;
    }
    if (node->kind == kind) return node;
    Error(node->range, fmt::format("'{}' of the manifest is of the wrong kind", key));
    return nullptr;
  }

  std::string Text(const DocumentNode& object, std::string_view key, bool required = true) {
    const DocumentNode* node = Find(object, key, DocumentKind::kString, required);
    return node ? std::string(node->text) : "";
  }

  // The index of the member's text in `words`, 0 if it is missing.
  template <size_t N>
  uint32_t Word(const DocumentNode& object, std::string_view key, bool required,
                const std::string_view (&words)[N]) {
    const DocumentNode* node = Find(object, key, DocumentKind::kString, required);
    if (node == nullptr) return 0;
    return WordIndex(*node, key, words);
  }

  template <size_t N>
  uint32_t WordIndex(const DocumentNode& node, std::string_view key,
                     const std::string_view (&words)[N]) {
    for (uint32_t i = 0; i < N; ++i) {
      if (node.text == words[i]) return i;
    }
    Error(node.range, fmt::format("'{}' is no {} of a manifest", Printable(node.text), key));
    return 0;
  }

  std::optional<uint32_t> Integer(const DocumentNode& object, std::string_view key, uint32_t most) {
    const DocumentNode* node = Find(object, key, DocumentKind::kNumber, false);
    if (node == nullptr) return std::nullopt;
    if (node->is_integer && node->integer >= 0 && node->integer <= most) {
      return static_cast<uint32_t>(node->integer);
    }
    Error(node->range, fmt::format("'{}' must be an integer from 0 to {}", key, most));
    return std::nullopt;
  }

  ir::TypeId Type(const DocumentNode& object) {
    const DocumentNode* node = Find(object, "type", DocumentKind::kString, true);
    if (node == nullptr) return ir::TypeId();
    const ir::TypeId type = types_.Find(node->text);
    if (type.valid() && (ir::IsVector(type) || ir::IsMatrix(type))) return type;
    Error(node->range, fmt::format("'{}' is no type of a value", Printable(node->text)));
    return ir::TypeId();
  }

  bool Number(const DocumentNode& node, double& number) {
    if (node.kind == DocumentKind::kNumber) number = node.number;
    if (node.kind == DocumentKind::kBool) number = node.boolean ? 1 : 0;
    return node.kind == DocumentKind::kNumber || node.kind == DocumentKind::kBool;
  }

  template <class Function>
  void Each(const DocumentNode& root, std::string_view key, Function function) {
    const DocumentNode* array = Find(root, key, DocumentKind::kArray, false);
    if (array == nullptr) return;
    for (const DocumentNode& entry : document_.children(*array)) {
      if (entry.kind == DocumentKind::kObject) {
        function(entry);
      } else {
        Error(entry.range, fmt::format("'{}' of a manifest holds objects", key));
      }
    }
  }

  void ReadInput(const DocumentNode& node);
  void ReadOutput(const DocumentNode& node);
  void ReadParameter(const DocumentNode& node);
  void ReadTexture(const DocumentNode& node);
  void ReadWraps(const DocumentNode& node, textures::TextureOptions& options);
  void CheckFiles(const DocumentNode& files, ManifestTexture& texture);
  void ReadMasks(const DocumentNode& node, ManifestTexture& texture);
  void ReadKey(const DocumentNode& node, ManifestTexture& texture);
  void ReadMap(const DocumentNode& node, ManifestTexture& texture);

  const Document& document_;
  Diagnostics& diagnostics_;
  ir::Types types_;
  Manifest manifest_;
};

void Reader::ReadInput(const DocumentNode& node) {
  ManifestInput input;
  input.name = Text(node, "name");
  input.variable = Text(node, "variable", false);
  if (!input.variable.empty() && !IsIdentifier(input.variable)) {
    Error(node.range, "the 'variable' of an input is an identifier");
  }
  input.type = Type(node);
  input.location = Integer(node, "location", kMaxLocation);
  for (const BuiltinInput& known : kBuiltinInputs) {
    if (input.name != known.name || known.kind == BuiltinKind::kZero) continue;
    if (input.type == types_.Find(known.type)) {
      manifest_.inputs.push_back(std::move(input));
    } else if (input.type.valid()) {
      Error(node.range, fmt::format("input '{}' is a {}", known.name, known.type));
    }
    return;
  }
  Error(node.range,
        fmt::format("there is no input '{}' to give to the shader", Printable(input.name)));
}

void Reader::ReadOutput(const DocumentNode& node) {
  ManifestOutput output;
  output.name = Text(node, "name");
  output.variable = Text(node, "variable", !manifest_.is_function);
  output.type = Type(node);
  if (output.type.valid() && (!ir::IsVector(output.type) || !ir::IsFloat(output.type))) {
    Error(node.range, "an output is a float, a vec2, a vec3 or a vec4");
  }
  manifest_.outputs.push_back(std::move(output));
}

void Reader::ReadParameter(const DocumentNode& node) {
  ManifestParameter parameter;
  parameter.place = node.range;
  parameter.name = Text(node, "name");
  parameter.variable = Text(node, "variable", false);
  parameter.type = Type(node);
  parameter.status = Text(node, "status");
  parameter.is_uniform = parameter.status == "uniform";
  const DocumentNode* value = document_.Find(node, "value");
  if (value != nullptr && parameter.type.valid()) {
    double number = 0;
    if (Number(*value, number)) {
      parameter.value.push_back(number);
    } else if (value->kind == DocumentKind::kArray) {
      for (const DocumentNode& element : document_.children(*value)) {
        if (Number(element, number)) parameter.value.push_back(number);
      }
    }
    const uint32_t words = types_.Words(parameter.type);
    if (parameter.value.size() != words) {
      Error(value->range,
            fmt::format("a value of type {} has {} numbers", types_.Text(parameter.type), words));
    }
  } else if (value == nullptr && parameter.is_uniform) {
    Error(node.range, "a uniform has a value");
  }
  if (const DocumentNode* range = Find(node, "range", DocumentKind::kArray, false)) {
    std::vector<double> ends;
    for (const DocumentNode& end : document_.children(*range)) {
      double number = 0;
      if (Number(end, number)) ends.push_back(number);
    }
    if (ends.size() == 2 && range->child_count == 2) {
      parameter.range = {ends[0], ends[1]};
    } else {
      Error(range->range, "a range has two numbers");
    }
  }
  manifest_.parameters.push_back(std::move(parameter));
}

void Reader::ReadWraps(const DocumentNode& node, textures::TextureOptions& options) {
  static constexpr std::string_view kWraps[] = {"repeat", "clamp", "mirror"};
  const DocumentNode* wraps = Find(node, "wrap", DocumentKind::kArray, false);
  if (wraps == nullptr) return;
  ir::Wrap* const targets[] = {&options.wrap_u, &options.wrap_v, &options.wrap_w};
  const uint32_t count = options.is_3d ? 3 : 2;
  uint32_t index = 0;
  for (const DocumentNode& wrap : document_.children(*wraps)) {
    if (index < count && wrap.kind == DocumentKind::kString) {
      *targets[index++] = static_cast<ir::Wrap>(WordIndex(wrap, "wrap", kWraps));
      continue;
    }
    index = count + 1;
    break;
  }
  if (index == count) return;
  Error(wraps->range, options.is_3d ? "'wrap' holds three names, of the directions u, v and w"
                                    : "'wrap' holds two names, of the directions u and v");
}

void Reader::ReadMasks(const DocumentNode& node, ManifestTexture& texture) {
  static constexpr std::string_view kChannels[] = {"red", "green", "blue", "alpha"};
  Each(node, "masks", [&](const DocumentNode& entry) {
    textures::MaskSource& mask = texture.masks.emplace_back();
    mask.range = entry.range;
    mask.file = Text(entry, "file");
    mask.channel = static_cast<textures::MaskChannel>(Word(entry, "channel", false, kChannels));
    const DocumentNode* invert = Find(entry, "invert", DocumentKind::kBool, false);
    mask.invert = invert != nullptr && invert->boolean;
  });
  if (texture.masks.size() > 1 && texture.masks.size() != texture.files.size()) {
    Error(node.range, "a texture has one mask, or one for each of its files");
  }
}

void Reader::ReadKey(const DocumentNode& node, ManifestTexture& texture) {
  const DocumentNode* object = Find(node, "key", DocumentKind::kObject, false);
  if (object == nullptr) return;
  textures::ColorKey& key = texture.key.emplace();
  if (const DocumentNode* color = Find(*object, "color", DocumentKind::kArray, true)) {
    size_t count = 0;
    for (const DocumentNode& child : document_.children(*color)) {
      double number = -1;
      if (!Number(child, number) || number < 0 || number > 1) break;
      if (count < key.color.size()) key.color[count] = static_cast<float>(number);
      ++count;
    }
    if (count != key.color.size() || color->child_count != count) {
      Error(color->range, "the 'color' of a key is three numbers from 0 to 1");
    }
  }
  if (const DocumentNode* tolerance = Find(*object, "tolerance", DocumentKind::kNumber, true)) {
    if (!(tolerance->number >= 0 && tolerance->number < 1)) {
      Error(tolerance->range, "the 'tolerance' of a key is a number from 0 up to, but not, 1");
    } else {
      key.tolerance = static_cast<float>(tolerance->number);
    }
  }
  key.edge = Integer(*object, "edge", textures::kMaxKeyEdge).value_or(key.edge);
}

void Reader::ReadMap(const DocumentNode& node, ManifestTexture& texture) {
  static constexpr std::string_view kContents[] = {"patterns", "lists", "tiles", "numbers",
                                                   "sprites"};
  const DocumentNode* object = Find(node, "map", DocumentKind::kObject, false);
  if (object == nullptr) return;
  ManifestMap& map = texture.map.emplace();
  map.holds = static_cast<MapContents>(Word(*object, "holds", true, kContents));
  map.count = Integer(*object, "count", textures::kMaxMapNumber);
}

// What the shader does not sample may be made of files, or of none, that are not its texels yet.
void Reader::CheckFiles(const DocumentNode& files, ManifestTexture& texture) {
  texture.has_levels = texture.files.size() == 1 && texture.files[0].ends_with(".ktx2");
  if (!texture.is_used) return;
  const bool many = texture.options.is_array || texture.options.is_3d;
  if (texture.files.empty() || (texture.files.size() > 1 && !many)) {
    Error(files.range, "a texture has one file, an array texture one or more");
  }
}

void Reader::ReadTexture(const DocumentNode& node) {
  static constexpr std::string_view kTypes[] = {"sampler2D", "sampler2DArray", "sampler3D"};
  static constexpr std::string_view kStatus[] = {"used", "unused", "folded"};
  static constexpr std::string_view kSpaces[] = {"srgb", "linear"};
  static constexpr std::string_view kFilters[] = {"linear", "nearest"};
  static constexpr std::string_view kAlphas[] = {"opacity", "data"};
  ManifestTexture texture;
  texture.place = node.range;
  texture.name = Text(node, "name");
  const uint32_t type = Word(node, "type", true, kTypes);
  texture.options.is_array = type == 1;
  texture.options.is_3d = type == 2;
  const uint32_t status = Word(node, "status", false, kStatus);
  texture.is_used = status == 0;
  texture.is_folded = status == 2;
  texture.variable = Text(node, "variable", texture.is_used);
  texture.options.srgb = Word(node, "color_space", true, kSpaces) == 0;
  texture.options.alpha_is_opacity = document_.Find(node, "alpha") == nullptr
                                         ? texture.options.srgb
                                         : Word(node, "alpha", true, kAlphas) == 0;
  texture.options.filter =
      Word(node, "filter", false, kFilters) == 0 ? ir::Filter::kLinear : ir::Filter::kNearest;
  ReadWraps(node, texture.options);
  const DocumentNode* mipmaps = Find(node, "mipmaps", DocumentKind::kBool, false);
  texture.options.mipmaps = mipmaps == nullptr || mipmaps->boolean;
  texture.options.max_level = Integer(node, "max_level", kMaxMipLevel);
  if (const DocumentNode* files = Find(node, "files", DocumentKind::kArray, true)) {
    for (const DocumentNode& file : document_.children(*files)) {
      if (file.kind == DocumentKind::kString) {
        texture.files.emplace_back(file.text);
      } else {
        Error(file.range, "'files' holds names of files");
      }
    }
    CheckFiles(*files, texture);
  }
  ReadMasks(node, texture);
  ReadKey(node, texture);
  ReadMap(node, texture);
  manifest_.textures.push_back(std::move(texture));
}

Manifest Reader::Read() {
  static constexpr std::string_view kDialects[] = {"glsl330", "glsl450", "spirv"};
  static constexpr std::string_view kEmits[] = {"shader", "function"};
  const DocumentNode& root = document_.nodes[0];
  const DocumentNode* version = document_.Find(root, "texgraph_manifest");
  if (version == nullptr || !version->is_integer || version->integer != 1) {
    Error(version ? version->range : root.range, "only manifests of version 1 can be read");
    return {};
  }
  manifest_.name = Text(root, "name", false);
  manifest_.shader = Text(root, "shader", false);
  manifest_.dialect = static_cast<ShaderDialect>(Word(root, "dialect", true, kDialects));
  manifest_.is_function = Word(root, "emit", false, kEmits) == 1;
  manifest_.entry_point = Text(root, "entry_point", manifest_.is_function);
  if (manifest_.is_function && !IsIdentifier(manifest_.entry_point)) {
    Error(root.range, "the 'entry_point' of a function is an identifier");
  }
  Each(root, "inputs", [this](const DocumentNode& node) { ReadInput(node); });
  Each(root, "outputs", [this](const DocumentNode& node) { ReadOutput(node); });
  Each(root, "parameters", [this](const DocumentNode& node) { ReadParameter(node); });
  Each(root, "textures", [this](const DocumentNode& node) { ReadTexture(node); });
  if (manifest_.outputs.empty()) Error(root.range, "the manifest has no outputs");
  return std::move(manifest_);
}

}  // namespace

bool IsManifest(const Document& document) {
  const DocumentNode& root = document.nodes[0];
  return root.kind == DocumentKind::kObject && document.Find(root, "texgraph_manifest") != nullptr;
}

std::optional<Manifest> ReadManifest(const Document& document, Diagnostics& diagnostics) {
  if (document.nodes[0].kind != DocumentKind::kObject) {
    diagnostics.Error(DiagnosticKind::kManifest, document.nodes[0].range,
                      "a manifest is an object");
    return std::nullopt;
  }
  const size_t before = diagnostics.error_count();
  Manifest manifest = Reader(document, diagnostics).Read();
  if (diagnostics.error_count() != before) return std::nullopt;
  return manifest;
}

}  // namespace texgraph::runtime
