// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::study {

/// CPU time of this thread [s].
[[nodiscard]] double threadSeconds();

/// CPU time of one loop over a million spring forces, the best of several [s]: times divided by it hold on
/// another machine too.
[[nodiscard]] double calibrationSeconds();

} // namespace toile::study
