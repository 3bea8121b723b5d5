// SPDX-License-Identifier: Apache-2.0
// Literals and references as they stand at ports, parameters and in settings.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/graph/document.h"
#include "compiler/graph/graph.h"

namespace texgraph::graph {

// "text", "a number", ... for messages.
std::string_view KindText(DocumentKind kind);

// A number, bool, text, array of numbers, or array of such arrays of equal length; else kBadValue.
std::optional<Argument> ReadArgument(const Document& document, const DocumentNode& node,
                                     Diagnostics& diagnostics);

}  // namespace texgraph::graph
