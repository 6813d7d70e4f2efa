// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/simulation/Frame.h"

#include "core/body/Landmarks.h"

#include <optional>
#include <string>
#include <vector>

namespace toile::batch {

/// Draws a frame on its body, one picture per file: seen from where the file's name says (front, back, left, right,
/// top), else from the front.
[[nodiscard]] Result<void> writePictures(const std::vector<std::string>& files, const simulation::Frame& frame,
                                         const std::optional<Shared<body::Body>>& body);

} // namespace toile::batch
