// SPDX-License-Identifier: Apache-2.0
#include <setjmp.h>
#include <string.h>

#include "compiler/textures/codec.h"

extern "C" {
#include <jerror.h>
#include <jpeglib.h>
}

namespace texgraph::textures {
namespace {

// A progressive file may hold any number of scans, each a pass over the whole picture: a small
// file, minutes of work.
constexpr int kMaxScans = 512;

// What the library's C functions need; it outlives every longjmp.
struct Reader {
  jpeg_error_mgr errors;
  jpeg_progress_mgr progress;
  jpeg_decompress_struct jpeg;
  jmp_buf jump;
  CodecError* error = nullptr;
  ~Reader() { jpeg_destroy_decompress(&jpeg); }
};

Reader& Self(j_common_ptr jpeg) { return *static_cast<Reader*>(jpeg->client_data); }

[[noreturn]] void OnError(j_common_ptr jpeg) {
  Reader& self = Self(jpeg);
  if (jpeg->err->msg_code == JERR_OUT_OF_MEMORY) self.error->kind = DiagnosticKind::kOutOfMemory;
  if (jpeg->err->msg_code == JERR_IMAGE_TOO_BIG) self.error->kind = DiagnosticKind::kSizeLimit;
  char text[JMSG_LENGTH_MAX];
  jpeg->err->format_message(jpeg, text);
  snprintf(self.error->text, sizeof self.error->text, "%s", text);
  longjmp(self.jump, 1);
}

// The library calls damage a warning and goes on with grey; only what does no harm to the pixels is
// let pass.
void OnMessage(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_ADOBE_XFORM:
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_JFIF_MAJOR:
      return;
    case JWRN_JPEG_EOF:
      snprintf(Self(jpeg).error->text, sizeof Self(jpeg).error->text, "the file is truncated");
      longjmp(Self(jpeg).jump, 1);
    default:
      OnError(jpeg);
  }
}

void OnOutput(j_common_ptr) {}

void OnProgress(j_common_ptr common) {
  auto* jpeg = reinterpret_cast<j_decompress_ptr>(common);
  if (jpeg->input_scan_number <= kMaxScans) return;
  Reader& self = Self(common);
  self.error->kind = DiagnosticKind::kSizeLimit;
  snprintf(self.error->text, sizeof self.error->text, "it has more than %d scans", kMaxScans);
  longjmp(self.jump, 1);
}

bool ReadHeader(Reader& reader, FILE* file, ImageInfo& image) {
  memset(&reader.jpeg, 0, sizeof reader.jpeg);  // jpeg_destroy_decompress is safe from here on
  reader.jpeg.err = jpeg_std_error(&reader.errors);
  reader.errors.error_exit = OnError;
  reader.errors.emit_message = OnMessage;
  reader.errors.output_message = OnOutput;
  reader.jpeg.client_data = &reader;
  if (setjmp(reader.jump) != 0) return false;
  jpeg_create_decompress(&reader.jpeg);
  reader.progress.progress_monitor = OnProgress;
  reader.jpeg.progress = &reader.progress;
  jpeg_stdio_src(&reader.jpeg, file);
  jpeg_read_header(&reader.jpeg, TRUE);
  const J_COLOR_SPACE space = reader.jpeg.jpeg_color_space;
  if (space != JCS_GRAYSCALE && space != JCS_YCbCr && space != JCS_RGB) {
    snprintf(reader.error->text, sizeof reader.error->text,
             "its colours are neither grey nor RGB (CMYK?); convert it to RGB");
    return false;
  }
  image.width = reader.jpeg.image_width;
  image.height = reader.jpeg.image_height;
  image.channels = space == JCS_GRAYSCALE ? 1 : 3;
  image.bits = 8;
  return true;
}

bool ReadPixels(Reader& reader, Image& image) {
  if (setjmp(reader.jump) != 0) return false;
  reader.jpeg.out_color_space = image.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
  reader.jpeg.dct_method = JDCT_ISLOW;  // the one that is exact on every machine
  jpeg_start_decompress(&reader.jpeg);
  while (reader.jpeg.output_scanline < reader.jpeg.output_height) {
    JSAMPROW row = image.pixels.data() + reader.jpeg.output_scanline * image.RowBytes();
    jpeg_read_scanlines(&reader.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&reader.jpeg);
  return true;
}

}  // namespace

bool DecodeJpeg(FILE* file, bool header_only, Image& image, CodecError& error) {
  Reader reader;
  reader.error = &error;
  if (!ReadHeader(reader, file, image)) return false;
  if (!PreparePixels(header_only, image, error)) return false;
  return header_only || ReadPixels(reader, image);
}

}  // namespace texgraph::textures
