// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

#include <optional>
#include <vector>

namespace toile::io {

enum class LengthUnit { metre, decimetre, centimetre, millimetre, inch };

/// Metres in one unit.
[[nodiscard]] double metresIn(LengthUnit unit);
/// "decimetres"
[[nodiscard]] const char* nameOf(LengthUnit unit);

/// A mesh in metres, and the unit it was taken to be in.
struct SizedMesh {
    geometry::TriangleMesh mesh;
    LengthUnit unit = LengthUnit::metre;
    std::vector<Warning> warnings;
    bool stoodUp = false; ///< it was lying on its back
};

/// Where a point of a body that lies on its back comes to be when it is stood up.
[[nodiscard]] Vec3 stoodUp(const Vec3& p);

/// Judges by the height of a standing adult, 1.2 to 2.3 m, which unit a file without one is in; a body that is lying on
/// its back because its file has z up is stood up. What was assumed is a warning. A file whose format says metres is
/// taken at its word, and refused with the unit that would fit when nobody is so tall.
[[nodiscard]] Result<SizedMesh> sizedAsBody(geometry::TriangleMesh mesh, bool formatSaysMetres,
                                            std::optional<LengthUnit> told);

/// Without any judgement.
[[nodiscard]] Result<SizedMesh> scaledToMetres(geometry::TriangleMesh mesh, LengthUnit unit);

} // namespace toile::io
