// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

#include <span>
#include <string>
#include <string_view>

namespace toile::io {

/// The two chunks of a binary glTF 2.0 file.
struct GlbFile {
    Json json;
    std::string binary;
};

/// Takes a file apart; the lengths it states are checked against its own.
[[nodiscard]] Result<GlbFile> parseGlb(std::string_view bytes, const std::string& file = {});
[[nodiscard]] std::string toBytes(const GlbFile& glb);

/// Puts arrays into the binary chunk of a file being made and returns the index of their accessor. Positions and other
/// reals become floats: a body of 2 m is rounded by at most 0.12 µm.
class GlbArrays {
public:
    [[nodiscard]] int add(std::span<const Vec3> values, bool withBounds = false);
    [[nodiscard]] int add(std::span<const Vec2> values);
    [[nodiscard]] int add(std::span<const geometry::TriangleIndices> triangles, int firstVertex = 0);
    /// Adds `accessors`, `bufferViews` and `buffers` to the JSON and gives the whole file.
    [[nodiscard]] GlbFile finish(Json json) &&;

private:
    int addAccessor(std::string_view bytes, int componentType, std::size_t count, const char* type, int target);

    std::string binary_;
    Json::Array accessors_, views_;
};

/// The triangles of the first mesh's first primitive, if they are stored as we store them: floats and 32-bit indices
/// in plain buffer views. Everything is checked against the length of the binary chunk.
[[nodiscard]] Result<geometry::TriangleMesh> firstMesh(const GlbFile& glb, const std::string& file = {});

} // namespace toile::io
