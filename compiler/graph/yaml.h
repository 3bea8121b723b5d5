// SPDX-License-Identifier: Apache-2.0
// Reads the part of YAML 1.2 that says what JSON can say: mappings with text keys, sequences,
// scalars, anchors and aliases. Tags, merge keys and several documents are refused.
#pragma once

#include <cstddef>
#include <string_view>

#include "compiler/graph/document.h"

namespace texgraph::graph {

// libfyaml reads about ten MB a second.
inline constexpr size_t kMaxYamlBytes = 16u << 20;

// Fills `document` from `text`, which is the whole source and valid UTF-8. False on an error, which
// is reported. Duplicate keys are left to the caller.
bool ReadYaml(SourceId source, std::string_view text, Document& document, Diagnostics& diagnostics);

}  // namespace texgraph::graph
