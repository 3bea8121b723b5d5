// SPDX-License-Identifier: Apache-2.0
// move_sprites MANIFEST TEXTURE FRAMES OUTPUT: draws an animation in which sprites walk up the
// picture, with a shader that texgraphc made. TEXTURE is the graph's texture of sprites; the
// program puts its own there, of all its patterns. Frames are OUTPUT with a number: walk.png gives
// walk.0001.png and so on. Between two frames only those texels change that a sprite leaves or
// enters.
#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/base/output_files.h"
#include "compiler/graph/document.h"
#include "compiler/textures/image.h"
#include "runtime/live_sprites.h"

namespace texgraph {
namespace {

using textures::Sprite;
using textures::SpriteGrid;

constexpr uint32_t kMaxFrames = 9999;
constexpr size_t kMaxShaderBytes = size_t{64} << 20;
constexpr double kFramesPerSecond = 25;

struct Arguments {
  std::string manifest;
  std::string texture;
  uint32_t frames = 0;
  std::string output;
};

std::optional<uint32_t> ReadCount(std::string_view text, uint32_t most) {
  uint32_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count < 1 || count > most)
    return std::nullopt;
  return count;
}

std::optional<Arguments> ReadArguments(int argc, char** argv, Diagnostics& diagnostics) {
  const auto frames = argc == 5 ? ReadCount(argv[3], kMaxFrames) : std::nullopt;
  if (frames) return Arguments{argv[1], argv[2], *frames, argv[4]};
  diagnostics.Error(DiagnosticKind::kUsage, {},
                    "usage: move_sprites MANIFEST TEXTURE FRAMES OUTPUT");
  return std::nullopt;
}

// The shader, its manifest and its textures, as texgraphc wrote them.
std::optional<runtime::RenderRequest> Load(const std::string& path, Sources& sources,
                                           Diagnostics& diagnostics) {
  auto text = ReadFile(path, graph::kMaxDocumentBytes, {}, diagnostics);
  if (!text) return std::nullopt;
  const SourceId source = sources.Add(path, std::move(*text));
  const auto document =
      graph::ReadDocument(source, graph::DocumentFormat::kJson, sources, diagnostics);
  auto manifest = document ? runtime::ReadManifest(*document, diagnostics) : std::nullopt;
  if (!manifest) return std::nullopt;
  const std::string folder(FolderOf(path));
  auto shader = ReadFile(JoinPath(folder, manifest->shader), kMaxShaderBytes, {}, diagnostics);
  runtime::RenderRequest request;
  if (!shader || !runtime::LoadTextures(*manifest, folder, request.textures, diagnostics))
    return std::nullopt;
  request.shader = std::move(*shader);
  request.manifest = std::move(*manifest);
  return request;
}

// Sprites that walk up, each at its own pace and a little from side to side. One that comes to the
// top starts at the bottom again; one whose way is full waits.
class Walk {
 public:
  Walk(SpriteGrid& grid, uint32_t patterns) : grid_(grid) {
    const uint32_t count = grid.width() * grid.height() / 4 + 1;
    for (uint32_t i = 0; i < count; ++i) {
      // Evenly spread, however many there are: multiples of the plastic number's powers.
      const double x = Fraction(0.7548776662466927 * i);
      const double y = Fraction(0.5698402909980532 * i);
      Walker walker{0, {}, 0.6 + 0.8 * x, 6.2831853 * y};
      walker.sprite = {static_cast<int32_t>(Fraction(0.6180339887498949 * i) * patterns),
                       x * (grid.width() - 1.0), y * (grid.height() - 1.0)};
      if (grid.Add(walker.sprite, walker.id) == SpriteGrid::Failure::kNone)
        walkers_.push_back(walker);
    }
  }

  void Step(double time, double seconds) {
    for (Walker& walker : walkers_) {
      Sprite next = walker.sprite;
      next.x += 0.5 * seconds * std::cos(2 * time + walker.phase);
      next.x = std::min(std::max(next.x, -0.5), grid_.width() - 0.5);
      next.y += walker.speed * seconds;
      if (next.y >= grid_.height()) next.y = -0.95;
      if (grid_.Move(walker.id, next) == SpriteGrid::Failure::kNone) walker.sprite = next;
    }
  }

 private:
  struct Walker {
    SpriteGrid::Id id;
    Sprite sprite;
    double speed;  // cells a second
    double phase;
  };
  static double Fraction(double x) { return x - std::floor(x); }

  SpriteGrid& grid_;
  std::vector<Walker> walkers_;
};

std::string FramePath(const std::string& output, uint32_t number) {
  const size_t dot =
      output.size() > 4 && output.ends_with(".png") ? output.size() - 4 : output.size();
  return fmt::format("{}.{:04}.png", std::string_view(output).substr(0, dot), number);
}

std::string DrawFrames(const Arguments& arguments, Sources& sources, Diagnostics& diagnostics) {
  auto request = Load(arguments.manifest, sources, diagnostics);
  if (!request) return "";
  const auto renderer = runtime::LiveRenderer::Open(std::move(*request), diagnostics);
  if (!renderer) return "";
  auto sprites = runtime::LiveSprites::Open(*renderer, arguments.texture, diagnostics);
  if (!sprites) return "";
  Walk walk(sprites->grid(), sprites->patterns());
  OutputFiles files;
  size_t texels = 0;
  for (uint32_t frame = 0; frame < arguments.frames; ++frame) {
    const double time = frame / kFramesPerSecond;
    if (frame > 0) walk.Step(time, 1 / kFramesPerSecond);
    const auto sent = sprites->Send(*renderer, diagnostics);
    if (!sent) return "";
    if (frame > 0) texels += *sent;
    runtime::RenderResult result = renderer->Draw(time);
    const bool ok = result.ok();
    diagnostics.Append(std::move(result.diagnostics));
    if (!ok) return "";
    auto png = textures::EncodePng(result.outputs[0].image);
    if (!png) {
      diagnostics.Error(DiagnosticKind::kOutOfMemory, {}, "there is not enough memory");
      return "";
    }
    if (!files.Stage(FramePath(arguments.output, frame + 1), std::move(*png), diagnostics))
      return "";
  }
  if (!files.Commit(diagnostics)) return "";
  return fmt::format("{} frames; {:.1f} texels changed for each\n", arguments.frames,
                     static_cast<double>(texels) / std::max(arguments.frames - 1, 1u));
}

int Run(int argc, char** argv) {
  Diagnostics diagnostics;
  Sources sources;
  std::string text;
  if (const auto arguments = ReadArguments(argc, argv, diagnostics))
    text = DrawFrames(*arguments, sources, diagnostics);
  if (!diagnostics.all().empty()) text = FormatDiagnostics(diagnostics, sources, false) + text;
  (void)WriteAll(STDERR_FILENO, text);
  return static_cast<int>(diagnostics.exit_code());
}

}  // namespace
}  // namespace texgraph

int main(int argc, char** argv) {
  texgraph::PrepareProcess();
  return texgraph::Run(argc, argv);
}
