// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/simulation/Frame.h"

#include <filesystem>
#include <memory>
#include <span>

namespace toile::io {

/// Keeps the frames of a run as they come, for programs that play them. docs/formats/frames.md
class FrameFiles {
public:
    /// Whether `create` would do, asked before long work; makes nothing.
    [[nodiscard]] static Result<void> checkWritable(const std::filesystem::path& path);
    /// A path that ends in .pc2 is one point cache; any other is a folder, made if it is not there, for one
    /// .obj a frame. Errors: the file or folder cannot be written; there is a folder that ends in .pc2; the folder
    /// holds frames already, so that none of an older run stay behind the new ones.
    [[nodiscard]] static Result<std::unique_ptr<FrameFiles>> create(const std::filesystem::path& path,
                                                                    Shared<simulation::FrameTopology> topology);
    virtual ~FrameFiles() = default;

    /// positions: of the topology's vertices [m].
    [[nodiscard]] virtual Result<void> add(std::span<const Vec3> positions) = 0;
    /// Makes the whole visible under its name. Without it a point cache leaves nothing behind.
    [[nodiscard]] virtual Result<void> finish() = 0;
};

} // namespace toile::io
