// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

#include <string>
#include <string_view>

namespace toile::io {

/// Positions and faces of a PLY file, ASCII or binary little-endian; polygons are cut into fans, everything else in the
/// file is skipped. Counts are held against the length of the file before memory is taken.
/// Ref: Turk 1994, The PLY polygon file format.
[[nodiscard]] Result<geometry::TriangleMesh> meshFromPly(std::string_view bytes, const std::string& file = {});

} // namespace toile::io
