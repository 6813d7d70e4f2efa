// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <GL/glcorearb.h>

#include <functional>

namespace toile::picture {

/// The functions of OpenGL 3.3 core that we call: member name, type name of its pointer.
// clang-format off
#define TOILE_GL_FUNCTIONS(X)                                                                                  \
    X(GetString, GETSTRING) X(GetIntegerv, GETINTEGERV) X(GetError, GETERROR) X(Viewport, VIEWPORT)            \
    X(ClearColor, CLEARCOLOR) X(Clear, CLEAR) X(Enable, ENABLE) X(Disable, DISABLE) X(DepthFunc, DEPTHFUNC)    \
    X(DepthMask, DEPTHMASK) X(ColorMask, COLORMASK) X(BlendFuncSeparate, BLENDFUNCSEPARATE)                    \
    X(BlendEquation, BLENDEQUATION) X(PolygonOffset, POLYGONOFFSET) X(PixelStorei, PIXELSTOREI)                \
    X(ReadPixels, READPIXELS) X(Finish, FINISH) X(CreateShader, CREATESHADER) X(ShaderSource, SHADERSOURCE)    \
    X(CompileShader, COMPILESHADER) X(GetShaderiv, GETSHADERIV) X(GetShaderInfoLog, GETSHADERINFOLOG)          \
    X(DeleteShader, DELETESHADER) X(CreateProgram, CREATEPROGRAM) X(AttachShader, ATTACHSHADER)                \
    X(LinkProgram, LINKPROGRAM) X(GetProgramiv, GETPROGRAMIV) X(GetProgramInfoLog, GETPROGRAMINFOLOG)          \
    X(DeleteProgram, DELETEPROGRAM) X(UseProgram, USEPROGRAM) X(GetUniformLocation, GETUNIFORMLOCATION)        \
    X(Uniform1i, UNIFORM1I) X(Uniform1f, UNIFORM1F) X(Uniform2f, UNIFORM2F) X(Uniform3f, UNIFORM3F)            \
    X(Uniform4f, UNIFORM4F) X(UniformMatrix4fv, UNIFORMMATRIX4FV) X(GenVertexArrays, GENVERTEXARRAYS)          \
    X(BindVertexArray, BINDVERTEXARRAY) X(DeleteVertexArrays, DELETEVERTEXARRAYS) X(GenBuffers, GENBUFFERS)    \
    X(BindBuffer, BINDBUFFER) X(BufferData, BUFFERDATA) X(DeleteBuffers, DELETEBUFFERS)                        \
    X(VertexAttribPointer, VERTEXATTRIBPOINTER) X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY)            \
    X(DrawArrays, DRAWARRAYS) X(DrawElements, DRAWELEMENTS) X(GenTextures, GENTEXTURES)                        \
    X(BindTexture, BINDTEXTURE) X(ActiveTexture, ACTIVETEXTURE) X(TexBuffer, TEXBUFFER)                        \
    X(TexImage2D, TEXIMAGE2D) X(TexParameteri, TEXPARAMETERI) X(DeleteTextures, DELETETEXTURES)                \
    X(GenFramebuffers, GENFRAMEBUFFERS) X(BindFramebuffer, BINDFRAMEBUFFER)                                    \
    X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D) X(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER)          \
    X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS) X(DeleteFramebuffers, DELETEFRAMEBUFFERS)                \
    X(DrawBuffer, DRAWBUFFER) X(ReadBuffer, READBUFFER) X(GenRenderbuffers, GENRENDERBUFFERS)                  \
    X(BindRenderbuffer, BINDRENDERBUFFER) X(RenderbufferStorage, RENDERBUFFERSTORAGE)                          \
    X(DeleteRenderbuffers, DELETERENDERBUFFERS)
// clang-format on

/// The entry points of a context, each without its prefix "gl". Valid for that context and those it shares
/// with.
struct GlFunctions {
#define TOILE_GL_MEMBER(name, type) PFNGL##type##PROC name = nullptr;
    TOILE_GL_FUNCTIONS(TOILE_GL_MEMBER)
#undef TOILE_GL_MEMBER
};

/// Finds an entry point of the current context by its full name; null if there is none.
using GlAddressOf = std::function<void*(const char*)>;

/// Error names the first function that the driver does not have.
[[nodiscard]] Result<GlFunctions> loadGlFunctions(const GlAddressOf& addressOf);

} // namespace toile::picture
