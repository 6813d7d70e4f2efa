// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"
#include "core/io/ChildProcess.h"

#include <filesystem>
#include <vector>

namespace toile::io {

struct ImportedMesh {
    geometry::TriangleMesh mesh; ///< as stored: not welded, in the file's unit (metres where the format has one)
    std::vector<Warning> warnings;
};

/// All triangles of a model file, with the transforms of its nodes, through assimp in a child process: its readers
/// crash, hang and abort on damaged files. FBX comes in metres with y up. If one of several parts is called "body",
/// only that part is taken.
[[nodiscard]] Result<ImportedMesh> meshThroughAssimp(const std::filesystem::path& path, const ChildLimits& limits = {});

} // namespace toile::io
