// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/simulation/Inspect.h"

#include <optional>
#include <string>

namespace toile::simulation {

/// How many frames of a run show cloth in the body, or in itself.
struct FrameTally {
    struct Kind {
        int frames = 0;             ///< that show any
        int most = 0;               ///< pairs of triangles in one frame
        std::optional<double> last; ///< time of the last that shows any [s]

        void add(double time, int pairs);
    };
    int frames = 0;
    Kind withBody, withItself;
    Kind atOpenSeams; ///< cloth beside a seam that closes

    /// seen: in the frame of this time [s].
    void add(double time, Intersections seen);
};

/// A sentence.
[[nodiscard]] std::string describe(const FrameTally& tally);

/// docs/formats/sew.md, under "frames".
[[nodiscard]] Json toJson(const FrameTally& tally);

} // namespace toile::simulation
