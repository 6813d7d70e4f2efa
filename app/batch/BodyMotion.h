// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"
#include "app/batch/Opening.h"
#include "core/geometry/VertexMotion.h"

#include <memory>

namespace toile::batch {

/// How the avatar is to move when the garment is worn; null if it is not. Errors name the file or the option.
[[nodiscard]] Result<std::shared_ptr<const geometry::VertexMotion>> bodyMotionOf(const SewOptions& options,
                                                                                 const OpenedScene& opened);

} // namespace toile::batch
