// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "core/picture/Colour.h"
#include "core/picture/GlFunctions.h"

namespace toile::picture {

/// GLSL texts of the stages; an absent geometry stage is null.
struct ShaderSources {
    const char* vertex = nullptr;
    const char* geometry = nullptr;
    const char* fragment = nullptr;
};

/// Error carries the driver's log.
[[nodiscard]] Result<GLuint> linkedProgram(const GlFunctions& gl, const ShaderSources& sources);

/// Sets uniforms of one program, which is made the used one.
class Uniforms {
public:
    Uniforms(const GlFunctions& gl, GLuint program) : gl_(gl), program_(program) { gl_.UseProgram(program); }

    void set(const char* name, int value) const { gl_.Uniform1i(at(name), value); }
    void set(const char* name, bool value) const { gl_.Uniform1i(at(name), value ? 1 : 0); }
    void set(const char* name, double value) const { gl_.Uniform1f(at(name), static_cast<float>(value)); }
    void set(const char* name, Vec2 value) const {
        gl_.Uniform2f(at(name), static_cast<float>(value.x), static_cast<float>(value.y));
    }
    void set(const char* name, const Vec3& value) const {
        gl_.Uniform3f(at(name), static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z));
    }
    void set(const char* name, const Colour& value) const {
        gl_.Uniform4f(at(name), value.r, value.g, value.b, value.a);
    }
    void set(const char* name, const Matrix4& value) const {
        gl_.UniformMatrix4fv(at(name), 1, GL_FALSE, value.data());
    }

private:
    [[nodiscard]] GLint at(const char* name) const { return gl_.GetUniformLocation(program_, name); }

    const GlFunctions& gl_;
    GLuint program_;
};

} // namespace toile::picture
