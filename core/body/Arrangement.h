// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/geometry/FrameAlong.h"

#include <optional>
#include <vector>

namespace toile::body {

/// How far the skin lies from a limb's line at one place.
struct ArrangementRing {
    double at = 0;    ///< along the frame's y [m]
    double side = 0;  ///< farthest along ±x of the frame [m]
    double front = 0; ///< farthest along +z [m]
    double back = 0;  ///< farthest along −z [m]
    friend bool operator==(const ArrangementRing&, const ArrangementRing&) = default;
};

/// The room a limb takes, round which pieces are placed.
struct ArrangementVolume {
    Limb limb = Limb::torso;
    Transform frame;                    ///< see limbFrame
    double length = 0;                  ///< of the limb along the frame's y [m]
    std::vector<ArrangementRing> rings; ///< with rising `at`, from 0 to length
    friend bool operator==(const ArrangementVolume&, const ArrangementVolume&) = default;
};

/// The right-handed, orthonormal frame of a limb; z to the front of the body.
/// Torso: y up, origin at the middle of the waist. Neck: y up the neck, origin between nape and pit of the
/// neck. Arms: y from the shoulder to the wrist, origin under the acromion. Legs: y from the hip down to the
/// ankle, origin at the height of the crotch. None if the body has no such limb.
[[nodiscard]] std::optional<Transform> limbFrame(const Body& body, Limb limb);

/// Length of a limb along its frame's y: torso waist to nape, neck base to crown, arm to the wrist, leg to
/// the ankle [m].
[[nodiscard]] double limbLength(const Body& body, Limb limb);

/// The middle line of an arm or a leg as a sleeve can follow it, from the root to past hand or foot: 10 mm apart, its
/// corners rounded over the length of a joint. None for neck and torso, and where the body has no such limb.
[[nodiscard]] std::optional<geometry::Polyline> limbLine(const Body& body, Limb limb);

/// Where along the line of a limb the wrist or the ankle lies [m].
[[nodiscard]] double limbLineLength(const Body& body, Limb limb, const geometry::Polyline& line);

/// The volumes of all limbs of a body; none for what is not human.
[[nodiscard]] std::vector<ArrangementVolume> arrangementVolumes(const Body& body);

/// Carries points round a limb of one body to the same limb of another: along the limb by the ratio of the
/// lengths, across it by the ratio of the sizes. An affine map; none if one of the bodies lacks the limb.
[[nodiscard]] std::optional<Transform> carriedOver(const Body& from, const Body& to, Limb limb);

/// How much larger the limb of `to` is across than that of `from` [–]: what the radius of a curled piece
/// grows by.
[[nodiscard]] std::optional<double> sizeRatio(const Body& from, const Body& to, Limb limb);

/// What carriedOver is for points, for the placement of a piece: its origin goes where carriedOver takes it,
/// its axes turn with the limb and keep their lengths.
[[nodiscard]] std::optional<Transform> placementCarriedOver(const Transform& placement, const Body& from,
                                                            const Body& to, Limb limb);

} // namespace toile::body
