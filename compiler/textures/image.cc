// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/image.h"

#include <errno.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <new>
#include <system_error>

#include "compiler/textures/codec.h"

namespace texgraph::textures {
namespace {

void ReportErrno(const std::string& path, int error, SourceRange range, Diagnostics& diagnostics) {
  if (error == ENOENT || error == ENOTDIR) {
    diagnostics.Error(DiagnosticKind::kMissingFile, range,
                      fmt::format("there is no image '{}'", Printable(path)));
    return;
  }
  diagnostics.Error(DiagnosticKind::kCannotRead, range,
                    fmt::format("cannot read image '{}': {}", Printable(path),
                                std::generic_category().message(error)));
}

bool Decode(FILE* file, bool header_only, Image& image, CodecError& error) {
  static constexpr uint8_t kPng[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  static constexpr uint8_t kJpeg[3] = {0xff, 0xd8, 0xff};
  uint8_t magic[8];
  const size_t read = fread(magic, 1, sizeof magic, file);
  rewind(file);
  if (read == 0) {
    snprintf(error.text, sizeof error.text,
             ferror(file) ? "it cannot be read" : "the file is empty");
    return false;
  }
  if (read >= sizeof kPng && memcmp(magic, kPng, sizeof kPng) == 0) {
    return DecodePng(file, header_only, image, error);
  }
  if (read >= sizeof kJpeg && memcmp(magic, kJpeg, sizeof kJpeg) == 0) {
    return DecodeJpeg(file, header_only, image, error);
  }
  snprintf(error.text, sizeof error.text, "it is neither a PNG nor a JPEG file");
  return false;
}

std::optional<Image> Read(const std::string& path, bool header_only, SourceRange range,
                          const Roots& roots, Diagnostics& diagnostics) {
  File file = OpenImage(path, range, roots, diagnostics);
  if (!file) return std::nullopt;
  Image image;
  CodecError error;
  if (Decode(file.get(), header_only, image, error)) return image;
  diagnostics.Error(
      error.kind, range,
      fmt::format("cannot use image '{}': {}", Printable(path), Printable(error.text)));
  return std::nullopt;
}

}  // namespace

File OpenImage(const std::string& path, SourceRange range, const Roots& roots,
               Diagnostics& diagnostics) {
  if (path.find('\0') != std::string::npos) {
    ReportErrno(path, EINVAL, range, diagnostics);
    return nullptr;
  }
  auto refuse = [&] {
    diagnostics.Error(
        DiagnosticKind::kOutsideRoot, range,
        fmt::format("image '{}' is outside of the folders that --root allows", Printable(path)));
    return nullptr;
  };
  if (!roots.Contain(path)) return refuse();
  const int descriptor = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) {
    ReportErrno(path, errno, range, diagnostics);
    return nullptr;
  }
  if (!roots.ContainFile(descriptor)) {
    close(descriptor);
    return refuse();
  }
  struct stat status;
  int error = fstat(descriptor, &status) == 0 ? 0 : errno;
  File file;
  if (error == 0 && !S_ISREG(status.st_mode)) {
    diagnostics.Error(DiagnosticKind::kCannotRead, range,
                      fmt::format("image '{}' is not a regular file", Printable(path)));
  } else if (error == 0 && static_cast<uint64_t>(status.st_size) > kMaxImageFileBytes) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                      fmt::format("image '{}' has {} bytes; the limit is {}", Printable(path),
                                  status.st_size, kMaxImageFileBytes));
  } else {
    if (error == 0) file.reset(fdopen(descriptor, "rb"));
    if (file) return file;
    ReportErrno(path, error != 0 ? error : errno, range, diagnostics);
  }
  close(descriptor);
  return nullptr;
}

uint32_t Image::At(uint32_t x, uint32_t y, uint32_t channel) const {
  const size_t index = (size_t{y} * width + x) * channels + channel;
  if (bits == 8) return pixels[index];
  uint16_t sample;
  memcpy(&sample, pixels.data() + 2 * index, sizeof sample);
  return sample;
}

bool PreparePixels(bool header_only, Image& image, CodecError& error) {
  const uint64_t count = uint64_t{image.width} * image.height;
  if (count == 0) {
    snprintf(error.text, sizeof error.text, "it has no pixels");
    return false;
  }
  if (count > kMaxImagePixels) {
    error.kind = DiagnosticKind::kSizeLimit;
    snprintf(error.text, sizeof error.text, "it has %u x %u pixels; the limit is %llu in all",
             image.width, image.height, static_cast<unsigned long long>(kMaxImagePixels));
    return false;
  }
  if (header_only) return true;
  try {
    image.pixels.resize(image.RowBytes() * image.height);
  } catch (const std::bad_alloc&) {
    error.kind = DiagnosticKind::kOutOfMemory;
    snprintf(error.text, sizeof error.text, "there is not enough memory for its %u x %u pixels",
             image.width, image.height);
    return false;
  }
  return true;
}

std::optional<ImageInfo> ProbeImage(const std::string& path, SourceRange range,
                                    Diagnostics& diagnostics, const Roots& roots) {
  return Read(path, true, range, roots, diagnostics);
}

std::optional<Image> ReadImage(const std::string& path, SourceRange range, Diagnostics& diagnostics,
                               const Roots& roots) {
  return Read(path, false, range, roots, diagnostics);
}

}  // namespace texgraph::textures
