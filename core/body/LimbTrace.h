// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/BodyProfile.h"

#include <optional>
#include <vector>

namespace toile::body {

// How the left limbs of a standing body run, read off its sections. A mirrored mesh gives the right ones. [m]

struct Shoulder {
    Vec3 acromion; ///< on the skin, where the line of the shoulder turns down into the arm
    Vec3 joint;    ///< in the middle of the arm's root
};
/// armpit: its height.
[[nodiscard]] std::optional<Shoulder> shoulderOf(const geometry::TriangleMesh& mesh, const BodyProfile& profile,
                                                 const Vec3& sideNeck, double armpit);

struct TracedArm {
    std::vector<Vec3> axis; ///< from the joint to past the hand
    Vec3 wrist;             ///< the middle of the thinnest section before the hand
};
[[nodiscard]] std::optional<TracedArm> armOf(const geometry::TriangleMesh& mesh, const BodyProfile& profile,
                                             const Vec3& joint);

struct TracedLeg {
    std::vector<Vec3> axis; ///< from the crotch's height to below the floor
    Vec3 ankle;             ///< the middle of the thinnest section above the foot
    bool facesFront = true; ///< the foot reaches farther from the ankle to +z than to −z
};
[[nodiscard]] std::optional<TracedLeg> legOf(const geometry::TriangleMesh& mesh, const BodyProfile& profile,
                                             double crotch);

} // namespace toile::body
