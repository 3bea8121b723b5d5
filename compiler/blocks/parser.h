// SPDX-License-Identifier: Apache-2.0
// Reads the tokens of a block file. Every mistake is reported, with what stands outside the block
// language refused by name and with advice; after one, reading goes on with the next statement or
// declaration.
#pragma once

#include <memory>

#include "compiler/base/diagnostics.h"
#include "compiler/blocks/ast.h"

namespace texgraph::blocks {

// What was understood; complete if nothing was reported.
std::unique_ptr<FileAst> ParseFile(SourceId source, const Sources& sources,
                                   Diagnostics& diagnostics);

// `text` is a piece of `source` (a default in a comment) that must be one expression. Null if it is
// not; reported as kBlockDoc.
Expr* ParseDocExpression(FileAst& file, SourceRange range, const Sources& sources,
                         Diagnostics& diagnostics);

}  // namespace texgraph::blocks
