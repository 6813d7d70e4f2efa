// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Regions.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace toile::study {
namespace {

enum class Kept { all, time }; ///< of a go: its shape is wanted once

/// All goes of a study: run now, or kept from before.
struct Goes {
    const pattern::Pattern& drawn;
    const simulation::SewSettings& sewing;
    std::stop_token stop;
    const LayoutKeeper& keeper;

    [[nodiscard]] Result<LayoutGo> go(const Layout& layout, const std::string& which, Kept kept) const {
        const auto run = [&] {
            auto go = drapedBy(layout, drawn, sewing, stop);
            if (go && kept == Kept::time) {
                go->lattice.clear();
                go->parts.clear();
            }
            return go;
        };
        if (!keeper) return run();
        Json of, method, key;
        of.set("layout", std::string(nameOf(layout.kind))).set("spacing", layout.spacing).set("go", which);
        method.set("integrator", std::string(dynamics::nameOf(dynamics::Method::xpbd)));
        return keeper(key.set("scene", of).set("method", method), run);
    }
};

/// What is known of one layout.
struct Attempt {
    std::optional<LayoutResult> result; ///< of the first run; the others are the same bits again
    DrapedLattice lattice;
    std::vector<double> seconds;
    std::string whyNot;
};

} // namespace

const LayoutResult* RegionsStudy::find(LayoutKind kind) const {
    const auto found = std::ranges::find(layouts, kind, &LayoutResult::kind);
    return found == layouts.end() ? nullptr : &*found;
}

Result<RegionsStudy> studyRegions(const simulation::Scene& scene, const RegionsSettings& settings, std::stop_token stop,
                                  const Progress& progress, const LayoutKeeper& keeper) {
    const auto finest = finestSpacing(scene.pattern);
    if (!finest)
        return fail(ErrorCode::invalidInput, "The pattern has no region that is finer than its piece: there is nothing "
                                             "to compare. Paint one and give it a refinement.");
    const Goes goes{scene.pattern, settings.sewing, stop, keeper};
    RegionsStudy study{.repetitions = settings.repetitions};
    std::map<LayoutKind, Attempt> attempts;
    const double runs = static_cast<double>(layoutKinds.size()) * settings.repetitions + 2;
    double run = 0;
    const auto runOne = [&](std::size_t i, int repetition) -> Result<void> {
        const LayoutKind kind = layoutKinds[i];
        Attempt& attempt = attempts[kind];
        report(progress, run++ / runs, std::string(nameOf(kind)));
        if (!attempt.whyNot.empty()) return {};
        const Layout layout = kind == LayoutKind::asManyPoints
                                  ? asManyPoints(scene, attempts[LayoutKind::coarse].result->particles,
                                                 attempts[LayoutKind::regions].result->particles)
                                  : layoutOf(scene, kind);
        auto go =
            goes.go(layout, fmt::format("repetition {}", repetition + 1), attempt.result ? Kept::time : Kept::all);
        const bool mayFail = kind == LayoutKind::paper || kind == LayoutKind::elsewhere;
        if (!go && mayFail && go.error().code != ErrorCode::cancelled) {
            attempt.whyNot = go.error().text;
            return {};
        }
        if (!go) return tl::unexpected(go.error());
        attempt.seconds.push_back(go->seconds);
        if (attempt.result) return {};
        attempt.result = std::move(go->result);
        attempt.lattice = std::move(go->lattice);
        if (kind == LayoutKind::fine) study.parts = std::move(go->parts);
        return {};
    };
    if (auto done = inTurns(layoutKinds.size(), settings.repetitions, runOne); !done)
        return tl::unexpected(done.error());

    constexpr double closerLines = 0.96;
    const auto reference = [&](double spacing, const char* which) {
        return goes.go(uniformLayout(scene, LayoutKind::fine, spacing), which, Kept::all);
    };
    DrapedLattice lattice = attempts[LayoutKind::fine].lattice;
    study.reference = *attempts[LayoutKind::fine].result;
    if (settings.referenceSpacing != *finest) { // else the reference is the uniform fine mesh
        report(progress, run / runs, "reference");
        auto go = reference(settings.referenceSpacing, "reference");
        if (!go) return tl::unexpected(go.error());
        study.reference = std::move(go->result);
        lattice = std::move(go->lattice);
    }
    report(progress, (run + 1) / runs, "reference again");
    const auto again = reference(closerLines * settings.referenceSpacing, "reference again");
    if (!again) return tl::unexpected(again.error());
    const LatticeDifference floor = differenceOf(again->lattice, lattice);
    study.floor = floor.rms;
    study.points = floor.points;
    for (const LayoutKind kind : layoutKinds) {
        Attempt& attempt = attempts[kind];
        if (!attempt.result) {
            study.notRun.push_back({kind, attempt.whyNot});
            continue;
        }
        const LatticeDifference difference = differenceOf(attempt.lattice, lattice);
        attempt.result->rms = difference.rms;
        attempt.result->maximum = difference.maximum;
        attempt.result->time = runTimeOf(attempt.seconds);
        study.layouts.push_back(std::move(*attempt.result));
    }
    return study;
}

} // namespace toile::study
