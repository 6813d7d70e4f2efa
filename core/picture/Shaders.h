// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/GlProgram.h"

namespace toile::picture::shaders {

/// Soft gradient behind everything, without a vertex buffer: one triangle larger than the picture.
extern const ShaderSources background;
/// Depth of surfaces as the key light sees them.
extern const ShaderSources shadow;
/// Body and cloth, lit; both sides of the cloth differ.
extern const ShaderSources surface;
/// Grid and shadow on the floor, fading with distance.
extern const ShaderSources floor;
/// Lines of a width in pixels with smooth edges and round ends.
extern const ShaderSources line;

} // namespace toile::picture::shaders
