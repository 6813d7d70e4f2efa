// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/geometry/VertexMotion.h"

#include <filesystem>

namespace toile::io {

/// The models in a folder in the order of their names, pose2 before pose10: the poses of a motion. Error: fewer than
/// two, or none can be looked for.
[[nodiscard]] Result<std::vector<std::filesystem::path>> posesIn(const std::filesystem::path& folder);

/// A motion of a body by the posesIn() a folder, each with the same vertices in
/// the same order. The first is the body as it stands: there its vertices are found by their places. step from pose
/// to pose [s]. Errors name the file: fewer than two poses, none that can be read, another number of vertices, a first
/// one that is not this body.
[[nodiscard]] Result<geometry::VertexMotion> readBodyPoses(const std::filesystem::path& folder, const body::Body& body,
                                                           double step);

} // namespace toile::io
