// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::batch {

/// What a bug report needs to know of this binary.
struct BuildFacts {
    std::string version, commit, compiler, buildType, flags;
};
[[nodiscard]] BuildFacts buildFacts();

/// The facts with the libraries' versions, as `--version` prints them.
[[nodiscard]] std::string versionText(const std::string& program);

} // namespace toile::batch
