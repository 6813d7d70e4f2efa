// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/Workbench.h"

namespace toile::ui {

/// The workbench's parts as the program has them: files of core/io, the mesher, the runner.
[[nodiscard]] WorkbenchParts realParts(const QString& recoveryFolder);

/// A drape as core/io writes it.
[[nodiscard]] Result<void> writeDrapeOf(const std::string& file, const simulation::Frame& frame);

} // namespace toile::ui
