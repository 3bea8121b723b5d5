// SPDX-License-Identifier: Apache-2.0
#include "runtime/gl_texture.h"

#include <fmt/format.h>

#include <algorithm>

namespace texgraph::runtime {
namespace {

using textures::TexelFormat;

struct Format {
  GLint internal;
  GLenum type;
};

Format FormatOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::kRgba8:
      return {GL_RGBA8, GL_UNSIGNED_BYTE};
    case TexelFormat::kSrgb8Alpha8:
      return {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE};
    case TexelFormat::kRgba16:
      return {GL_RGBA16, GL_UNSIGNED_SHORT};
    case TexelFormat::kRgba32F:
      break;
  }
  return {GL_RGBA32F, GL_FLOAT};
}

GLint WrapOf(ir::Wrap wrap) {
  switch (wrap) {
    case ir::Wrap::kRepeat:
      return GL_REPEAT;
    case ir::Wrap::kClamp:
      return GL_CLAMP_TO_EDGE;
    case ir::Wrap::kMirror:
      break;
  }
  return GL_MIRRORED_REPEAT;
}

GLint MinFilterOf(const ir::SamplerState& sampler) {
  const bool linear = sampler.filter == ir::Filter::kLinear;
  switch (sampler.mip_filter) {
    case ir::MipFilter::kNone:
      return linear ? GL_LINEAR : GL_NEAREST;
    case ir::MipFilter::kNearest:
      return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    case ir::MipFilter::kLinear:
      break;
  }
  return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
}

// Whether the driver would take level 0. The stated maximum is not enough: Mesa refuses smaller
// ones that need too much memory.
bool Fits(const GlFunctions& gl, const textures::TextureData& data, std::string& why_not) {
  const Format format = FormatOf(data.format);
  const auto width = static_cast<GLsizei>(data.levels[0].width);
  const auto height = static_cast<GLsizei>(data.levels[0].height);
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width > most || height > most) {
    why_not = fmt::format("{} x {} texels; the driver takes {} each way", width, height, most);
    return false;
  }
  const GLenum target = data.is_array ? GL_PROXY_TEXTURE_2D_ARRAY : GL_PROXY_TEXTURE_2D;
  if (data.is_array) {
    gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (data.layers > static_cast<uint32_t>(most)) {
      why_not = fmt::format("{} layers; the driver takes {}", data.layers, most);
      return false;
    }
    gl.TexImage3D(target, 0, format.internal, width, height, static_cast<GLsizei>(data.layers), 0,
                  GL_RGBA, format.type, nullptr);
  } else {
    gl.TexImage2D(target, 0, format.internal, width, height, 0, GL_RGBA, format.type, nullptr);
  }
  GLint accepted = 0;
  gl.GetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &accepted);
  if (accepted == width) return true;
  why_not = fmt::format("{} x {} texels, too large for the driver", width, height);
  return false;
}

}  // namespace

GLuint UploadTexture(const GlFunctions& gl, uint32_t unit, const textures::TextureData& data,
                     std::string& why_not) {
  if (!Fits(gl, data, why_not)) return 0;
  const GLenum target = data.is_array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
  const Format format = FormatOf(data.format);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(target, texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto last = static_cast<GLint>(data.levels.size()) - 1;
  for (GLint level = 0; level <= last; ++level) {
    const textures::TexelLevel& from = data.levels[static_cast<size_t>(level)];
    const auto width = static_cast<GLsizei>(from.width);
    const auto height = static_cast<GLsizei>(from.height);
    if (data.is_array) {
      gl.TexImage3D(target, level, format.internal, width, height,
                    static_cast<GLsizei>(data.layers), 0, GL_RGBA, format.type, from.bytes.data());
    } else {
      gl.TexImage2D(target, level, format.internal, width, height, 0, GL_RGBA, format.type,
                    from.bytes.data());
    }
  }
  const float coarsest = std::min(data.sampler.max_level, static_cast<float>(last));
  gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(coarsest));
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, MinFilterOf(data.sampler));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER,
                   data.sampler.filter == ir::Filter::kLinear ? GL_LINEAR : GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, WrapOf(data.sampler.wrap_u));
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, WrapOf(data.sampler.wrap_v));
  return texture;
}

}  // namespace texgraph::runtime
