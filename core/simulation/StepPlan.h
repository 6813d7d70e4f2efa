// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"

#include <memory>
#include <string>
#include <vector>

namespace toile::simulation {

/// A part of the step that this scene does not need, and why.
struct LeftOut {
    std::string stage, why;
    double saved = 0; ///< wall time, where it is known [s]; of stages `toile-cli study lean` measures it
    friend bool operator==(const LeftOut&, const LeftOut&) = default;
};

/// What a step of this scene does, in order. Only what is listed is built; the rest is named with the reason.
class StepPlan {
public:
    StepPlan();
    StepPlan(StepPlan&&) noexcept;
    StepPlan& operator=(StepPlan&&) noexcept;
    ~StepPlan();

    /// Appends a stage; its time is counted from now on.
    void add(std::unique_ptr<dynamics::Stage> stage);
    void leaveOut(std::string stage, std::string why);

    [[nodiscard]] std::span<dynamics::Stage* const> stages() const { return order_; }
    [[nodiscard]] const std::vector<LeftOut>& leftOut() const { return leftOut_; }
    [[nodiscard]] dynamics::Stage* find(std::string_view name) const;

    struct StageCost {
        std::string name;
        double seconds = 0;    ///< spent in this stage
        std::size_t bytes = 0; ///< held now
        int heldBack = 0;      ///< substeps
    };
    [[nodiscard]] std::vector<StageCost> costs() const;

    /// While this lives, no time is counted.
    class OffTheClock {
    public:
        explicit OffTheClock(StepPlan& plan);
        ~OffTheClock();
        OffTheClock(const OffTheClock&) = delete;
        OffTheClock& operator=(const OffTheClock&) = delete;

    private:
        StepPlan& plan_;
    };

private:
    class Timed;
    std::vector<std::unique_ptr<Timed>> owned_;
    std::vector<dynamics::Stage*> order_;
    std::vector<LeftOut> leftOut_;
};

} // namespace toile::simulation
