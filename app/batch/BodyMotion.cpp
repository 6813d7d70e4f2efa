// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/BodyMotion.h"

#include "core/body/ArmLift.h"
#include "core/io/BodyPoses.h"

namespace toile::batch {

Result<std::shared_ptr<const geometry::VertexMotion>> bodyMotionOf(const SewOptions& options,
                                                                   const OpenedScene& opened) {
    if (options.liftArms == 0 && options.motion.empty()) return nullptr;
    if (!opened.scene.body)
        return fail(ErrorCode::invalidInput, "There is no avatar that could move.", {.file = options.file});
    const body::Body& body = **opened.scene.body;
    auto motion = options.motion.empty() ? body::armLift(body, options.liftArms, options.liftTime)
                                         : io::readBodyPoses(options.motion, body, options.motionStep);
    if (!motion) return tl::unexpected(motion.error());
    return std::make_shared<const geometry::VertexMotion>(std::move(*motion));
}

} // namespace toile::batch
