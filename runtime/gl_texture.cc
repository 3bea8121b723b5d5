// SPDX-License-Identifier: Apache-2.0
#include "runtime/gl_texture.h"

#include <fmt/format.h>

#include <algorithm>

namespace texgraph::runtime {
namespace {

using textures::TexelFormat;

struct Format {
  GLint internal;
  GLenum layout;
  GLenum type;
};

Format FormatOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::kSrgb8Alpha8:
      return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::kRgba16:
      return {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
    case TexelFormat::kRgba16F:
      return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case TexelFormat::kRgba32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case TexelFormat::kR16F:
      return {GL_R16F, GL_RED, GL_HALF_FLOAT};
    case TexelFormat::kR32F:
      break;
  }
  return {GL_R32F, GL_RED, GL_FLOAT};
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

GLenum TargetOf(const textures::TextureData& data) {
  return data.is_3d ? GL_TEXTURE_3D : data.is_array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

GLenum ProxyOf(const textures::TextureData& data) {
  return data.is_3d      ? GL_PROXY_TEXTURE_3D
         : data.is_array ? GL_PROXY_TEXTURE_2D_ARRAY
                         : GL_PROXY_TEXTURE_2D;
}

void SetLevel(const GlFunctions& gl, GLenum target, const textures::TextureData& data, GLint level,
              const void* bytes) {
  const Format format = FormatOf(data.format);
  const textures::TexelLevel& from = data.levels[static_cast<size_t>(level)];
  const auto width = static_cast<GLsizei>(from.width);
  const auto height = static_cast<GLsizei>(from.height);
  if (data.is_3d || data.is_array) {
    const auto depth = static_cast<GLsizei>(data.is_3d ? from.depth : data.layers);
    gl.TexImage3D(target, level, format.internal, width, height, depth, 0, format.layout,
                  format.type, bytes);
  } else {
    gl.TexImage2D(target, level, format.internal, width, height, 0, format.layout, format.type,
                  bytes);
  }
}

// Whether the driver would take level 0. The stated maximum is not enough: Mesa refuses smaller
// ones that need too much memory.
bool Fits(const GlFunctions& gl, const textures::TextureData& data, std::string& why_not) {
  const textures::TexelLevel& base = data.levels[0];
  GLint most = 0;
  gl.GetIntegerv(data.is_3d ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &most);
  const auto limit = static_cast<uint32_t>(most);
  if (base.width > limit || base.height > limit || base.depth > limit) {
    const std::string size = data.is_3d
                                 ? fmt::format("{} x {} x {}", base.width, base.height, base.depth)
                                 : fmt::format("{} x {}", base.width, base.height);
    why_not = fmt::format("{} texels; the driver takes {} each way", size, limit);
    return false;
  }
  if (data.is_array) {
    gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (data.layers > static_cast<uint32_t>(most)) {
      why_not = fmt::format("{} layers; the driver takes {}", data.layers, most);
      return false;
    }
  }
  SetLevel(gl, ProxyOf(data), data, 0, nullptr);
  GLint accepted = 0;
  gl.GetTexLevelParameteriv(ProxyOf(data), 0, GL_TEXTURE_WIDTH, &accepted);
  if (static_cast<uint32_t>(accepted) == base.width) return true;
  why_not = fmt::format("{} x {} texels, too large for the driver", base.width, base.height);
  return false;
}

}  // namespace

GLuint UploadTexture(const GlFunctions& gl, uint32_t unit, const textures::TextureData& data,
                     std::string& why_not) {
  if (!Fits(gl, data, why_not)) return 0;
  const GLenum target = TargetOf(data);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(target, texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto last = static_cast<GLint>(data.levels.size()) - 1;
  for (GLint level = 0; level <= last; ++level) {
    SetLevel(gl, target, data, level, data.levels[static_cast<size_t>(level)].bytes.data());
  }
  const float coarsest = std::min(data.sampler.max_level, static_cast<float>(last));
  gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(coarsest));
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, MinFilterOf(data.sampler));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER,
                   data.sampler.filter == ir::Filter::kLinear ? GL_LINEAR : GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, WrapOf(data.sampler.wrap_u));
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, WrapOf(data.sampler.wrap_v));
  if (data.is_3d) gl.TexParameteri(target, GL_TEXTURE_WRAP_R, WrapOf(data.sampler.wrap_w));
  return texture;
}

void UpdateTexels(const GlFunctions& gl, uint32_t unit, const textures::TextureData& data,
                  const TexelUpdate& update) {
  const Format format = FormatOf(data.format);
  const GLenum target = TargetOf(data);
  const auto level = static_cast<GLint>(update.level);
  const auto x = static_cast<GLint>(update.x);
  const auto y = static_cast<GLint>(update.y);
  const auto width = static_cast<GLsizei>(update.width);
  const auto height = static_cast<GLsizei>(update.height);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (target == GL_TEXTURE_2D) {
    gl.TexSubImage2D(target, level, x, y, width, height, format.layout, format.type,
                     update.texels.data());
  } else {
    gl.TexSubImage3D(target, level, x, y, static_cast<GLint>(update.layer), width, height, 1,
                     format.layout, format.type, update.texels.data());
  }
}

}  // namespace texgraph::runtime
