// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/mesh_options.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "cli/texgraph/option_values.h"
#include "compiler/textures/srgb.h"

namespace texgraph::cli {
namespace {

// Numbers with commas between them: all of `numbers`, or at least `least` of them. Returns how many
// there were, 0 if the text is none.
size_t ReadNumbers(std::string_view text, std::span<double> numbers, size_t least) {
  size_t count = 0;
  for (;;) {
    const size_t comma = text.find(',');
    if (count == numbers.size() || !ReadNumber(text.substr(0, comma), numbers[count])) return 0;
    ++count;
    if (comma == std::string_view::npos) return count >= least ? count : 0;
    text.remove_prefix(comma + 1);
  }
}

bool IsBetween(double value, double low, double high) { return value >= low && value <= high; }

void ReadCamera(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  double numbers[3];
  const size_t count = ReadNumbers(text, numbers, 2);
  if (count == 0 || !IsBetween(numbers[0], -3600, 3600) || !IsBetween(numbers[1], -90, 90) ||
      (count == 3 && !IsBetween(numbers[2], 1e-9, 1e12))) {
    Usage(diagnostics,
          fmt::format("--camera takes YAW,PITCH or YAW,PITCH,DISTANCE: degrees, the pitch from -90 "
                      "to 90, and a positive distance; got '{}'",
                      Printable(text)));
    return;
  }
  runtime::Camera& camera = options.mesh.scene.camera;
  options.mesh.has_camera = true;
  camera.yaw = numbers[0];
  camera.pitch = numbers[1];
  if (count == 3) camera.distance = numbers[2];
}

void ReadLight(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  double yaw = 0;
  double pitch = 0;
  if (!ReadPair(text, yaw, pitch) || !IsBetween(yaw, -3600, 3600) || !IsBetween(pitch, -90, 90)) {
    Usage(diagnostics, fmt::format("--light takes YAW,PITCH in degrees, the pitch from -90 to 90; "
                                   "got '{}'",
                                   Printable(text)));
    return;
  }
  options.mesh.scene.lighting.yaw = yaw;
  options.mesh.scene.lighting.pitch = pitch;
}

void ReadTile(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  double numbers[2];
  const size_t count = ReadNumbers(text, numbers, 1);
  if (count == 1) numbers[1] = numbers[0];
  if (count == 0 || !IsBetween(numbers[0], 1e-3, 1e4) || !IsBetween(numbers[1], 1e-3, 1e4)) {
    Usage(diagnostics,
          fmt::format("--tile takes N or NU,NV from 0.001 to 10000, got '{}'", Printable(text)));
    return;
  }
  options.mesh.scene.tiles = {numbers[0], numbers[1]};
}

// A number within limits.
void ReadWithin(std::string_view option, std::string_view text, double low, double high,
                double& value, Diagnostics& diagnostics) {
  double number = 0;
  if (ReadNumber(text, number) && IsBetween(number, low, high)) {
    value = number;
    return;
  }
  Usage(diagnostics, fmt::format("{} takes a number from {} to {}, got '{}'", option, low, high,
                                 Printable(text)));
}

// A square number, since the samples of a pixel stand in a square.
void ReadSamples(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  constexpr uint32_t kSides[] = {1, 2, 4, 8};
  static_assert(kSides[3] == runtime::kMaxSampleSide);
  options.mesh.scene.samples =
      kSides[ReadWord("--samples", text, {"1", "4", "16", "64"}, diagnostics)];
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

void ReadBackground(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  glm::dvec4& background = options.mesh.scene.background;
  if (text == "none") {
    background = glm::dvec4(0);
    return;
  }
  bool ok = text.size() == 7 && text[0] == '#';
  for (int c = 0; ok && c < 3; ++c) {
    const int high = HexDigit(text[static_cast<size_t>(1 + 2 * c)]);
    const int low = HexDigit(text[static_cast<size_t>(2 + 2 * c)]);
    ok = high >= 0 && low >= 0;
    if (ok) background[c] = textures::SrgbDecode8(static_cast<uint8_t>(16 * high + low));
  }
  if (!ok) {
    Usage(diagnostics, fmt::format("--background takes none or a colour like #30343a, got '{}'",
                                   Printable(text)));
  }
}

// Without a mesh its options have no meaning, and with one --uv has none.
void CheckTogether(const MeshTexts& texts, bool has_window, const RenderOptions& options,
                   Diagnostics& diagnostics) {
  if (!options.mesh.mesh.empty()) {
    if (has_window)
      Usage(diagnostics, "--uv draws no mesh; --tile says how often a texture repeats");
    return;
  }
  const struct {
    std::string_view name;
    bool given;
  } kOptions[] = {
      {"--camera", !texts.camera.empty()},         {"--fov", !texts.field_of_view.empty()},
      {"--light", !texts.light.empty()},           {"--tile", !texts.tile.empty()},
      {"--relief", !texts.relief.empty()},         {"--samples", !texts.samples.empty()},
      {"--background", !texts.background.empty()}, {"--turntable", options.mesh.turntable}};
  for (const auto& option : kOptions) {
    if (option.given) Usage(diagnostics, fmt::format("{} needs --mesh", option.name));
  }
}

// Where a shape is seen best.
void SetDefaultCamera(std::string_view shape, runtime::Camera& camera) {
  camera.yaw = shape == "wall" ? 25 : shape == "sphere" ? 0 : 30;
  camera.pitch = shape == "wall" ? 10 : shape == "sphere" ? 10 : shape == "plane" ? 35 : 20;
}

}  // namespace

void ReadMeshOptions(const MeshTexts& texts, bool has_window, RenderOptions& options,
                     Diagnostics& diagnostics) {
  CheckTogether(texts, has_window, options, diagnostics);
  runtime::Scene& scene = options.mesh.scene;
  SetDefaultCamera(options.mesh.mesh, scene.camera);
  if (!texts.camera.empty()) ReadCamera(texts.camera, options, diagnostics);
  if (!texts.light.empty()) ReadLight(texts.light, options, diagnostics);
  if (!texts.tile.empty()) ReadTile(texts.tile, options, diagnostics);
  if (!texts.samples.empty()) ReadSamples(texts.samples, options, diagnostics);
  if (!texts.background.empty()) ReadBackground(texts.background, options, diagnostics);
  if (!texts.relief.empty())
    ReadWithin("--relief", texts.relief, -10, 10, scene.relief, diagnostics);
  if (!texts.field_of_view.empty())
    ReadWithin("--fov", texts.field_of_view, 1, 150, scene.camera.field_of_view, diagnostics);
}

std::optional<runtime::Scene> MakeScene(const RenderOptions& options, Diagnostics& diagnostics) {
  runtime::Scene scene = options.mesh.scene;
  const std::string& name = options.mesh.mesh;
  auto mesh = runtime::MakeShape(name);
  // A word alone was meant to be a shape.
  if (!mesh && name.find_first_of("./") == std::string::npos) {
    const auto& shapes = runtime::ShapeNames();
    Usage(diagnostics,
          fmt::format("--mesh takes {} or a .glb file, got '{}'{}", fmt::join(shapes, ", "),
                      Printable(name), DidYouMean(name, shapes)));
    return std::nullopt;
  }
  if (!mesh) mesh = runtime::ReadGltf(name, diagnostics);
  if (!mesh) return std::nullopt;
  const runtime::Box box = runtime::BoundsOf(*mesh);
  scene.mesh = std::make_shared<runtime::Mesh>(std::move(*mesh));
  if (scene.camera.distance) return scene;
  // One distance for all frames, or the mesh would swell and shrink.
  runtime::Camera camera = scene.camera;
  double distance = 0;
  const uint32_t views = options.mesh.turntable ? 24 : 1;
  for (uint32_t i = 0; i < views; ++i) {
    camera.yaw = scene.camera.yaw + 360.0 * i / views;
    distance = std::max(distance, runtime::FramingDistance(*scene.mesh, box, camera, options.width,
                                                           options.height));
  }
  scene.camera.distance = distance;
  return scene;
}

}  // namespace texgraph::cli
