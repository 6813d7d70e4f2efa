// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"

#include <filesystem>
#include <vector>

namespace toile::batch {

/// A document's scene with its body.
struct OpenedScene {
    simulation::Scene scene;
    std::string avatar; ///< path of the body file; empty = none
    std::vector<Warning> warnings;
};

/// The scene of a document on the avatar it names, or on another one: then each piece starts beside the same limb of
/// the other body. Without an avatar the scene has no body.
[[nodiscard]] Result<OpenedScene> openScene(const document::Document& document,
                                            const std::filesystem::path& documentFile,
                                            const std::filesystem::path& otherAvatar = {});

} // namespace toile::batch
