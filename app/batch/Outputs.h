// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace toile::batch {

/// A file, or a folder of files, that a run writes; an empty name is none.
struct Output {
    std::string file;
    std::vector<std::string> extensions = {}; ///< as extensionOf says them; it must have one of these; empty = any
    bool holdsFrames = false;                 ///< a point cache, or a folder
};

/// Whether the results of a run can be written, asked before the work begins: their folders exist and can be written
/// to, their names end as they may, none takes the place of a file that the run reads (of a folder: of a file in it) or
/// of another result. Empty names of inputs are none.
[[nodiscard]] Result<void> checkedOutputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs);

/// Whether two names are of one file, which need not exist: by another way, or through a link.
[[nodiscard]] bool areSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

} // namespace toile::batch
