// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/GlFunctions.h"

namespace toile::picture {

Result<GlFunctions> loadGlFunctions(const GlAddressOf& addressOf) {
    GlFunctions gl;
#define TOILE_GL_LOAD(name, type)                                                                                      \
    gl.name = reinterpret_cast<PFNGL##type##PROC>(addressOf("gl" #name));                                              \
    if (!gl.name)                                                                                                      \
        return fail(ErrorCode::unsupported, "The graphics driver has no function gl" #name "; OpenGL 3.3 is needed.");
    TOILE_GL_FUNCTIONS(TOILE_GL_LOAD)
#undef TOILE_GL_LOAD
    return gl;
}

} // namespace toile::picture
