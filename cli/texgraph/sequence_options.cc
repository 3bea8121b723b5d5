// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/sequence_options.h"

#include "cli/texgraph/option_values.h"

namespace texgraph::cli {
namespace {

// What a sheet of a sweep has if --frames is not given.
constexpr uint32_t kSheetCells = 9;

void ReadFormat(const SequenceTexts& texts, RenderOptions& options, Diagnostics& diagnostics) {
  const std::string extension = ExtensionOf(options.output);
  if (!texts.format.empty()) {
    const uint32_t word = ReadWord("--format", texts.format, {"png", "exr"}, diagnostics);
    options.format = word == 0 ? PictureFormat::kPng : PictureFormat::kExr;
  } else if (extension == "exr") {
    options.format = PictureFormat::kExr;
  } else if (!extension.empty() && extension != "png") {
    Usage(diagnostics,
          fmt::format("'{}': pictures are .png or .exr files; --format says which it is otherwise",
                      Printable(options.output)));
  }
  const bool is_exr = options.format == PictureFormat::kExr;
  options.bits = is_exr ? 16 : 8;
  if (texts.bits.empty()) return;
  const uint32_t word = ReadWord("--bits", texts.bits, {"8", "16", "32"}, diagnostics);
  options.bits = static_cast<uint8_t>(8u << word);
  if (options.bits == 8 && is_exr) Usage(diagnostics, "OpenEXR files have 16 or 32 bits");
  if (options.bits == 32 && !is_exr) Usage(diagnostics, "PNG files have 8 or 16 bits");
}

void ReadTime(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  double end = 0;
  if (text.find(',') == std::string_view::npos) {
    ReadSeconds("--time", text, options.time, diagnostics);
  } else if (ReadPair(text, options.time, end)) {
    options.end_time = end;
  } else {
    Usage(diagnostics,
          fmt::format("--time takes T or T0,T1 in seconds, got '{}'", Printable(text)));
  }
}

void ReadSweep(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  Sweep& sweep = options.sweep.emplace();
  const size_t equals = text.find('=');
  sweep.name = text.substr(0, equals);
  bool ok = !sweep.name.empty();
  if (equals != std::string_view::npos) {
    auto& range = sweep.range.emplace();
    ok = ok && ReadPair(text.substr(equals + 1), range[0], range[1]);
  }
  if (!ok) {
    Usage(diagnostics, fmt::format("--sweep takes NAME or NAME=A,B with two numbers, got '{}'",
                                   Printable(text)));
  }
}

void ReadFrames(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  int64_t frames = 0;
  if (!ReadNumber(text, frames)) {
    Usage(diagnostics, fmt::format("--frames takes a number, got '{}'", Printable(text)));
  } else if (frames < 1 || frames > kMaxFrames) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, {},
                      fmt::format("1 to {} frames can be drawn, not {}", kMaxFrames, frames));
  } else {
    options.frames = static_cast<uint32_t>(frames);
  }
}

}  // namespace

void ReadSequenceOptions(const SequenceTexts& texts, RenderOptions& options,
                         Diagnostics& diagnostics) {
  ReadFormat(texts, options, diagnostics);
  if (!texts.time.empty()) ReadTime(texts.time, options, diagnostics);
  if (!texts.sweep.empty()) ReadSweep(texts.sweep, options, diagnostics);
  if (!texts.frames.empty()) ReadFrames(texts.frames, options, diagnostics);
  const bool varies = options.end_time || options.sweep || options.mesh.turntable;
  if (!texts.frames.empty() && !varies) {
    Usage(diagnostics,
          "with --frames, --time T0,T1, --sweep or --turntable says what differs between them");
  }
  if (varies && options.frames == 0) {
    if (options.contact_sheet) {
      options.frames = kSheetCells;
    } else if (texts.frames.empty()) {
      Usage(diagnostics, fmt::format("{} needs --frames N or --contact-sheet",
                                     options.sweep      ? "--sweep"
                                     : options.end_time ? "--time T0,T1"
                                                        : "--turntable"));
    }
  }
  if (options.frames > 0 && !options.contact_sheet && options.output == "-")
    Usage(diagnostics, "frames are numbered files; standard output is none");
  if (options.contact_sheet && options.frames == 0 && !options.output_name.empty())
    Usage(diagnostics, "a contact sheet of all outputs takes no --output");
}

}  // namespace texgraph::cli
