// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/MeshExport.h"
#include "app/batch/MeshJson.h"
#include "app/batch/Outputs.h"
#include "core/base/AtomicFile.h"
#include "core/io/DocumentFile.h"
#include "core/simulation/MeshInputOf.h"
#include "core/study/Repetitions.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::batch {
namespace {

/// The pattern with one piece only, without seams to others.
Result<pattern::Pattern> onlyPiece(const pattern::Pattern& pattern, const std::string& name) {
    const auto found = std::ranges::find_if(
        pattern.pieces, [&](const auto& piece) { return piece->id.value == name || piece->name == name; });
    if (found == pattern.pieces.end()) return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", name));
    pattern::Pattern alone = pattern;
    pattern::Piece piece = pattern::resolved(pattern, **found);
    piece.mirror.reset();
    alone.pieces = {piece};
    std::erase_if(alone.seams, [&](const pattern::Seam& seam) {
        return std::ranges::any_of(seam.sides, [&](const auto& side) {
            return std::ranges::any_of(side, [&](const auto& part) { return part.piece != piece.id; });
        });
    });
    return alone;
}

/// Meshes several times and reports the median time of each piece and of all.
Result<meshing::GarmentMesh> meshRepeatedly(const meshing::MeshInput& input, int repeat, std::stop_token stop) {
    std::vector<meshing::MeshReport> reports;
    Result<meshing::GarmentMesh> mesh;
    for (int run = 0; run < repeat; ++run) {
        mesh = meshing::meshGarment(input);
        if (!mesh) return mesh;
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The run was stopped.");
        reports.push_back(mesh->report);
    }
    const auto median = [&](auto secondsOf) {
        std::vector<double> seconds;
        for (const meshing::MeshReport& report : reports) seconds.push_back(secondsOf(report));
        return study::runTimeOf(std::move(seconds)).median;
    };
    mesh->report.total.seconds = median([](const auto& report) { return report.total.seconds; });
    for (std::size_t i = 0; i < mesh->report.pieces.size(); ++i)
        mesh->report.pieces[i].seconds = median([i](const auto& report) { return report.pieces[i].seconds; });
    return mesh;
}

void printPieces(const meshing::MeshReport& report) {
    fmt::print("{:<28}{:>8}{:>8}{:>11}{:>8}{:>9}{:>7}{:>7}{:>7}{:>7}{:>9}\n", "piece", "nodes", "quads", "triangles",
               "rect %", "grain %", "angle", "1 %", "5 %", "95 %", "ms");
    const auto row = [](const std::string& name, const meshing::PieceReport& piece) {
        fmt::print("{:<28}{:>8}{:>8}{:>11}{:>8.1f}{:>9.1f}{:>7.1f}{:>7}{:>7}{:>7}{:>9.2f}\n", name, piece.nodes,
                   piece.quads, piece.triangles, 100 * piece.rectangleFraction, 100 * piece.grainAlignment,
                   piece.minimumAngle * 57.29577951308232, meshing::angleBelow(piece, 0.01),
                   meshing::angleBelow(piece, 0.05), meshing::angleBelow(piece, 0.95), 1000 * piece.seconds);
    };
    for (const meshing::PieceReport& piece : report.pieces) row(oneLine(piece.label), piece);
    row("all", report.total);
}

/// The paper's three conditions: equal lengths but for the ease, equal counts, equal unit lengths.
void printSeams(const meshing::MeshReport& report) {
    if (report.seams.empty()) return;
    fmt::print("\n{:<28}{:>9}{:>19}{:>9}{:>9}   {}\n", "seam", "points", "lengths mm", "ease mm", "unit %", "alike");
    for (const meshing::SeamReport& seam : report.seams) {
        const meshing::SewnAlike alike = meshing::sewnAlike(seam);
        fmt::print("{:<28}{:>9}{:>19}{:>9.1f}{:>9.2f}   {}{}{}\n", oneLine(seam.label),
                   fmt::format("{}={}", seam.countA, seam.countB),
                   fmt::format("{:.1f}/{:.1f}", 1e3 * seam.lengthA, 1e3 * seam.lengthB), 1e3 * seam.ease,
                   100 * seam.largestSpacingMismatch, alike.length ? "length " : "", alike.count ? "count " : "",
                   alike.unit ? "unit" : "");
    }
}

void printSummary(const meshing::MeshReport& report) {
    printPieces(report);
    printSeams(report);
    printWarnings(report.warnings);
}

Result<void> run(const MeshOptions& options, std::stop_token stop) {
    const std::vector<Output> outputs{{options.out, {".obj", ".svg", ".png"}}, {options.report}};
    if (auto sound = checkedOutputs(outputs, {options.file}); !sound) return sound;
    auto opened = io::readDocument(options.file);
    if (!opened) return tl::unexpected(opened.error());
    Result<pattern::Pattern> pattern = opened->document.pattern;
    if (!options.piece.empty()) pattern = onlyPiece(*pattern, options.piece);
    if (!pattern) return tl::unexpected(pattern.error());
    auto input = simulation::meshInputOf(*pattern, {options.spacing, options.rule, options.border});
    if (!input) return tl::unexpected(input.error());
    if (!options.regions)
        for (meshing::PieceInput& piece : input->pieces) piece.regions.clear();
    const auto mesh = meshRepeatedly(*input, options.repeat, stop);
    if (!mesh) return tl::unexpected(mesh.error());
    printSummary(mesh->report);
    if (!options.out.empty())
        if (auto written = writeMesh(options.out, *pattern, *mesh); !written) return written;
    if (!options.report.empty()) return writeFileAtomically(options.report, toText(toJson(mesh->report)));
    return {};
}

} // namespace

int mesh(const MeshOptions& options, std::stop_token stop) {
    if (const auto finished = run(options, stop); !finished) {
        printError(io::locatedIn(options.file, finished.error()));
        return inputWrong;
    }
    return done;
}

} // namespace toile::batch
