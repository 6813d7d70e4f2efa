// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sew.h"
#include "core/study/Calibration.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

/// Cloth pressed flat on itself, to one side and back.
namespace toile::study::stability {
namespace {

using simulation::Simulation;

constexpr double width = 0.28, height = 0.12; // of the strip, flat [m]
constexpr double depth = 0.03;                // of a pleat: what lies under it [m]

pattern::Fold foldAt(int number, double x, double angle) {
    pattern::Fold fold;
    fold.id = pattern::FoldId(fmt::format("f{}", number));
    fold.name = fmt::format("fold {}", number);
    fold.ends = {{{pattern::EdgeId("e0"), x / width}, {pattern::EdgeId("e2"), 1 - x / width}}};
    fold.angle = angle;
    fold.stiffnessFactor = 5;
    return fold;
}

/// A weightless strip with knife pleats: each is folded back at one line and forward again at the next, and the first
/// line is tacked above to the place it then lies on.
simulation::Scene pleatedStrip(int pleats, double spacing) {
    simulation::Scene scene;
    scene.settings.gravity = {};
    scene.settings.selfContact = true;
    scene.pattern.fabrics.push_back(validation::plainCloth());
    pattern::Piece piece =
        validation::polygonPiece("strip", {{0, 0}, {width, 0}, {width, height}, {0, height}}, spacing);
    piece.placement = pattern::Placement{};
    for (int pleat = 0; pleat < pleats; ++pleat) {
        const double first = 0.06 + 0.1 * pleat;
        piece.folds.push_back(foldAt(2 * pleat + 1, first, -std::numbers::pi));
        piece.folds.push_back(foldAt(2 * pleat + 2, first + depth, std::numbers::pi));
        pattern::Tack tack;
        tack.id = pattern::TackId(fmt::format("t{}", pleat + 1));
        tack.name = fmt::format("pleat {}", pleat + 1);
        tack.ends = {{{piece.id, {first, height}}, {piece.id, {first + 2 * depth, height}}}};
        scene.pattern.tacks.push_back(std::move(tack));
    }
    scene.pattern.pieces.push_back(std::move(piece));
    return scene;
}

Findings s32KnifePleats(const Effort& effort) {
    constexpr double degree = std::numbers::pi / 180, tolerance = 20; // [°]
    const double start = threadSeconds();
    auto simulation = Simulation::create(pleatedStrip(2, effort.quick ? 0.015 : 0.01));
    if (!simulation) return {{tested("S32", "knife pleats", false, simulation.error().text)}, {}};
    const auto report = simulation::sew(*simulation, {.seconds = 6});
    Metrics metrics;
    metrics.seconds = threadSeconds() - start;
    if (!report) return {{tested("S32", "knife pleats", false, report.error().text, metrics)}, {}};
    double worst = 0; // [°]
    for (const simulation::FoldReport& fold : report->folds)
        worst = std::max(worst, std::abs(std::remainder(fold.mean - fold.restAngle, 2 * std::numbers::pi)) / degree);
    const int crossings = report->contact.selfIntersections;
    const std::string why = !report->allTacked()   ? "A pleat is not held."
                            : crossings > 0        ? "The cloth crosses itself."
                            : !(worst < tolerance) ? fmt::format("A fold is off by more than {}°.", tolerance)
                                                   : "";
    return {{tested("S32",
                    fmt::format("two knife pleats, {} particles: folds within {:.0f}° of 180°, {} intersections",
                                report->particles, worst, crossings),
                    why.empty(), why, metrics)},
            {}};
}

} // namespace

std::vector<Case> pleatCases() {
    return {{"S32", "knife pleats", s32KnifePleats}};
}

} // namespace toile::study::stability
