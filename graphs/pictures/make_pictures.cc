// SPDX-License-Identifier: Apache-2.0
// make_pictures FOLDER [PREFIX]: writes the pictures of the example graphs, or those of them whose
// paths begin with PREFIX, into FOLDER (graphs/ as a rule).
#include <png.h>

#include <cstdio>
#include <cstring>
#include <filesystem>

#include "graphs/pictures/picture.h"

namespace {

bool WritePng(const std::filesystem::path& path, const texgraph::pictures::Picture& picture,
              png_uint_32 flags) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = picture.has_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  image.flags = flags;
  return png_image_write_to_file(&image, path.c_str(), 0, picture.pixels.data(), 0, nullptr) != 0;
}

// PNG's filters make pictures of few colours larger, so it is tried without them, too.
bool WriteSmaller(const std::filesystem::path& path, const texgraph::pictures::Picture& picture) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  const std::filesystem::path other = path.string() + ".unfiltered";
  if (!WritePng(path, picture, 0) || !WritePng(other, picture, PNG_IMAGE_FLAG_FAST)) return false;
  if (std::filesystem::file_size(other, error) < std::filesystem::file_size(path, error)) {
    std::filesystem::rename(other, path, error);
  } else {
    std::filesystem::remove(other, error);
  }
  return !error;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: make_pictures FOLDER [PREFIX]\n");
    return 2;
  }
  for (const texgraph::pictures::NamedPicture& picture : texgraph::pictures::Pictures()) {
    if (argc == 3 && picture.path.rfind(argv[2], 0) != 0) continue;
    std::filesystem::path path = std::filesystem::path(argv[1]) / picture.path;
    if (!WriteSmaller(path, picture.make())) {
      std::fprintf(stderr, "make_pictures: cannot write %s\n", path.c_str());
      return 3;
    }
    std::printf("%s\n", path.c_str());
  }
  return 0;
}
