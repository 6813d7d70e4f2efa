// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/GarmentAccuracy.h"

#include <optional>
#include <vector>

namespace toile::ui {

/// Guesses how long a study of a garment still takes: finer meshes take longer, the second go as long as the first.
class TimeLeft {
public:
    explicit TimeLeft(const study::GarmentPlan& plan);

    [[nodiscard]] int goes() const { return static_cast<int>(goes_.size()); }
    /// The go of this index begins at that time [s]; those before it are over.
    void begin(int go, double now);
    /// [s]; absent before the first go is over.
    [[nodiscard]] std::optional<double> at(double now) const;

private:
    struct Go {
        double weight = 1;           ///< guessed, in runs of the coarsest position-based mesh [–]
        int earlier = -1;            ///< the same setup before; −1 = none
        std::optional<double> taken; ///< [s]
    };
    std::vector<Go> goes_;
    int current_ = -1;
    double start_ = 0; ///< of the current go [s]
};

} // namespace toile::ui
