// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/graph/checked_graph.h"
#include "runtime/manifest.h"

namespace texgraph::runtime {
namespace {

using graph::Argument;

// The numbers of `argument` for a parameter of `type`, or nothing if they don't fit.
std::optional<std::vector<double>> Numbers(const Argument& argument, ir::TypeId type,
                                           const ir::Types& types) {
  const bool is_bool = ir::IsBool(type);
  if (argument.kind == Argument::Kind::kBool) {
    if (type != ir::kBool) return std::nullopt;
    return std::vector<double>{argument.boolean ? 1.0 : 0.0};
  }
  if (argument.kind == Argument::Kind::kString || is_bool) return std::nullopt;
  if (ir::IsInteger(type) && !argument.is_integer) return std::nullopt;
  const uint32_t words = types.Words(type);
  // A scalar fits a vector, as everywhere in graphs.
  if (argument.numbers.size() == 1 && !ir::IsMatrix(type)) {
    return std::vector<double>(words, argument.numbers[0]);
  }
  if (argument.numbers.size() != words) return std::nullopt;
  return std::vector<double>(argument.numbers.begin(), argument.numbers.end());
}

std::optional<std::array<double, 2>> TypeRange(ir::TypeId type) {
  if (!ir::IsInteger(type)) return std::nullopt;
  if (ir::ScalarOf(type) == ir::Scalar::kUint) return std::array<double, 2>{0, 4294967295.0};
  return std::array<double, 2>{-2147483648.0, 2147483647.0};
}

bool InRange(const std::vector<double>& numbers,
             const std::optional<std::array<double, 2>>& range) {
  if (!range) return true;
  for (double number : numbers) {
    if (!(number >= (*range)[0] && number <= (*range)[1])) return false;
  }
  return true;
}

ManifestParameter* FindParameter(Manifest& manifest, const graph::Setting& setting,
                                 Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  for (ManifestParameter& parameter : manifest.parameters) {
    if (parameter.name == setting.name) return &parameter;
    if (parameter.is_uniform) names.push_back(parameter.name);
  }
  diagnostics.Error(DiagnosticKind::kUnknownParameter, setting.range,
                    fmt::format("the shader has no parameter '{}'{}", Printable(setting.name),
                                DidYouMean(setting.name, names)));
  return nullptr;
}

// Reports what does not fit.
void Apply(const graph::Setting& setting, Manifest& manifest, Diagnostics& diagnostics) {
  ManifestParameter* parameter = FindParameter(manifest, setting, diagnostics);
  if (parameter == nullptr) return;
  if (!parameter->is_uniform) {
    // One that no output needs may be set without effect, as at compile time.
    if (parameter->status == "unused") return;
    diagnostics.Error(
        DiagnosticKind::kNotRenderable, setting.range,
        fmt::format("parameter '{}' is fixed in this shader ({}); render the graph instead",
                    Printable(setting.name), Printable(parameter->status)));
    return;
  }
  const ir::Types types;
  const auto numbers = Numbers(setting.value, parameter->type, types);
  if (!numbers) {
    diagnostics.Error(DiagnosticKind::kPortType, setting.range,
                      fmt::format("parameter '{}' takes {}", Printable(setting.name),
                                  types.Text(parameter->type)));
  } else if (!InRange(*numbers, TypeRange(parameter->type)) ||
             !InRange(*numbers, parameter->range)) {
    const auto range = parameter->range ? parameter->range : TypeRange(parameter->type);
    diagnostics.Error(DiagnosticKind::kValueRange, setting.range,
                      fmt::format("parameter '{}' is from {} to {}", Printable(setting.name),
                                  (*range)[0], (*range)[1]));
  } else {
    parameter->value = *numbers;
  }
}

}  // namespace

bool ApplySettings(const std::vector<std::string>& settings, Sources& sources, Manifest& manifest,
                   Diagnostics& diagnostics) {
  const size_t before = diagnostics.error_count();
  for (const graph::Setting& setting : graph::ReadSettings(settings, sources, diagnostics)) {
    Apply(setting, manifest, diagnostics);
  }
  return diagnostics.error_count() == before;
}

bool SetParameter(std::string_view name, std::span<const double> numbers, Manifest& manifest,
                  Diagnostics& diagnostics) {
  const size_t before = diagnostics.error_count();
  graph::Setting setting;
  setting.name = name;
  const auto parameter =
      std::find_if(manifest.parameters.begin(), manifest.parameters.end(),
                   [&](const ManifestParameter& entry) { return entry.name == name; });
  const bool is_bool =
      parameter != manifest.parameters.end() && parameter->type == ir::kBool && numbers.size() == 1;
  setting.value.kind = is_bool               ? Argument::Kind::kBool
                       : numbers.size() == 1 ? Argument::Kind::kNumber
                                             : Argument::Kind::kVector;
  setting.value.boolean = is_bool && numbers[0] != 0;
  setting.value.is_integer = true;
  for (double number : numbers) {
    if (!std::isfinite(number)) {
      diagnostics.Error(DiagnosticKind::kValueRange, {},
                        fmt::format("parameter '{}' takes finite numbers", Printable(name)));
      return false;
    }
    setting.value.is_integer = setting.value.is_integer && number == std::trunc(number);
    setting.value.numbers.push_back(number);
  }
  Apply(setting, manifest, diagnostics);
  return diagnostics.error_count() == before;
}

}  // namespace texgraph::runtime
