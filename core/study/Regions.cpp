// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Regions.h"
#include "core/study/EachPiece.h"

#include "core/base/Contracts.h"
#include "core/simulation/CarryOver.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::study {
namespace {

using pattern::Pattern;

double leastSpacing(const Pattern& pattern) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& piece : pattern.pieces) least = std::min(least, piece->spacing);
    return least;
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
    LayoutResult result{.name = layout.name, .spacing = layout.spacing};
    result.particles = report->particles;
    result.springs = report->springsStructural + report->springsShear + report->bending + report->twist;
    for (const auto& stage : report->stages) result.bytes += stage.bytes;
    result.time = runTimeOf({seconds});
    result.atRest = report->atRest;
    result.energy = report->gravityEnergy + report->elasticEnergy;
    result.strain = report->strain;
    return Drape{std::move(*simulation), std::move(result), seconds};
}

/// Of the corners of a piece: the same in all layouts.
geometry::Box2 extentOf(const Pattern& pattern, std::size_t piece) {
    std::vector<Vec2> corners;
    for (const auto& vertex : pattern::resolved(pattern, *pattern.pieces[piece]).outline.vertices)
        corners.push_back(vertex.position);
    return geometry::boundsOf(corners);
}

/// Where points of every piece lie in a drape; nothing where the mesh does not hold the point.
using Lattice = std::vector<std::optional<Vec3>>;

Lattice latticeOf(const simulation::Simulation& simulation) {
    constexpr int across = 33;
    const std::vector<Vec3> nodes = simulation.nodePositions();
    const auto& garment = simulation.garment();
    Lattice lattice;
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

Difference differenceOf(const Lattice& a, const Lattice& b) {
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

std::size_t noisyOf(const RegionsStudy& study) {
    return static_cast<std::size_t>(
        std::ranges::count_if(study.layouts, [](const LayoutResult& layout) { return layout.time.noisy; }));
}

/// "and 0.21 times the CPU time "; nothing where a time is noisy.
std::string timesOf(const RegionsStudy& study) {
    if (noisyOf(study) > 0) return "";
    return fmt::format("and {:.2f} times the CPU time ", study.layouts[1].time.least / study.layouts[3].time.least);
}

Json recordOf(const LayoutResult& layout) {
    Json method, result, cost, record;
    method.set("layout", layout.name).set("spacing", layout.spacing);
    result.set("rmsError", layout.rms).set("maximumError", layout.maximum).set("strainRms", layout.strain.rms);
    result.set("energy", layout.energy);
    cost.set("particles", layout.particles).set("springs", layout.springs).set("bytes", layout.bytes);
    cost.set("cpuSecondsMinimum", layout.time.least).set("cpuSecondsMedian", layout.time.median);
    record.set("method", method).set("result", result).set("cost", cost);
    return record.set("status", layout.atRest ? "done" : "not at rest");
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

Result<RegionsStudy> studyRegions(const simulation::Scene& scene, const RegionsSettings& settings, std::stop_token stop,
                                  const Progress& progress) {
    const auto finest = finestSpacing(scene.pattern);
    if (!finest)
        return fail(ErrorCode::invalidInput, "The pattern has no region that is finer than its piece: there is nothing "
                                             "to compare. Paint one and give it a refinement.");
    const double main = leastSpacing(scene.pattern);
    const auto uniformAt = [&](const std::string& name, double spacing) {
        simulation::Scene changed = scene;
        changed.pattern = uniformCoarser(scene.pattern, spacing / main);
        return Layout{name, std::move(changed), spacing};
    };
    std::vector<Layout> layouts{uniformAt("uniform coarse", main),
                                {"regions", scene, *finest},
                                uniformAt("uniform, as many particles", main), // its spacing is known after the regions
                                uniformAt("uniform fine", *finest)};
    RegionsStudy study{.layouts = std::vector<LayoutResult>(layouts.size()), .repetitions = settings.repetitions};
    std::vector<Lattice> lattices(layouts.size());
    std::vector<std::vector<double>> seconds(layouts.size());
    const double runs = static_cast<double>(layouts.size()) * settings.repetitions + 2;
    double run = 0;
    const auto runOne = [&](std::size_t i, int repetition) -> Result<void> {
        if (i == 2 && repetition == 0)
            layouts[i] = uniformAt(layouts[i].name, main * std::sqrt(static_cast<double>(study.layouts[0].particles) /
                                                                     study.layouts[1].particles));
        report(progress, run++ / runs, layouts[i].name);
        const auto drape = draped(layouts[i], settings.sewing, stop);
        if (!drape) return tl::unexpected(drape.error());
        seconds[i].push_back(drape->seconds);
        if (repetition > 0) return {}; // the same bits again
        study.layouts[i] = drape->result;
        lattices[i] = latticeOf(drape->simulation);
        if (i + 1 == layouts.size()) study.parts = deformationOf(drape->simulation, scene.pattern);
        return {};
    };
    if (auto done = inTurns(layouts.size(), settings.repetitions, runOne); !done) return tl::unexpected(done.error());

    constexpr double closerLines = 0.96;
    Lattice reference = lattices.back();
    study.reference = study.layouts.back();
    if (settings.referenceSpacing != *finest) { // else the reference is the uniform fine mesh
        report(progress, run / runs, "reference");
        const auto drape = draped(uniformAt("reference", settings.referenceSpacing), settings.sewing, stop);
        if (!drape) return tl::unexpected(drape.error());
        study.reference = drape->result;
        reference = latticeOf(drape->simulation);
    }
    study.reference.name = "reference";
    report(progress, (run + 1) / runs, "reference again");
    const auto again =
        draped(uniformAt("reference again", closerLines * settings.referenceSpacing), settings.sewing, stop);
    if (!again) return tl::unexpected(again.error());
    const Difference floor = differenceOf(latticeOf(again->simulation), reference);
    study.floor = floor.rms;
    study.points = floor.points;
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        const Difference difference = differenceOf(lattices[i], reference);
        study.layouts[i].rms = difference.rms;
        study.layouts[i].maximum = difference.maximum;
        study.layouts[i].time = runTimeOf(seconds[i]);
    }
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
        "The regions bring {}, and {}. They take {:.2f} times the particles {}of the uniform fine mesh, and "
        "are {}. ",
        compared(coarse, "the uniform coarse mesh"), compared(equal, "a uniform mesh of as many particles"),
        static_cast<double>(regions.particles) / fine.particles, timesOf(study), compared(fine, "it"));
    const bool better = regions.rms + study.floor < equal.rms, worse = equal.rms + study.floor < regions.rms;
    text += better  ? "**Here the regions pay.**"
            : worse ? "**Here the regions do not pay: the same particles spread evenly do better.**"
                    : "**Here it makes no difference where the particles are.**";
    if (const std::size_t noisy = noisyOf(study)) text += ' ' + tooNoisy(noisy, study.layouts.size());
    return text;
}

std::string regionsText(const RegionsStudy& study, const std::string& document, const Circumstances& circumstances) {
    std::string text = fmt::format(
        "# Regions: {}\n\n`{}`, {}, {}. Distance to a uniform mesh of {:.3g} mm ({} particles) at {} common material "
        "points; with its lines 4 % closer that mesh differs from itself by {:.3g} mm (rms): the floor. CPU times are "
        "the least and the median of {} runs that take turns; of the reference, of one.\n\n| layout | least spacing mm "
        "| "
        "particles | springs | KiB | CPU s | median | rms mm | largest mm | rms strain % | energy J | at rest |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        document, circumstances.command, circumstances.program, circumstances.processor, 1e3 * study.reference.spacing,
        study.reference.particles, study.points, 1e3 * study.floor, study.repetitions);
    const auto row = [&](const LayoutResult& layout, const std::string& rms, const std::string& largest) {
        text += fmt::format("| {} | {:.3g} | {} | {} | {} | {:.3g} | {:.3g} | {} | {} | {:.3g} | {:.5g} | {} |\n",
                            layout.name, 1e3 * layout.spacing, layout.particles, layout.springs, layout.bytes / 1024,
                            layout.time.least, layout.time.median, rms, largest, 100 * layout.strain.rms, layout.energy,
                            layout.atRest ? "yes" : "no");
    };
    for (const LayoutResult& layout : study.layouts)
        row(layout, fmt::format("{:.3g}", 1e3 * layout.rms), fmt::format("{:.3g}", 1e3 * layout.maximum));
    row(study.reference, "–", "–");
    return text + '\n' + verdictOn(study) + "\n\n## What deforms\n\nOn the uniform fine mesh:\n\n" +
           deformationText(study.parts);
}

std::vector<Json> recordsOf(const RegionsStudy& study, const std::string& document,
                            const Circumstances& circumstances) {
    Json scene, reference;
    scene.set("name", document);
    reference.set("spacing", study.reference.spacing).set("selfError", study.floor).set("points", study.points);
    std::vector<Json> records;
    for (const LayoutResult& layout : study.layouts) records.push_back(recordOf(layout));
    records.push_back(recordOf(study.reference));
    for (Json& record : records) {
        record.set("scene", scene).set("reference", reference);
        note(record, "toile-regions-1", circumstances);
    }
    return records;
}

} // namespace toile::study
