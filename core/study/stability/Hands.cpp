// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"
#include "core/study/Calibration.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"

#include <algorithm>
#include <fmt/format.h>
#include <stop_token>

/// What a user does to running cloth.
namespace toile::study::stability {
namespace {

using simulation::Simulation;

/// Two squares, sewn together, at rest, without gravity.
Result<Simulation> sewnSquares() {
    simulation::Scene scene = validation::twoSquares();
    scene.settings.damping = 5; // what rings dies away within the time that is looked at [1/s]
    auto made = Simulation::create(scene);
    if (!made) return made;
    while (made->steps() < 300) // its seam is closed after 35, but it is stretched by that
        if (const auto done = made->advance(); !done) return tl::unexpected(done.error());
    return made;
}

Findings s27HugeDrag(const Effort&) {
    const double start = threadSeconds();
    auto simulation = sewnSquares();
    if (!simulation) return {{tested("S27", "two squares", false, simulation.error().text)}, {}};
    const auto stretch = [&] { return stretchOf(simulation->garment().model, simulation->state().positions); };
    const double before = stretch();
    Metrics metrics{.speed = 0, .strain = 0};
    std::string stopped;
    const auto go = [&](int frames) {
        for (int frame = 0; frame < frames && stopped.empty(); ++frame) {
            if (const auto done = simulation->advance(); !done) stopped = done.error().text;
            metrics.speed = std::max(*metrics.speed, simulation->largestSpeed());
            metrics.strain = std::max(*metrics.strain, stretch());
        }
    };
    simulation->hold({{.piece = "left", .material = {0, 0}, .target = {10, 1, 0}}});
    go(30);
    simulation->hold({});
    go(120);
    metrics.seconds = threadSeconds() - start;
    constexpr double recovered = 0.01; // [–]
    const double left = stretch() - before;
    if (stopped.empty() && left > recovered) stopped = "It does not go back to its size.";
    return {
        {tested("S27",
                fmt::format("a corner dragged by 10 m in a frame, let go after half a second: stretch left {:.1g} %",
                            100 * left),
                stopped.empty(), stopped, metrics)},
        {}};
}

Findings s27InterruptedStep(const Effort&) {
    auto simulation = sewnSquares(), other = sewnSquares();
    if (!simulation || !other) return {{tested("S27", "two squares", false, "They cannot be sewn.")}, {}};
    std::stop_source stop;
    stop.request_stop();
    const bool cancelled = !simulation->advance(stop.get_token());
    const bool untouched = simulation->state().positions == other->state().positions;
    const bool goesOn = simulation->advance() && other->advance();
    const bool same = goesOn && simulation->state().positions == other->state().positions;
    return {{tested("S27", "a step that is stopped, and made again", cancelled && untouched && same,
                    !cancelled   ? "It was not stopped."
                    : !untouched ? "It left something behind."
                                 : "It goes on otherwise than one that was never stopped.")},
            {}};
}

} // namespace

std::vector<Case> handCases() {
    return {{"S27", "huge drag", s27HugeDrag}, {"S27", "interrupted step", s27InterruptedStep}};
}

} // namespace toile::study::stability
