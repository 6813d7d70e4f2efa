// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::batch {

/// "68978ba", or "68978ba-dirty-1f2e3d4c" where something of the program differs from this commit: the same digits, the
/// same difference. Looked up at every build; empty where there is no git.
[[nodiscard]] const char* commitOfBuild();

} // namespace toile::batch
