// SPDX-License-Identifier: Apache-2.0
// Pictures that get an alpha channel before they become textures: from a mask, which is another
// picture, and from a colour key, which takes a background away. Transparent texels get the colours
// of what is next to them, so that neither the filter nor a mip level shows the background again.
// docs/decisions/0013-colour-keys.md says why it is done so.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "compiler/base/diagnostics.h"
#include "compiler/base/roots.h"
#include "compiler/textures/image.h"

namespace texgraph::textures {

inline constexpr uint32_t kMaxKeyEdge = 64;

struct ColorKey {
  // What is taken away, in the picture's own numbers, 0 to 1: those of a colour picker.
  std::array<float, 3> color{};
  // A texel is background if none of its red, green and blue is further from `color` than this.
  float tolerance = 0.05f;
  // How far, in texels, the background is mixed into what is kept.
  uint32_t edge = 2;
};

enum class MaskChannel : uint8_t { kRed, kGreen, kBlue, kAlpha };  // a grey picture: all but alpha

struct MaskSource {
  std::string file;
  SourceRange range;
  MaskChannel channel = MaskChannel::kRed;
  bool invert = false;
};

struct PictureSource {
  std::string file;
  SourceRange range;
  bool srgb = true;  // how the picture's numbers mix: as light, or as they are
  std::optional<MaskSource> mask;
  std::optional<ColorKey> key;
};

// The picture as a texture's layer: as its file has it or, with a mask or a key, with four channels
// and as many bits as the deeper of the two. Alpha is the product of the picture's own, the mask's
// and the key's. Reported: all of ReadImage; a mask of another size (kBadImage); a warning if
// nothing is left of the picture.
std::optional<Image> ReadPicture(const PictureSource& source, Diagnostics& diagnostics,
                                 const Roots& roots = {});

// False, and reported at the mask, if the sizes differ.
bool CheckMaskSize(const PictureSource& source, const ImageInfo& picture, const ImageInfo& mask,
                   Diagnostics& diagnostics);

// ReadPicture without the files; `mask` may be null. `left` tells whether any texel shows.
Image PreparePicture(const Image& picture, const Image* mask, const PictureSource& source,
                     bool& left);

}  // namespace texgraph::textures
