// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/simulation/BodyPins.h"
#include "core/simulation/Garment.h"
#include "core/simulation/Grips.h"
#include "core/simulation/MeetingPieces.h"
#include "core/simulation/Phase.h"
#include "core/simulation/Scene.h"
#include "core/simulation/SeamClosing.h"
#include "core/simulation/StepPlan.h"
#include "core/simulation/Tacks.h"

namespace toile::simulation {

/// How a garment is being put on.
struct DressingNow {
    Phase phase = Phase::sewing;
    std::vector<SeamPair> pairs;        ///< of seams being closed
    std::span<const TackState> tacks;   ///< those of the pattern
    std::span<const PiecePair> meeting; ///< pieces that meet where they are placed
};

/// What one step of this scene does: read from top to bottom. awake is what of the garment moves; body may be null;
/// grips are what hands hold; positions those of the particles now [m]; carried is null unless the body moves and cloth
/// is pinned to it. Stages that are forced are built although the scene has no use for them: "wind", "pressure",
/// "strain damping", "seams", "tacks", "hands", "strain limit", "seams that meet", "self-contact".
[[nodiscard]] StepPlan planOf(const Scene& scene, const Garment& garment, const Garment& awake,
                              const collision::BodySurface* body, std::unique_ptr<BodyPins> carried, DressingNow now,
                              std::shared_ptr<const std::vector<Grip>> grips, std::span<const Vec3> positions,
                              std::span<const std::string> forced);

} // namespace toile::simulation
