// SPDX-License-Identifier: Apache-2.0
// texgraph render: from a graph or a manifest to pictures: all of them are written or none.
#pragma once

#include "cli/texgraph/render_options.h"
#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"

namespace texgraph::cli {

// What is wrong is in `diagnostics`; then no file has changed. `message` is a line for the
// user about how it was made.
void RunRender(const RenderOptions& options, Sources& sources, Diagnostics& diagnostics,
               std::string& message);

}  // namespace texgraph::cli
