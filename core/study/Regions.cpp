// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Regions.h"
#include "core/study/EachPiece.h"

#include "core/base/Contracts.h"
#include "core/simulation/CarryOver.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::study {
namespace {

using pattern::Pattern;
using pattern::Piece;

/// One spacing everywhere; regions keep their stiffness and lose their finer mesh.
Pattern uniform(const Pattern& pattern, double factor) {
    return eachPiece(pattern, [factor](Piece& piece) {
        piece.spacing *= factor;
        for (auto& region : piece.regions) region.refinement = 0;
    });
}

double leastSpacing(const Pattern& pattern) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& piece : pattern.pieces) least = std::min(least, piece->spacing);
    return least;
}

/// A garment at rest and what it took.
struct Drape {
    simulation::Simulation simulation;
    LayoutResult result;
};

Result<Drape> draped(const Layout& layout, const simulation::SewSettings& settings, std::stop_token stop) {
    auto simulation = simulation::Simulation::create(layout.scene);
    if (!simulation) return tl::unexpected(simulation.error());
    const auto report = simulation::sew(*simulation, settings, stop);
    if (!report) return tl::unexpected(report.error());
    LayoutResult result{.name = layout.name, .spacing = layout.spacing};
    result.particles = report->particles;
    result.springs = report->springsStructural + report->springsShear + report->bending + report->twist;
    for (const auto& stage : report->stages) result.bytes += stage.bytes;
    result.cpuSeconds = report->cpuSeconds;
    result.atRest = report->atRest;
    result.energy = report->gravityEnergy + report->elasticEnergy;
    result.strain = report->strain;
    return Drape{std::move(*simulation), std::move(result)};
}

/// Of the corners of a piece: the same in all layouts.
geometry::Box2 extentOf(const Pattern& pattern, std::size_t piece) {
    std::vector<Vec2> corners;
    for (const auto& vertex : pattern::resolved(pattern, *pattern.pieces[piece]).outline.vertices)
        corners.push_back(vertex.position);
    return geometry::boundsOf(corners);
}

/// Where the points of a lattice over every piece lie in a drape; nothing where the mesh does not hold the point.
std::vector<std::optional<Vec3>> latticeOf(const simulation::Simulation& simulation) {
    constexpr int across = 33;
    const std::vector<Vec3> nodes = simulation.nodePositions();
    const auto& garment = simulation.garment();
    std::vector<std::optional<Vec3>> lattice;
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
        const simulation::DrapedPiece drape(
            mesh, std::span(nodes).subspan(garment.particles.firstNode[piece], mesh.nodes.size()));
        const auto [low, high] = extentOf(simulation.scene().pattern, piece);
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
                lattice.push_back(drape.inside(
                    {std::lerp(low.x, high.x, (i + 0.5) / across), std::lerp(low.y, high.y, (j + 0.5) / across)}));
    }
    return lattice;
}

struct Difference {
    double rms = 0, maximum = 0;
    int points = 0;
};

Difference differenceOf(const std::vector<std::optional<Vec3>>& a, const std::vector<std::optional<Vec3>>& b) {
    expects(a.size() == b.size(), "the same lattice");
    Difference difference;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i] || !b[i]) continue;
        const double d = geometry::distance(*a[i], *b[i]);
        sum += d * d;
        difference.maximum = std::max(difference.maximum, d);
        ++difference.points;
    }
    if (difference.points > 0) difference.rms = std::sqrt(sum / difference.points);
    return difference;
}

} // namespace

std::optional<double> finestSpacing(const Pattern& pattern) {
    std::optional<double> finest;
    for (const auto& piece : pattern.pieces)
        for (const auto& region : piece->regions)
            if (region.refinement > 0)
                finest = std::min(finest.value_or(std::numeric_limits<double>::infinity()),
                                  std::ldexp(piece->spacing, -region.refinement));
    return finest;
}

Result<RegionsStudy> studyRegions(const simulation::Scene& scene, double referenceSpacing,
                                  const simulation::SewSettings& settings, std::stop_token stop,
                                  const Progress& progress) {
    const auto finest = finestSpacing(scene.pattern);
    if (!finest)
        return fail(ErrorCode::invalidInput, "The pattern has no region that is finer than its piece: there is nothing "
                                             "to compare. Paint one and give it a refinement.");
    const double main = leastSpacing(scene.pattern);
    const auto uniformAt = [&](const std::string& name, double spacing) {
        simulation::Scene changed = scene;
        changed.pattern = uniform(scene.pattern, spacing / main);
        return Layout{name, std::move(changed), spacing};
    };
    constexpr double closerLines = 0.96;
    std::vector<Layout> layouts{uniformAt("uniform coarse", main),
                                {"regions", scene, *finest},
                                uniformAt("uniform fine", *finest),
                                uniformAt("reference", referenceSpacing),
                                uniformAt("reference again", closerLines * referenceSpacing)};
    std::vector<LayoutResult> results;
    std::vector<std::vector<std::optional<Vec3>>> lattices;
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        report(progress, static_cast<double>(i) / static_cast<double>(layouts.size() + 1), layouts[i].name);
        if (i == 4 && layouts[4].spacing == layouts[3].spacing) { // the reference is the uniform fine mesh
            results.push_back(results[3]);
            results.back().name = layouts[4].name;
            lattices.push_back(lattices[3]);
            continue;
        }
        const auto drape = draped(layouts[i], settings, stop);
        if (!drape) return tl::unexpected(drape.error());
        results.push_back(drape->result);
        lattices.push_back(latticeOf(drape->simulation));
        if (i == 1) { // known now: how many particles the regions have
            const double ratio = static_cast<double>(results[0].particles) / results[1].particles;
            layouts.insert(layouts.begin() + 2, uniformAt("uniform, as many particles", main * std::sqrt(ratio)));
        }
    }
    RegionsStudy study;
    const auto& reference = lattices[4];
    const Difference again = differenceOf(lattices[5], reference);
    study.floor = again.rms;
    study.points = again.points;
    for (std::size_t i = 0; i < 4; ++i) {
        const Difference difference = differenceOf(lattices[i], reference);
        results[i].rms = difference.rms;
        results[i].maximum = difference.maximum;
        study.layouts.push_back(results[i]);
    }
    study.reference = results[4];
    return study;
}

std::string verdictOn(const RegionsStudy& study) {
    const LayoutResult &coarse = study.layouts[0], &regions = study.layouts[1], &equal = study.layouts[2],
                       &fine = study.layouts[3];
    std::string text;
    const auto compared = [&](const LayoutResult& other, const char* than) {
        const double gain = other.rms - regions.rms;
        if (std::abs(gain) <= study.floor)
            return fmt::format("no difference from {} beyond the floor of {:.2g} mm", than, 1e3 * study.floor);
        return fmt::format("{:.2g} mm {} than {}", 1e3 * std::abs(gain),
                           gain > 0 ? "nearer to the reference" : "farther off", than);
    };
    text = fmt::format(
        "The regions bring {}, and {}. They take {:.2f} times the particles and {:.2f} times the CPU time of "
        "the uniform fine mesh, and are {}. ",
        compared(coarse, "the uniform coarse mesh"), compared(equal, "a uniform mesh of as many particles"),
        static_cast<double>(regions.particles) / fine.particles, regions.cpuSeconds / fine.cpuSeconds,
        compared(fine, "it"));
    const bool better = regions.rms + study.floor < equal.rms, worse = equal.rms + study.floor < regions.rms;
    text += better  ? "**Here the regions pay.**"
            : worse ? "**Here the regions do not pay: the same particles spread evenly do better.**"
                    : "**Here it makes no difference where the particles are.**";
    return text;
}

std::string regionsText(const RegionsStudy& study, const std::string& document, const std::string& command) {
    std::string text = fmt::format("# Regions: {}\n\n`{}`. Distance to a uniform mesh of {:.3g} mm ({} particles, "
                                   "{:.3g} CPU s) at {} common material "
                                   "points; with its lines 4 % closer that mesh differs from itself by {:.3g} mm "
                                   "(rms): the floor. Times are of one "
                                   "run.\n\n| layout | least spacing mm | particles | springs | KiB | CPU s | rms mm | "
                                   "largest mm | rms strain % | "
                                   "energy J | at rest |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
                                   document, command, 1e3 * study.reference.spacing, study.reference.particles,
                                   study.reference.cpuSeconds, study.points, 1e3 * study.floor);
    const auto row = [&](const LayoutResult& layout, const std::string& rms, const std::string& largest) {
        text +=
            fmt::format("| {} | {:.3g} | {} | {} | {} | {:.3g} | {} | {} | {:.3g} | {:.5g} | {} |\n", layout.name,
                        1e3 * layout.spacing, layout.particles, layout.springs, layout.bytes / 1024, layout.cpuSeconds,
                        rms, largest, 100 * layout.strain.rms, layout.energy, layout.atRest ? "yes" : "no");
    };
    for (const LayoutResult& layout : study.layouts)
        row(layout, fmt::format("{:.3g}", 1e3 * layout.rms), fmt::format("{:.3g}", 1e3 * layout.maximum));
    row(study.reference, "–", "–");
    return text + '\n' + verdictOn(study) + '\n';
}

Json toJson(const RegionsStudy& study) {
    const auto one = [](const LayoutResult& layout) {
        Json json;
        json.set("name", layout.name).set("spacing", layout.spacing).set("particles", layout.particles);
        json.set("springs", layout.springs).set("bytes", layout.bytes).set("cpuSeconds", layout.cpuSeconds);
        json.set("rmsError", layout.rms).set("maximumError", layout.maximum).set("strainRms", layout.strain.rms);
        return json.set("energy", layout.energy).set("atRest", layout.atRest);
    };
    Json json, layouts{Json::Array{}};
    for (const LayoutResult& layout : study.layouts) layouts.push(one(layout));
    json.set("layouts", layouts).set("reference", one(study.reference)).set("floor", study.floor);
    return json.set("points", study.points).set("verdict", verdictOn(study));
}

} // namespace toile::study
