// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Front.h"

#include <string>
#include <vector>

namespace toile::study {

/// Runs that belong together, in the order in which they are joined by a line.
struct PlotCurve {
    struct Point {
        double cost = 0, error = 0, label = 0; ///< label: step or spacing, in the data only where the axes are long
    };
    std::string title;
    std::vector<Point> points;
    int colour = -1;     ///< number of a colour; −1 = one of its own
    bool dashed = false; ///< a line as of another family
};

/// Error over run time, both axes logarithmic.
struct ErrorTimePlot {
    std::string title, costLabel, errorLabel;
    std::vector<PlotCurve> curves;
    std::vector<CostError> front;
    double band = 0; ///< grey up to this error: nothing below it is told apart
    /// A decade or two: tics at 1, 2 and 5, axes that end near the points, and labels beside these.
    bool narrow = false;
};

/// A gnuplot script that draws it as `file`.svg and `file`.png.
[[nodiscard]] std::string gnuplotScript(const ErrorTimePlot& plot, const std::string& file);

} // namespace toile::study
