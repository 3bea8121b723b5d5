// SPDX-License-Identifier: Apache-2.0
// Reads one function of the IR's text form.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/ir/text_reader.h"

namespace texgraph::ir {

// What the text has named so far.
struct TextNames {
  std::unordered_map<std::string, GlobalId> globals;
  std::unordered_map<std::string, FunctionId> functions;
};

// Where a function and its values stand, for what Verify finds.
struct FunctionRanges {
  SourceRange header;
  std::vector<SourceRange> values;  // by ValueId
};

// The word "function" is taken already. False after an error.
bool ParseFunction(TextReader& reader, Module& module, const TextNames& names, Function& function,
                   FunctionRanges& ranges);

}  // namespace texgraph::ir
