// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/scenes/Drapes.h"

#include "core/base/CpuTime.h"
#include "core/simulation/Inspect.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::study::scenes {
namespace {

using simulation::Simulation;

/// The worst of all frames that were looked at.
struct Seen {
    int particles = 0, openSeams = 0, particlesInside = 0, bodyIntersections = 0, selfIntersections = 0;
    std::string stages; ///< and their shares of the time
};

int particlesInside(const Simulation& simulation) {
    constexpr double searchRadius = 0.2; // [m]: nothing is deeper in our bodies
    if (!simulation.body()) return 0;
    return static_cast<int>(std::ranges::count_if(simulation.state().positions, [&](const Vec3& x) {
        const auto nearest = simulation.body()->nearest(x, searchRadius);
        return nearest && nearest->signedDistance < 0;
    }));
}

void look(const Simulation& simulation, Seen& seen) {
    const simulation::ContactSummary contact = simulation::contactOf(simulation);
    seen.particlesInside = std::max(seen.particlesInside, particlesInside(simulation));
    seen.bodyIntersections = std::max(seen.bodyIntersections, contact.bodyIntersections);
    seen.selfIntersections = std::max(seen.selfIntersections, contact.selfIntersections);
}

/// "cloth 60 %, self-contact 30 %": what has a twentieth of the time at least.
std::string sharesOf(const Simulation& simulation) {
    double all = 0;
    std::vector<std::string> shares;
    for (const auto& stage : simulation.stageCosts()) all += stage.seconds;
    for (const auto& stage : simulation.stageCosts())
        if (stage.seconds > 0.05 * all)
            shares.push_back(fmt::format("{} {:.0f} %", stage.name, 100 * stage.seconds / all));
    return fmt::format("{}", fmt::join(shares, ", "));
}

/// Of the progress of a case.
struct Share {
    double from = 0, of = 1;
};

/// Runs it once; the time for looking is not counted.
Result<Seen> run(const DrapeScene& what, const Effort& effort, const Share& share, std::vector<double>& seconds) {
    Seen seen;
    double start = processSeconds(), spent = 0;
    auto simulation = Simulation::create(what.scene, {.spacing = what.spacing});
    if (!simulation) return tl::unexpected(simulation.error());
    while (simulation->state().time < what.seconds - 1e-9) {
        if (auto done = simulation->advance(effort.stop); !done) return tl::unexpected(done.error());
        spent += processSeconds() - start;
        const double part = simulation->state().time / what.seconds;
        report(effort.progress, share.from + share.of * part,
               fmt::format("{}: {:.2f} s", what.name, simulation->state().time));
        if (what.everyFrame || part >= 1 - 1e-9) look(*simulation, seen);
        start = processSeconds();
    }
    seconds.push_back(spent);
    seen.particles = simulation->garment().particles.particleCount;
    seen.openSeams = static_cast<int>(std::ranges::count(simulation->seams(), false, &simulation::SeamState::merged));
    seen.stages = sharesOf(*simulation);
    return seen;
}

std::string whatOf(const DrapeScene& scene) {
    return fmt::format("{:g} s, seen {}", scene.seconds, scene.everyFrame ? "after every frame" : "at the end");
}

Result<std::vector<Row>> rowsOf(const DrapeScene& scene, const Effort& effort) {
    std::vector<double> seconds;
    Result<Seen> seen;
    const int repetitions = scene.once ? 1 : effort.repetitions;
    for (int repetition = 0; repetition < repetitions; ++repetition)
        if (seen = run(scene, effort, {double(repetition) / repetitions, 1.0 / repetitions}, seconds); !seen)
            return tl::unexpected(seen.error());
    Row row{.what = whatOf(scene), .time = runTimeOf(seconds), .note = seen->stages};
    const auto count = [&](const char* key, int number, std::optional<double> goal = {}) {
        row.figures.push_back({key, static_cast<double>(number), goal});
    };
    count("particles", seen->particles);
    if (!scene.scene.pattern.seams.empty()) count("openSeams", seen->openSeams, 0);
    count("particlesInside", seen->particlesInside, 0);
    count("bodyIntersections", seen->bodyIntersections, 0);
    count("selfIntersections", seen->selfIntersections, 0);
    row.figures.push_back({"cpuSeconds", row.time.least, scene.cpuSeconds});
    row.figures.push_back({"cpuPerSecond", row.time.least / scene.seconds, scene.cpuPerSecond});
    return std::vector<Row>{row};
}

} // namespace

Case drapeCase(DrapeScene scene) {
    Case made{.name = scene.name, .about = scene.about, .runs = {whatOf(scene)}};
    made.run = [scene = std::move(scene)](const Effort& effort) { return rowsOf(scene, effort); };
    return made;
}

} // namespace toile::study::scenes
