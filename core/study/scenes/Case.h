// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/study/Repetitions.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Scenes with a goal for error and cost, and what is seen of them.
namespace toile::study::scenes {

/// What was seen of a run, beside what is wanted of it. SI.
struct Figure {
    std::string key; ///< of the record; the report has its title
    double seen = 0;
    std::optional<double> goal = {};      ///< at most so much
    std::optional<double> elsewhere = {}; ///< what another program reached, where that is no goal
    double rounding = 0;                  ///< half of the last digit that the goal was printed with

    [[nodiscard]] bool reached() const { return !goal || seen <= *goal + rounding; } // a NaN never is
};

/// One run of a scene.
struct Row {
    std::string what;
    std::vector<Figure> figures;
    RunTime time;        ///< CPU time of the run
    std::string note;    ///< beside it in the table
    std::string failure; ///< why there is nothing to see; else empty

    [[nodiscard]] bool hasGoal() const;
    [[nodiscard]] bool reached() const;
};

/// How a case is run.
struct Effort {
    int repetitions = 3; ///< of every timed run, in turns
    std::stop_token stop = {};
    Progress progress = {};
};

/// A scene and the ways it is run.
struct Case {
    std::string name, about;
    std::vector<std::string> runs; ///< "what" of its rows, in order
    std::function<Result<std::vector<Row>>(const Effort&)> run;
};

} // namespace toile::study::scenes
