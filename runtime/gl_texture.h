// SPDX-License-Identifier: Apache-2.0
// Uploads textures with all their levels as they were made (compiler/textures/texels.h): the driver
// converts nothing.
#pragma once

#include <string>

#include "compiler/textures/texels.h"
#include "runtime/gl_context.h"
#include "runtime/texel_update.h"

namespace texgraph::runtime {

// Makes the texture on texture unit `unit`, and leaves it bound there. Nothing (0), with what is in
// the way in `why_not`, if the driver says that the texture is too large for it.
GLuint UploadTexture(const GlFunctions& gl, uint32_t unit, const textures::TextureData& data,
                     std::string& why_not);
// Changes texels of the texture of `data` that lies bound on that unit. The update has been
// checked.
void UpdateTexels(const GlFunctions& gl, uint32_t unit, const textures::TextureData& data,
                  const TexelUpdate& update);

}  // namespace texgraph::runtime
