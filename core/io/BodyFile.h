// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/BodyImport.h"

namespace toile::io {

/// What a file of a body holds: a whole body if we wrote it, else only its surface.
struct BodyFile {
    std::optional<body::Body> body;
    geometry::TriangleMesh mesh; ///< empty when there is a body
};

[[nodiscard]] Result<BodyFile> readBodyFile(const std::filesystem::path& path, const BodyImportSettings& settings,
                                            std::vector<Warning>* warnings);

/// Whether its name is that of a format that bodies are read from.
[[nodiscard]] bool isBodyFile(const std::filesystem::path& path);

/// How a file's numbers become metres with y up.
struct PoseReading {
    LengthUnit unit = LengthUnit::metre;
    bool stoodUp = false;
};

/// The vertices of a body as the file has them, not welded, so that those of two poses are in the same order.
struct PoseFile {
    std::vector<Vec3> vertices; ///< [m]
    PoseReading reading;
};

/// reading: as another pose of this body was read; absent = judged by this one, which then stands upright.
[[nodiscard]] Result<PoseFile> readPose(const std::filesystem::path& path, std::optional<PoseReading> reading);

} // namespace toile::io
