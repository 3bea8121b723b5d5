// SPDX-License-Identifier: Apache-2.0
// The IR as text, and back. Parse(Print(m)) prints the same text again. The text is for tests and for --dump-after.
//
//   struct Tile { cell: ivec2, local: vec2, seed: uint }
//   input uv: vec2
//   uniform tint: vec3 = vec3(1.0, 1.0, 1.0)
//   texture brick: sampler2D
//   function layer(%tile: Tile, const %blend: int, %image: field(vec2) -> vec4) -> (vec4, coverage: float) {
//     %local = extract.1 %tile : vec2
//     %0 = mul %local, vec2(2.0, 2.0) : vec2
//     %1 = sample @brick, %0 : vec4
//     %2 = swizzle.xyz %1 : vec3
//     %3 = if %c : (vec4, float) { ... yield %a, %b } else { ... yield %d, %e }
//     %4 = for %i = 0 to 4 step 1 (%sum = 0.0, %w = 1.0) : (float, float) { ... yield %s, %v }
//     %5 = call noise(%0, 3) : float
//     %6 = field noise_at(%t) : field(vec2) -> float
//     %7 = call_field %image(%0) : vec4
//     return %1, %6
//   }
//   main main
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/module.h"

namespace texgraph::ir {

std::string Print(const Module& module);
std::string Print(const Module& module, const Function& function);
// Errors are kSyntax. The result is verified.
std::optional<Module> Parse(SourceId source, const Sources& sources, Diagnostics& diagnostics);

}  // namespace texgraph::ir
