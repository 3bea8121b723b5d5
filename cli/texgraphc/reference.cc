// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraphc/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <vector>

#include "compiler/base/text.h"
#include "compiler/blocks/block.h"
#include "compiler/ir/module.h"

namespace texgraph::cli {
namespace {

constexpr size_t kTextWidth = 100;

std::string ScalarText(ir::Scalar scalar, uint32_t word) {
  switch (scalar) {
    case ir::Scalar::kBool:
      return word != 0 ? "true" : "false";
    case ir::Scalar::kInt:
      return fmt::format("{}", std::bit_cast<int32_t>(word));
    case ir::Scalar::kUint:
      return fmt::format("{}u", word);
    case ir::Scalar::kFloat:
      return FloatText(std::bit_cast<float>(word));
  }
  return {};
}

// As GLSL writes it: 3, 0.5, vec3(1.0), vec2(0.0, 1.0). Nothing for structs.
std::string ConstantText(const ir::Module& module, ir::TypeId type,
                         std::span<const uint32_t> words) {
  if (module.types.Kind(type) == ir::TypeKind::kArray) {
    ir::TypeId element = module.types.ElementType(type, 0);
    uint32_t width = module.types.Words(element);
    std::string out;
    for (size_t i = 0; i < words.size(); i += width) {
      out += (i == 0 ? "" : ", ") + ConstantText(module, element, words.subspan(i, width));
    }
    return module.types.Text(element) + "[](" + out + ")";
  }
  if (ir::IsVector(type) && ir::IsScalar(type)) return ScalarText(ir::ScalarOf(type), words[0]);
  if (!ir::IsVector(type) && !ir::IsMatrix(type)) return {};
  ir::Scalar scalar = ir::IsMatrix(type) ? ir::Scalar::kFloat : ir::ScalarOf(type);
  bool equal = ir::IsVector(type) &&
               std::all_of(words.begin(), words.end(), [&](uint32_t w) { return w == words[0]; });
  std::string out = module.types.Text(type) + "(";
  for (size_t i = 0; i < (equal ? 1 : words.size()); ++i) {
    out += (i == 0 ? "" : ", ") + ScalarText(scalar, words[i]);
  }
  return out + ")";
}

// `text` in lines of at most kTextWidth columns, each after `indent` spaces; its own line ends are
// kept.
void AppendWrapped(std::string& out, std::string_view text, size_t indent) {
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    do {
      size_t width = kTextWidth - indent, cut = line.size();
      if (line.size() > width) {
        cut = line.rfind(' ', width);
        if (cut == std::string_view::npos || cut == 0) cut = std::min(line.find(' '), line.size());
      }
      fmt::format_to(std::back_inserter(out), "{:{}}{}\n", "", line.empty() ? 0 : indent,
                     line.substr(0, cut));
      line.remove_prefix(std::min(cut + 1, line.size()));
    } while (!line.empty());
  }
}

// Overloads that one genType function stands for, or one that is its own.
using Variants = std::vector<const blocks::Overload*>;

std::vector<Variants> GroupedOverloads(const blocks::Block& block) {
  std::vector<Variants> groups;
  for (const blocks::Overload& overload : block.overloads) {
    bool same = !groups.empty() && overload.gen_type.valid() &&
                groups.back()[0]->function == overload.function;
    if (!same) groups.emplace_back();
    groups.back().push_back(&overload);
  }
  return groups;
}

class Printer {
 public:
  Printer(const ir::Module& module, const blocks::Block& block) : module_(module), block_(block) {}

  std::string Print() {
    fmt::format_to(std::back_inserter(out_), "{}  ({})\n\n", block_.name, block_.path);
    AppendWrapped(out_, block_.summary, 2);
    AppendWrapped(out_, block_.details, 2);
    if (!block_.source.empty()) AppendWrapped(out_, "Source: " + block_.source, 2);
    std::vector<Variants> groups = GroupedOverloads(block_);
    for (size_t i = 0; i < groups.size(); ++i) {
      if (groups.size() > 1) fmt::format_to(std::back_inserter(out_), "\nOverload {}", i + 1);
      if (groups[i].size() > 1) out_ += "\ngenType is float, vec2, vec3 or vec4";
      if (groups.size() > 1 || groups[i].size() > 1) out_ += '\n';
      AppendPorts("Inputs", groups[i], &blocks::Overload::inputs);
      AppendPorts("Outputs", groups[i], &blocks::Overload::outputs);
    }
    return std::move(out_);
  }

 private:
  void AppendPorts(std::string_view title, const Variants& variants,
                   std::vector<blocks::Port> blocks::Overload::*ports) {
    const std::vector<blocks::Port>& first = variants[0]->*ports;
    if (first.empty()) return;
    size_t names = 0, types = 0;
    std::vector<std::string> type_texts;
    for (size_t i = 0; i < first.size(); ++i) {
      type_texts.push_back(TypeText(variants, ports, i));
      names = std::max(names, first[i].name.size());
      types = std::max(types, type_texts[i].size());
    }
    fmt::format_to(std::back_inserter(out_), "\n{}\n", title);
    for (size_t i = 0; i < first.size(); ++i) {
      std::string facts = FactsOf(first, first[i]);
      std::string line =
          fmt::format("  {:{}}  {:{}}  {}", first[i].name, names, type_texts[i], types, facts);
      line.erase(line.find_last_not_of(' ') + 1);
      out_ += line + "\n";
      AppendWrapped(out_, first[i].help, names + 4);
    }
  }

  std::string TypeText(const Variants& variants, std::vector<blocks::Port> blocks::Overload::*ports,
                       size_t i) const {
    const blocks::Port& port = (variants[0]->*ports)[i];
    bool varies =
        variants.size() > 1 && (variants[0]->*ports)[i].type != (variants[1]->*ports)[i].type;
    if (port.kind == blocks::PortKind::kField) return FieldText(variants, ports, i, varies);
    std::string text = varies ? "genType" : module_.types.Text(port.type);
    return port.kind == blocks::PortKind::kTemplate ? "const " + text : text;
  }

  // "vec4 (vec2 uv)": what the port's function returns and takes. If the field varies with genType,
  // its result does, or else its parameters.
  std::string FieldText(const Variants& variants,
                        std::vector<blocks::Port> blocks::Overload::*ports, size_t i,
                        bool varies) const {
    const blocks::Port& port = (variants[0]->*ports)[i];
    const std::vector<ir::TypeId>& elements = module_.types[port.type].elements;
    auto element = [&](size_t e) -> std::string {
      if (varies && elements[e] != module_.types[(variants[1]->*ports)[i].type].elements[e])
        return "genType";
      return module_.types.Text(elements[e]);
    };
    std::string out = element(0) + " (";
    for (size_t e = 1; e < elements.size(); ++e) {
      if (e > 1) out += ", ";
      out += element(e);
      if (e - 1 < port.field_parameters.size()) out += " " + port.field_parameters[e - 1];
    }
    return out + ")";
  }

  std::string FactsOf(const std::vector<blocks::Port>& ports, const blocks::Port& port) const {
    std::string out;
    auto add = [&](std::string fact) { out += (out.empty() ? "" : ", ") + std::move(fact); };
    if (std::string value = DefaultText(port); !value.empty()) add("default " + value);
    if (port.minimum && port.maximum) {
      add(fmt::format("range {} to {}", *port.minimum, *port.maximum));
    } else if (port.minimum) {
      add(fmt::format("at least {}", *port.minimum));
    } else if (port.maximum) {
      add(fmt::format("at most {}", *port.maximum));
    }
    if (port.max_length > 0) {
      add(port.min_length == port.max_length
              ? fmt::format("{} elements", port.min_length)
              : fmt::format("{} to {} elements", port.min_length, port.max_length));
    }
    if (!port.unit.empty()) add("in " + port.unit);
    if (port.ordered) add("the least first");
    if (port.not_below) add("not below " + ports[*port.not_below].name);
    if (port.multiple_of) add("multiples of the size of " + ports[*port.multiple_of].name);
    if (port.grid_of) add("if nothing is given, the grid of " + ports[*port.grid_of].name);
    if (port.transitions_of) add("for the corners of " + ports[*port.transitions_of].name);
    if (port.as_long_as) add("as many as " + ports[*port.as_long_as].name);
    if (port.below) add("counts " + ports[*port.below].name);
    if (port.asked_at) add("given by who asks at " + ports[*port.asked_at].name);
    std::string words;
    for (const blocks::EnumWord& word : port.words)
      words += (words.empty() ? "" : ", ") + word.word;
    if (!words.empty()) add("one of: " + words);
    return out;
  }

  std::string DefaultText(const blocks::Port& port) const {
    if (!port.default_input.empty()) return port.default_input;
    if (!port.default_block.empty()) return port.default_block;
    if (!port.default_value.valid()) return {};
    if (!port.words.empty()) {
      int32_t value = std::bit_cast<int32_t>(module_.Words(port.default_value)[0]);
      for (const blocks::EnumWord& word : port.words) {
        if (word.value == value) return word.word;
      }
    }
    return ConstantText(module_, module_.constant(port.default_value).type,
                        module_.Words(port.default_value));
  }

  const ir::Module& module_;
  const blocks::Block& block_;
  std::string out_;
};

}  // namespace

std::string ListBlocks(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  ir::Module module;
  blocks::Library library(module, sources, diagnostics, options.compile.block_folders);
  std::map<std::string_view, std::vector<const blocks::Block*>> families;
  size_t width = 0;
  for (std::string_view name : library.Names()) {
    const blocks::Block* block = library.Find(name);
    if (block == nullptr) continue;
    families[block->family].push_back(block);
    width = std::max(width, block->name.size());
  }
  std::string out;
  for (const auto& [family, members] : families) {
    fmt::format_to(std::back_inserter(out), "{}{}\n", out.empty() ? "" : "\n",
                   family.empty() ? "(no family)" : family);
    for (const blocks::Block* block : members) {
      std::string summary = block->summary;
      std::replace(summary.begin(), summary.end(), '\n', ' ');
      fmt::format_to(std::back_inserter(out), "  {:{}}  {}\n", block->name, width, summary);
    }
  }
  return out;
}

std::string PrintReference(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  ir::Module module;
  blocks::Library library(module, sources, diagnostics, options.compile.block_folders);
  const blocks::Block* block = library.Find(options.reference);
  if (block != nullptr && library.CheckBodies(*block)) return Printer(module, *block).Print();
  if (!diagnostics.HasErrors()) {
    diagnostics.Error(DiagnosticKind::kUnknownBlock, {},
                      fmt::format("there is no block '{}'{}", Printable(options.reference),
                                  DidYouMean(options.reference, library.Names())));
  }
  return {};
}

}  // namespace texgraph::cli
