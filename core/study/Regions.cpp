// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Regions.h"

#include "core/base/Contracts.h"
#include "core/study/Calibration.h"
#include "core/study/DrapedLattice.h"
#include "core/study/EachPiece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace toile::study {
namespace {

using pattern::Pattern;
using simulation::Scene;

double leastSpacing(const Pattern& pattern) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& piece : pattern.pieces) least = std::min(least, piece->spacing);
    return least;
}

Scene withPattern(Scene scene, Pattern pattern) {
    scene.pattern = std::move(pattern);
    return scene;
}

Scene uniformAt(const Scene& scene, double spacing) {
    return withPattern(scene, uniformCoarser(scene.pattern, spacing / leastSpacing(scene.pattern)));
}

/// Every region moved along the length of its piece to the farther end.
Pattern movedAway(const Pattern& pattern) {
    return eachPiece(pattern, [](pattern::Piece& piece) {
        std::vector<Vec2> corners;
        for (const auto& vertex : piece.outline.vertices) corners.push_back(vertex.position);
        const geometry::Box2 extent = geometry::boundsOf(corners);
        const Vec2 size = extent.high - extent.low;
        const auto along = [&](Vec2 v) { return size.y >= size.x ? Vec2{0, v.y} : Vec2{v.x, 0}; };
        const auto within = [&](Vec2 p) {
            return Vec2{std::clamp(p.x, extent.low.x, extent.high.x), std::clamp(p.y, extent.low.y, extent.high.y)};
        };
        for (auto& region : piece.regions) {
            for (Vec2& point : region.outline) point = within(point); // what lies beyond the piece would come in
            const geometry::Box2 own = geometry::boundsOf(region.outline);
            const Vec2 down = along(extent.low - own.low), up = along(extent.high - own.high);
            const Vec2 way = length(down) >= length(up) ? down : up;
            for (Vec2& point : region.outline) point += way;
            for (geometry::Polygon& hole : region.holes)
                for (Vec2& point : hole) point += way;
        }
    });
}

/// A garment at rest and what it took.
struct Drape {
    simulation::Simulation simulation;
    LayoutResult result;
    double seconds = 0; ///< CPU time of sewing
};

Result<Drape> draped(const Layout& layout, const simulation::SewSettings& settings, std::stop_token stop) {
    auto simulation = simulation::Simulation::create(layout.scene);
    if (!simulation) return tl::unexpected(simulation.error());
    const double start = threadSeconds();
    const auto report = simulation::sew(*simulation, settings, stop);
    if (!report) return tl::unexpected(report.error());
    const double seconds = threadSeconds() - start;
    LayoutResult result{.kind = layout.kind, .spacing = layout.spacing};
    result.particles = report->particles;
    result.springs = report->springsStructural + report->springsShear + report->bending + report->twist;
    for (const auto& stage : report->stages) result.bytes += stage.bytes;
    result.time = runTimeOf({seconds});
    result.atRest = report->atRest;
    result.energy = report->gravityEnergy + report->elasticEnergy;
    result.strain = report->strain;
    return Drape{std::move(*simulation), std::move(result), seconds};
}

/// What is known of one layout.
struct Attempt {
    std::optional<LayoutResult> result; ///< of the first run; the others are the same bits again
    DrapedLattice lattice;
    std::vector<double> seconds;
    std::string whyNot;
};

} // namespace

std::string_view nameOf(LayoutKind kind) {
    switch (kind) {
    case LayoutKind::coarse: return "uniform coarse";
    case LayoutKind::regions: return "regions";
    case LayoutKind::paper: return "regions, the paper's rule";
    case LayoutKind::elsewhere: return "regions in a wrong place";
    case LayoutKind::asManyPoints: return "uniform, as many particles";
    case LayoutKind::fine: break;
    }
    return "uniform fine";
}

bool isUniform(LayoutKind kind) {
    return kind == LayoutKind::coarse || kind == LayoutKind::asManyPoints || kind == LayoutKind::fine;
}

const LayoutResult* RegionsStudy::find(LayoutKind kind) const {
    const auto found = std::ranges::find(layouts, kind, &LayoutResult::kind);
    return found == layouts.end() ? nullptr : &*found;
}

std::optional<double> finestSpacing(const Pattern& pattern) {
    std::optional<double> finest;
    for (const auto& piece : pattern.pieces)
        for (const auto& region : piece->regions)
            if (region.refinement > 0)
                finest = std::min(finest.value_or(std::numeric_limits<double>::infinity()),
                                  std::ldexp(piece->spacing, -region.refinement));
    return finest;
}

Layout layoutOf(const Scene& scene, LayoutKind kind) {
    const auto finest = finestSpacing(scene.pattern);
    expects(finest && kind != LayoutKind::asManyPoints, "a layout that regions alone decide");
    const double main = leastSpacing(scene.pattern);
    const auto byPapersRule = [](pattern::Piece& piece) { piece.rule = pattern::LineRule::paper; };
    switch (kind) {
    case LayoutKind::coarse: return {kind, uniformAt(scene, main), main};
    case LayoutKind::paper: return {kind, withPattern(scene, eachPiece(scene.pattern, byPapersRule)), *finest};
    case LayoutKind::elsewhere: return {kind, withPattern(scene, movedAway(scene.pattern)), *finest};
    case LayoutKind::fine: return {kind, uniformAt(scene, *finest), *finest};
    case LayoutKind::regions:
    case LayoutKind::asManyPoints: break;
    }
    return {kind, scene, *finest};
}

Layout asManyPoints(const Scene& scene, int coarse, int regions) {
    const double spacing = leastSpacing(scene.pattern) * std::sqrt(static_cast<double>(coarse) / regions);
    return {LayoutKind::asManyPoints, uniformAt(scene, spacing), spacing};
}

Result<RegionsStudy> studyRegions(const Scene& scene, const RegionsSettings& settings, std::stop_token stop,
                                  const Progress& progress) {
    const auto finest = finestSpacing(scene.pattern);
    if (!finest)
        return fail(ErrorCode::invalidInput, "The pattern has no region that is finer than its piece: there is nothing "
                                             "to compare. Paint one and give it a refinement.");
    RegionsStudy study{.repetitions = settings.repetitions};
    std::map<LayoutKind, Attempt> attempts;
    const double runs = static_cast<double>(layoutKinds.size()) * settings.repetitions + 2;
    double run = 0;
    const auto runOne = [&](std::size_t i, int) -> Result<void> {
        const LayoutKind kind = layoutKinds[i];
        Attempt& attempt = attempts[kind];
        report(progress, run++ / runs, std::string(nameOf(kind)));
        if (!attempt.whyNot.empty()) return {};
        const Layout layout = kind == LayoutKind::asManyPoints
                                  ? asManyPoints(scene, attempts[LayoutKind::coarse].result->particles,
                                                 attempts[LayoutKind::regions].result->particles)
                                  : layoutOf(scene, kind);
        const auto drape = draped(layout, settings.sewing, stop);
        const bool mayFail = kind == LayoutKind::paper || kind == LayoutKind::elsewhere;
        if (!drape && mayFail && drape.error().code != ErrorCode::cancelled) {
            attempt.whyNot = drape.error().text;
            return {};
        }
        if (!drape) return tl::unexpected(drape.error());
        attempt.seconds.push_back(drape->seconds);
        if (attempt.result) return {};
        attempt.result = drape->result;
        attempt.lattice = latticeOf(drape->simulation);
        if (kind == LayoutKind::fine) study.parts = deformationOf(drape->simulation, scene.pattern);
        return {};
    };
    if (auto done = inTurns(layoutKinds.size(), settings.repetitions, runOne); !done)
        return tl::unexpected(done.error());

    constexpr double closerLines = 0.96;
    const auto uniform = [&](double spacing) { return Layout{LayoutKind::fine, uniformAt(scene, spacing), spacing}; };
    DrapedLattice reference = attempts[LayoutKind::fine].lattice;
    study.reference = *attempts[LayoutKind::fine].result;
    if (settings.referenceSpacing != *finest) { // else the reference is the uniform fine mesh
        report(progress, run / runs, "reference");
        const auto drape = draped(uniform(settings.referenceSpacing), settings.sewing, stop);
        if (!drape) return tl::unexpected(drape.error());
        study.reference = drape->result;
        reference = latticeOf(drape->simulation);
    }
    report(progress, (run + 1) / runs, "reference again");
    const auto again = draped(uniform(closerLines * settings.referenceSpacing), settings.sewing, stop);
    if (!again) return tl::unexpected(again.error());
    const LatticeDifference floor = differenceOf(latticeOf(again->simulation), reference);
    study.floor = floor.rms;
    study.points = floor.points;
    for (const LayoutKind kind : layoutKinds) {
        Attempt& attempt = attempts[kind];
        if (!attempt.result) {
            study.notRun.push_back({kind, attempt.whyNot});
            continue;
        }
        const LatticeDifference difference = differenceOf(attempt.lattice, reference);
        attempt.result->rms = difference.rms;
        attempt.result->maximum = difference.maximum;
        attempt.result->time = runTimeOf(attempt.seconds);
        study.layouts.push_back(std::move(*attempt.result));
    }
    return study;
}

} // namespace toile::study
