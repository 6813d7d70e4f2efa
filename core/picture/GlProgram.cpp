// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/GlProgram.h"

#include <array>

namespace toile::picture {

namespace {

Result<GLuint> compiled(const GlFunctions& gl, GLenum stage, const char* source) {
    const GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint good = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    std::array<char, 2000> log{};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.DeleteShader(shader);
    return fail(ErrorCode::unsupported, std::string("The graphics driver refused a shader: ") + log.data());
}

} // namespace

Result<GLuint> linkedProgram(const GlFunctions& gl, const ShaderSources& sources) {
    const GLuint program = gl.CreateProgram();
    for (const auto& [stage, source] :
         {std::pair{GL_VERTEX_SHADER, sources.vertex}, std::pair{GL_GEOMETRY_SHADER, sources.geometry},
          std::pair{GL_FRAGMENT_SHADER, sources.fragment}}) {
        if (!source) continue;
        const auto shader = compiled(gl, stage, source);
        if (!shader) {
            gl.DeleteProgram(program);
            return shader;
        }
        gl.AttachShader(program, *shader);
        gl.DeleteShader(*shader); // lives as long as the program
    }
    gl.LinkProgram(program);
    GLint good = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return program;
    std::array<char, 2000> log{};
    gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.DeleteProgram(program);
    return fail(ErrorCode::unsupported, std::string("The graphics driver refused a program: ") + log.data());
}

} // namespace toile::picture
