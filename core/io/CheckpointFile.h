// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/simulation/Checkpoint.h"

namespace toile::io {

/// A simulation's checkpoint as a JSON text (docs/formats/checkpoint.md). Numbers read back as they were, bit by bit.
[[nodiscard]] Result<void> writeCheckpoint(const simulation::Checkpoint& checkpoint, const std::string& path);
/// Errors name the file and the field.
[[nodiscard]] Result<simulation::Checkpoint> readCheckpoint(const std::string& path);

} // namespace toile::io
