// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/pattern/Pattern.h"
#include "core/study/Circumstances.h"

#include <array>
#include <string>
#include <vector>

namespace toile::study {

/// Part of a piece's extent that is meshed at half its spacing: 0 is its left or lower end, 1 its right or upper one.
struct FineBox {
    std::string piece; ///< name or id
    double left = 0, bottom = 0, right = 1, top = 1;
};

/// The pattern with these boxes for regions instead of its own. Where a box reaches an end of the piece it covers the
/// border there. Errors: a piece that is not there, or takes its regions from the one it mirrors; a box without area.
[[nodiscard]] Result<pattern::Pattern> withFineBoxes(const pattern::Pattern& pattern,
                                                     const std::vector<FineBox>& boxes);

/// A garment meshed in one way, and its cloth before any seam is merged.
struct StorageLayout {
    std::string name;
    double spacing = 0;        ///< the least of it [m]
    int nodes = 0, slaves = 0; ///< slaves are nodes too
    int cells = 0;             ///< rectangles, pairs of triangles and single triangles
    int springs = 0;           ///< structural and shear
    int bending = 0;           ///< three-point elements, twist and flat hinges
    int membranes = 0;         ///< membrane triangles and cells
    std::size_t meshBytes = 0, clothBytes = 0;
};

struct StorageStudy {
    StorageLayout coarse, regions, fine; ///< uniform at the main spacing; as painted; uniform at the finest
    double fineShare = 0;                ///< of the garment's area that is painted finer [–]
};

/// What finer regions save: nodes, springs and bytes against uniform meshes. Pieces finer than the finest region stay
/// as they are in all three.
/// Errors: a pattern without a finer region, what the mesher and the cloth refuse.
[[nodiscard]] Result<StorageStudy> studyStorage(const pattern::Pattern& pattern);

/// What the painted areas alone would come to: nodes of the regions over those of the uniform fine mesh [–].
[[nodiscard]] double idealShare(const StorageStudy& study);

/// The table and what it shows, in Markdown.
[[nodiscard]] std::string storageText(const StorageStudy& study, const std::string& document,
                                      const Circumstances& circumstances);

/// One record a layout.
[[nodiscard]] std::vector<Json> recordsOf(const StorageStudy& study, const std::string& document,
                                          const Circumstances& circumstances);

} // namespace toile::study
