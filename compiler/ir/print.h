// SPDX-License-Identifier: Apache-2.0
// The IR as text, and back. Parse(Print(m)) prints the same text again. The text is for tests and for --dump-after.
//
//   // a comment
//   struct Tile { cell: ivec2, local: vec2, seed: uint }
//   origin #0 = "face" "layer" "layers/layer.glsl"              (node, block, source)
//   input uv: vec2
//   uniform tint: vec3 = vec3(1.0, 1.0, 1.0)
//   specialization rows: int = 12
//   texture brick: sampler2D
//   texture ids: sampler2D not smooth
//   texture where: sampler2D not smooth map 2 x 2 x 1 (0, 1, -1, 0)      (columns, rows, layers; numbers that never change)
//   function layer_2 as layer(%tile: Tile, const %blend: int, %image: field(vec2) -> vec4) -> (vec4, coverage: float) #0 {
//     %local = extract.1 %tile : vec2
//     %0 = mul %local, vec2(2.0, 2.0) : vec2
//     %1 = sample @brick, %0 : vec4 #1
//     %2 = swizzle.xyz %1 : vec3
//     %3 = if %c : (vec4, float) { ... yield %a, %b } else { ... yield %d, %e }
//     %4 = for %i = 0 to 4 step 1 (%sum = 0.0, %w = 1.0) : (float, float) { ... yield %s, %v }
//     %5 = call noise(%0, 3) : float
//     %6 = field noise_at(%t) : field(vec2) -> float
//     %7 = call_field %image(%0) : vec4
//     return %1, %6
//   }
//   main main
//
// A single result without a name needs no parentheses: "-> vec4". "as" gives another display name. "#1" is the origin of a value or
// a function; values without one have their function's. A literal says its type: 1.0, 1, 1u, true, vec2(1.0, 2.0),
// float[2](1.0, 2.0), Tile(...); floats also inf, -inf, nan and bits(0x7fc00001); vec3(1.0) is read as vec3(1.0, 1.0, 1.0). Names
// that are no identifiers stand in quotes. "%local.2" is a second value named "local", "%0" one without a name. Constants and
// globals are written where they are used; reading makes one instruction for each constant of a function, and for each global
// where it is first needed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/module.h"

namespace texgraph::ir {

// The module must be well formed (verify.h).
std::string Print(const Module& module);
std::string Print(const Module& module, const Function& function);
// Stops at the first error, which is kSyntax, and kNestingLimit for regions deeper than kMaxRegionDepth. Nothing folds and nothing
// merges: the functions hold what the text says. The result is verified.
std::optional<Module> Parse(SourceId source, const Sources& sources, Diagnostics& diagnostics);

}  // namespace texgraph::ir
