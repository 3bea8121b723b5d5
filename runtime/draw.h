// SPDX-License-Identifier: Apache-2.0
// One request on an open context, in the child process. All that it finds out goes into the shared
// result at once.
#pragma once

#include "runtime/gl_context.h"
#include "runtime/shared_result.h"

namespace texgraph::runtime {

void DrawRequest(const GlContext& context, const RenderRequest& request, const RenderPlan& plan,
                 SharedResult& shared);

}  // namespace texgraph::runtime
