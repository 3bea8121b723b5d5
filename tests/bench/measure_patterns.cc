// SPDX-License-Identifier: Apache-2.0
// The table of "Pattern Based Procedural Textures", section 6, and our figures for the same.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/base/files.h"
#include "tests/bench/measure.h"
#include "tests/bench/measure_shader.h"

namespace texgraph::bench {
namespace {

constexpr int kQuietRounds = 8;
// In every direction of the picture; a pattern is larger on the screen than in its texture.
constexpr int kCellsSeen = 16;

// One look-up in the array of patterns that the graph has, repeated over the picture.
std::string PlainShader(const runtime::Manifest& manifest, int cells) {
  std::string name;
  int binding = 0, at = 0;
  for (const runtime::ManifestTexture& texture : manifest.textures) {
    if (!texture.is_used) continue;
    if (texture.options.is_array) {
      name = texture.variable;
      binding = at;
    }
    ++at;
  }
  return fmt::format(R"(#version 450 core
layout(location = 0) in vec2 uv;
layout(binding = {}) uniform sampler2DArray {};
layout(location = 0) out vec4 out_color;
void main() {{ out_color = texture({}, vec3(uv * {}.0, 0.0)); }}
)",
                     binding, name, name, cells);
}

PatternEntry Measure(const std::string& root, PatternEntry entry) {
  const std::string path = fmt::format("{0}/graphs/{1}/{1}.jsonc", root, entry.name);
  Diagnostics diagnostics;
  auto text = ReadFile(path, 1 << 20, {}, diagnostics);
  if (!text) {
    entry.error = "cannot read the graph";
    return entry;
  }
  std::vector<runtime::RenderRequest> requests;
  for (int cells : {1 << 4, 1 << 7, 1 << 10}) {
    Drawable drawable = Prepare(path, *text, {fmt::format("cells=[{0}, {0}]", cells)});
    if (!drawable.error.empty()) {
      entry.error = drawable.error;
      return entry;
    }
    const double end = double(kCellsSeen) / cells;
    drawable.request.window = {0, 0, end, end};
    requests.push_back(drawable.request);
    entry.samples = drawable.weight.samples;
    entry.computing = std::max(entry.computing, drawable.weight.computing);
  }
  requests.push_back(requests[0]);
  requests.back().shader = PlainShader(requests[0].manifest, 1 << 4);
  const Drawn drawn = DrawInTurns(requests, kQuietRounds);
  entry.error = drawn.error;
  if (!entry.error.empty()) return entry;
  auto sizes = std::span(drawn.frame_ms).first(3);
  entry.to_plain = drawn.frame_ms[0] / drawn.frame_ms[3];
  entry.over_sizes = std::ranges::max(sizes) / std::ranges::min(sizes);
  return entry;
}

}  // namespace

std::vector<PatternEntry> MeasurePatterns(const std::string& root) {
  struct Promise {
    const char* name;
    int most_samples, paper_samples, most_computing, paper_instructions;
    double most_to_plain;
  };
  constexpr Promise kPromises[] = {{"aperiodic_tiling", 1, 5, 32, 56, 1.35},
                                   {"areas_tiling", 3, 7, 40, 65, 0},
                                   {"dithered_areas_tiling", 3, 10, 70, 117, 0},
                                   {"transition_tiling", 7, 39, 256, 512, 0}};
  std::vector<PatternEntry> entries;
  for (const Promise& promise : kPromises) {
    PatternEntry entry;
    entry.name = promise.name;
    entry.most_samples = promise.most_samples;
    entry.paper_samples = promise.paper_samples;
    entry.most_computing = promise.most_computing;
    entry.paper_instructions = promise.paper_instructions;
    entry.most_to_plain = promise.most_to_plain;
    entries.push_back(Measure(root, std::move(entry)));
  }
  return entries;
}

}  // namespace texgraph::bench
