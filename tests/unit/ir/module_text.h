// SPDX-License-Identifier: Apache-2.0
// Modules from text, for tests.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/print.h"

namespace texgraph::ir {

// The module that `text` is, or an empty one and a failure.
inline Module ModuleFrom(std::string text) {
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add("test.ir", std::move(text));
  std::optional<Module> module = Parse(source, sources, diagnostics);
  EXPECT_TRUE(module.has_value()) << FormatDiagnostics(diagnostics, sources, false);
  return module ? std::move(*module) : Module();
}

// "line:column: message" of the error that reading `text` gives; "" if it gives none.
inline std::string ErrorOf(std::string text) {
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add("test.ir", std::move(text));
  if (Parse(source, sources, diagnostics)) return "";
  if (diagnostics.all().size() != 1) return "not one error";
  const Diagnostic& first = diagnostics.all().front();
  LineColumn place = sources.Locate(source, first.range.begin);
  return std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + first.message;
}

}  // namespace texgraph::ir
