// SPDX-License-Identifier: Apache-2.0
// What stands at a port becomes its source, converted where that is allowed.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/graph/conversion.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

using Kind = Symbol::Kind;

std::string_view BindingText(Binding binding) {
  return binding == Binding::kUniform ? "a uniform" : "a specialization constant";
}

ValueLimits LimitsOf(const blocks::Port& port) { return {port.minimum, port.maximum}; }

// "'mix', 'add' or 'screen'"
std::string WordList(const blocks::Port& port) {
  return Listed(port.words, " or ",
                [](const blocks::EnumWord& word) { return "'" + word.word + "'"; });
}

}  // namespace

std::optional<BoundPort> SubgraphChecker::Bind(const Target& target, const Argument& argument,
                                               const Resolved& resolved) {
  if (!target.port.type.valid()) {  // the reason was reported
    if (resolved.kind == Resolved::Kind::kWrong) ReportReference(argument, resolved);
    return std::nullopt;
  }
  switch (target.port.kind) {
    case blocks::PortKind::kTemplate:
      return BindTemplate(target, argument, resolved);
    case blocks::PortKind::kTexture:
      return BindTexture(target, argument, resolved);
    case blocks::PortKind::kField:
      return BindField(target, argument, resolved);
    case blocks::PortKind::kValue:
      break;
  }
  return BindValue(target, argument, resolved);
}

std::optional<BoundPort> SubgraphChecker::BindLiteral(const Target& target,
                                                      const Argument& argument) {
  ir::TypeId type = target.port.type;
  auto value = MakeLiteral(argument, type, target.place, check_.module, check_.diagnostics);
  if (!value ||
      !CheckLength(*value, target.port.min_length, target.port.max_length, argument.range,
                   target.place, check_.module, check_.diagnostics) ||
      !CheckLimits(*value, LimitsOf(target.port), argument.range, target.place, check_.module,
                   check_.diagnostics)) {
    return std::nullopt;
  }
  return BoundPort{ConstantValue{*value}, type, type, {}, argument.range};
}

std::optional<BoundPort> SubgraphChecker::BindConstantParameter(const Target& target,
                                                                const Argument& argument,
                                                                uint32_t parameter) {
  ir::TypeId type = target.port.type;
  const CheckedParameter& checked = check_.result.parameters[parameter];
  if (!checked.type.valid() || !checked.value.valid()) return std::nullopt;
  if (!ConversionCost(checked.type, type)) {
    ReportType(target, argument, checked.type);
    return std::nullopt;
  }
  ir::ConstId value = ConvertConstant(checked.value, type, check_.module);
  if (!CheckLimits(value, LimitsOf(target.port), argument.range, target.place, check_.module,
                   check_.diagnostics)) {
    return std::nullopt;
  }
  return BoundPort{ConstantValue{value}, type, type, {}, argument.range};
}

std::optional<BoundPort> SubgraphChecker::BindValue(const Target& target, const Argument& argument,
                                                    const Resolved& resolved) {
  if (resolved.kind == Resolved::Kind::kLiteral) return BindLiteral(target, argument);
  if (resolved.kind == Resolved::Kind::kWrong) {
    ReportReference(argument, resolved);
    return std::nullopt;
  }
  if (IsConstantParameter(resolved)) {
    return BindConstantParameter(target, argument, resolved.symbol.index);
  }
  uint32_t index = resolved.symbol.index;
  Source source;
  switch (resolved.symbol.kind) {
    case Kind::kTexture:
    case Kind::kFunction:
      ReportNoValue(target, argument, resolved, check_.module.types.Text(target.port.type));
      return std::nullopt;
    case Kind::kBuiltin:
      source = BuiltinRef{index};
      break;
    case Kind::kParameter:
      source = ParameterRef{index};
      break;
    case Kind::kFunctionInput:
      source = FunctionInputRef{index};
      break;
    case Kind::kNode:
      source = NodeOutput{position_[index], resolved.output};
      break;
  }
  if (!resolved.type.valid()) return std::nullopt;  // the reason was reported
  if (!ConversionCost(resolved.type, target.port.type)) {
    ReportType(target, argument, resolved.type);
    return std::nullopt;
  }
  return BoundPort{source, resolved.type, target.port.type, {}, argument.range};
}

std::optional<BoundPort> SubgraphChecker::BindTemplate(const Target& target,
                                                       const Argument& argument,
                                                       const Resolved& resolved) {
  const blocks::Port& port = target.port;
  if (argument.kind == Argument::Kind::kString) {
    for (const blocks::EnumWord& word : port.words) {
      if (word.word != argument.text) continue;
      uint32_t bits = static_cast<uint32_t>(word.value);
      ir::ConstId value = check_.module.Intern(port.type, {&bits, 1});
      return BoundPort{ConstantValue{value}, port.type, port.type, {}, argument.range};
    }
  }
  std::optional<BoundPort> bound;
  if (resolved.kind == Resolved::Kind::kLiteral) {
    bound = BindLiteral(target, argument);
  } else if (IsConstantParameter(resolved)) {
    bound = BindConstantParameter(target, argument, resolved.symbol.index);
  } else if (resolved.kind == Resolved::Kind::kWrong) {
    if (port.words.empty()) {
      ReportReference(argument, resolved);
    } else {
      ReportWord(target, argument);
    }
  } else {
    Kind kind = resolved.symbol.kind;
    std::string what = fmt::format("'{}' is a {}", Printable(argument.text, 64), KindText(kind));
    const Parameter* parameter = nullptr;
    if (kind == Kind::kParameter) {
      parameter = &check_.graph.parameters[resolved.symbol.index];
      what = fmt::format("parameter '{}' is {}", parameter->name, BindingText(parameter->binding));
    }
    Diagnostic& error = check_.diagnostics.Error(
        DiagnosticKind::kNotConstant, argument.range,
        fmt::format("{} must be known when the shader is made; {}", target.place.Text(), what));
    if (parameter) error.AddNote(parameter->range, "the parameter is declared here");
    target.place.AddNote(error);
  }
  if (!bound) return std::nullopt;
  if (!CheckWords(target, argument.range, std::get<ConstantValue>(bound->source).value)) {
    return std::nullopt;
  }
  return bound;
}

// A port with words takes their values only.
bool SubgraphChecker::CheckWords(const Target& target, SourceRange range, ir::ConstId value) {
  const blocks::Port& port = target.port;
  if (port.words.empty()) return true;
  auto number = static_cast<int32_t>(check_.module.Words(value)[0]);
  bool known = std::ranges::any_of(
      port.words, [&](const blocks::EnumWord& word) { return word.value == number; });
  if (known) return true;
  target.place.AddNote(check_.diagnostics.Error(
      DiagnosticKind::kValueRange, range,
      fmt::format("{} takes {}, got {}", target.place.Text(), WordList(port), number)));
  return false;
}

void SubgraphChecker::ReportWord(const Target& target, const Argument& argument) {
  std::vector<std::string_view> words;
  for (const blocks::EnumWord& word : target.port.words) words.push_back(word.word);
  target.place.AddNote(check_.diagnostics.Error(
      DiagnosticKind::kUnknownReference, argument.range,
      fmt::format("{} takes {}, got '{}'{}", target.place.Text(), WordList(target.port),
                  Printable(argument.text, 64), DidYouMean(argument.text, words))));
}

std::string_view WhatItHas(const Texture& texture) {
  if (texture.pack == TexturePack::kAtlas) return "\"pack\": \"atlas\"";
  if (texture.pack == TexturePack::kVolume) return "\"pack\": \"volume\"";
  switch (texture.kind) {
    case TextureKind::kFile:
      return "one \"file\"";
    case TextureKind::kLayers:
      return "\"layers\"";
    case TextureKind::kSheet:
      return "a \"sheet\"";
    case TextureKind::kMap:
      return "a \"map\"";
    case TextureKind::kLists:
      return "\"lists\"";
    case TextureKind::kSprites:
      return "\"sprites\"";
    case TextureKind::kMeans:
      return "\"means\"";
    case TextureKind::kTiles:
      return "\"pack\": \"array\"";
    case TextureKind::kTiling:
      return "a \"tiling\"";
    case TextureKind::kCorners:
      return "\"corners\"";
    case TextureKind::kPermutation:
      return "a \"permutation\"";
    case TextureKind::kNoise:
      return "\"noise\"";
    case TextureKind::kGaussian:
      return "a \"gaussian\" picture";
    case TextureKind::kTable:
      return "a \"table\"";
    case TextureKind::kColorMap:
      return "a \"color_map\"";
    case TextureKind::kCubes:
      return "\"cubes\"";
  }
  return {};
}

std::optional<BoundPort> SubgraphChecker::BindTexture(const Target& target,
                                                      const Argument& argument,
                                                      const Resolved& resolved) {
  if (resolved.kind == Resolved::Kind::kWrong) {
    ReportReference(argument, resolved);
    return std::nullopt;
  }
  bool texture = resolved.kind == Resolved::Kind::kSymbol && resolved.symbol.kind == Kind::kTexture;
  if (!texture) {
    ReportNoValue(target, argument, resolved, "a texture");
    return std::nullopt;
  }
  const Texture& found = check_.graph.textures[resolved.symbol.index];
  ir::TypeId type = SamplerType(found);
  if (type == target.port.type) {
    return BoundPort{TextureRef{resolved.symbol.index}, type, type, {}, argument.range};
  }
  const bool is_tiles = found.kind == TextureKind::kTiles;
  std::string_view wants = "a texture with \"pack\": \"volume\" or \"cubes\"";
  if (target.port.type == ir::kSampler2D) {
    wants = is_tiles ? "tiles with \"pack\": \"atlas\"" : "a texture with one \"file\"";
  } else if (target.port.type == ir::kSampler2DArray) {
    wants = is_tiles ? "tiles with \"pack\": \"array\"" : "a texture with \"layers\"";
  }
  target.place.AddNote(
      check_.diagnostics.Error(DiagnosticKind::kPortType, argument.range,
                               fmt::format("{} takes {}, but '{}' has {}", target.place.Text(),
                                           wants, Printable(argument.text, 64), WhatItHas(found))));
  return std::nullopt;
}

// The port's own default; an error if it has none.
std::optional<BoundPort> SubgraphChecker::BindDefault(const Target& target, SourceRange range) {
  const blocks::Port& port = target.port;
  if (!port.type.valid()) return std::nullopt;  // the reason was reported
  bool field = port.kind == blocks::PortKind::kField;
  if (!port.computed_by.empty()) {
    return BoundPort{ComputedValue{}, port.type, port.type, {}, range};
  }
  if (!port.default_block.empty()) return BindFieldOfBlock(target, range);
  if (port.asked_at) {
    return BoundPort{AskedValue{port.default_value}, port.type, port.type, {}, range};
  }
  if (port.default_value.valid()) {
    if (!field) {
      return BoundPort{ConstantValue{port.default_value}, port.type, port.type, {}, range};
    }
    ir::TypeId type = check_.module.constant(port.default_value).type;
    return BoundPort{FieldOfConstant{port.default_value}, type, port.type, {}, range};
  }
  if (!port.default_input.empty()) {
    const auto* input = std::ranges::find(kBuiltinInputs, port.default_input, &BuiltinInput::name);
    auto index = static_cast<uint32_t>(input - std::begin(kBuiltinInputs));
    ir::TypeId type = check_.module.types.Find(input->type);
    if (field) return BoundPort{FieldOfBuiltin{index}, type, port.type, {}, range};
    // Inside a function its own input of that name is meant.
    std::optional<Symbol> own = scope_.Find(port.default_input);
    if (own && own->kind == Kind::kFunctionInput &&
        ConversionCost(signature_->inputs[own->index].type, port.type)) {
      type = signature_->inputs[own->index].type;
      return BoundPort{FunctionInputRef{own->index}, type, port.type, {}, range};
    }
    return BoundPort{BuiltinRef{index}, type, port.type, {}, range};
  }
  target.place.AddNote(check_.diagnostics.Error(
      DiagnosticKind::kMissingInput, range,
      fmt::format("{} is not connected and has no default", target.place.Text())));
  return std::nullopt;
}

void SubgraphChecker::ReportType(const Target& target, const Argument& argument, ir::TypeId got) {
  const ir::Types& types = check_.module.types;
  const ir::TypeId takes = types.ValueOf(target.port.type);
  target.place.AddNote(check_.diagnostics.Error(
      DiagnosticKind::kPortType, argument.range,
      fmt::format("{} takes {}, got {}{}", target.place.Text(), types.Text(target.port.type),
                  types.Text(got), ConvertingBlocks(got, takes, types, check_.library))));
}

// Something that is no value stands at a value port, or no texture at a texture port.
void SubgraphChecker::ReportNoValue(const Target& target, const Argument& argument,
                                    const Resolved& resolved, std::string_view takes) {
  std::string got = ArgumentText(argument);
  std::string hint;
  if (resolved.kind == Resolved::Kind::kSymbol) {
    Kind kind = resolved.symbol.kind;
    got = fmt::format("the {} '{}'", KindText(kind), Printable(argument.text, 64));
    if (kind == Kind::kTexture && check_.library.Exists("image")) {
      hint = "; a node with the block 'image' reads it";
    } else if (kind == Kind::kFunction && target.port.kind != blocks::PortKind::kTexture) {
      hint = fmt::format("; make a node with \"block\": \"{}\"",
                         check_.graph.functions[resolved.symbol.index].name);
    }
  }
  target.place.AddNote(check_.diagnostics.Error(
      DiagnosticKind::kPortType, argument.range,
      fmt::format("{} takes {}, got {}{}", target.place.Text(), takes, got, hint)));
}

}  // namespace texgraph::graph
