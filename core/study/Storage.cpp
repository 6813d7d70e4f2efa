// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Storage.h"
#include "core/study/EachPiece.h"

#include "core/geometry/Polygon.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::study {
namespace {

using pattern::Pattern;
using pattern::Piece;

geometry::Box2 extentOf(const Piece& piece) {
    constexpr double chordError = 1e-4; // [m]: a box is painted by eye
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < piece.outline.edges.size(); ++i)
        for (const Vec2 point : geometry::flattened(curveOf(piece.outline, i), chordError)) points.push_back(point);
    return geometry::boundsOf(points);
}

pattern::Region regionOf(const FineBox& box, const Piece& piece, int number) {
    const auto [low, high] = extentOf(piece);
    const Vec2 size = high - low;
    const auto reach = [](double part) { return part <= 0 ? -0.1 : part >= 1 ? 1.1 : part; }; // over the border
    const double x0 = low.x + reach(box.left) * size.x, x1 = low.x + reach(box.right) * size.x,
                 y0 = low.y + reach(box.bottom) * size.y, y1 = low.y + reach(box.top) * size.y;
    pattern::Region region;
    region.id = pattern::RegionId(fmt::format("fine-{}", number));
    region.name = fmt::format("fine {}", number);
    region.outline = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    region.refinement = 1;
    return region;
}

double finestRegion(const Pattern& pattern) {
    double finest = std::numeric_limits<double>::infinity();
    for (const auto& piece : pattern.pieces)
        for (const auto& region : piece->regions)
            if (region.refinement > 0) finest = std::min(finest, std::ldexp(piece->spacing, -region.refinement));
    return finest;
}

/// Of the pieces that have regions, the coarsest.
double mainSpacing(const Pattern& pattern) {
    double main = 0;
    for (const auto& piece : pattern.pieces)
        if (!piece->regions.empty()) main = std::max(main, piece->spacing);
    return main;
}

/// No piece coarser than `spacing`, and none with regions.
Pattern uniform(const Pattern& pattern, double spacing) {
    return eachPiece(pattern, [spacing](Piece& piece) {
        piece.spacing = std::min(piece.spacing, spacing);
        piece.regions.clear();
    });
}

struct Meshed {
    StorageLayout layout;
    Shared<meshing::GarmentMesh> mesh;
};

Result<Meshed> meshed(const std::string& name, double spacing, const Pattern& pattern) {
    const auto input = simulation::meshInputOf(pattern);
    if (!input) return tl::unexpected(input.error());
    auto mesh = meshing::meshGarment(*input, {.judged = false});
    if (!mesh) return tl::unexpected(mesh.error());
    const std::size_t seams = mesh->seams.size();
    const Shared<meshing::GarmentMesh> shared(std::move(*mesh));
    const auto garment = simulation::makeGarment(pattern, shared, std::vector<bool>(seams, false));
    if (!garment) return tl::unexpected(garment.error());
    const meshing::PieceReport& total = shared->report.total;
    const cloth::ClothModel& cloth = garment->model;
    StorageLayout layout{.name = name, .spacing = spacing};
    layout.nodes = total.nodes;
    layout.slaves = total.slaves;
    layout.cells = total.quads + total.triangles;
    layout.springs = static_cast<int>(cloth.structural.size() + cloth.shear.size());
    layout.bending = static_cast<int>(cloth.bending.size() + cloth.twist.size() + cloth.hinges.size());
    layout.membranes = static_cast<int>(cloth.triangles.size() + cloth.cells.size());
    layout.meshBytes = total.bytes;
    layout.clothBytes = cloth::bytesOf(cloth);
    return Meshed{layout, shared};
}

/// Of the whole area, what lies in cells of finer regions [–].
double shareOfFineCells(const Pattern& pattern, const meshing::GarmentMesh& mesh) {
    double fine = 0, all = 0;
    for (std::size_t p = 0; p < mesh.pieces.size(); ++p) {
        const Piece piece = pattern::resolved(pattern, *pattern.pieces[p]);
        const auto add = [&](const auto& cell) {
            std::vector<Vec2> corners;
            for (const int node : cell.nodes)
                corners.push_back(mesh.pieces[p].material[static_cast<std::size_t>(node)]);
            const double area = std::abs(geometry::signedArea(corners));
            all += area;
            if (cell.region >= 0 && piece.regions[static_cast<std::size_t>(cell.region)].refinement > 0) fine += area;
        };
        std::ranges::for_each(mesh.pieces[p].rectangles, add);
        std::ranges::for_each(mesh.pieces[p].triangles, add);
    }
    return fine / all;
}

double ratio(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

double bytesOf(const StorageLayout& layout) {
    return static_cast<double>(layout.meshBytes + layout.clothBytes);
}

std::string rowOf(const StorageLayout& layout) {
    return fmt::format("| {} | {:.3g} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} |\n", layout.name,
                       1e3 * layout.spacing, layout.nodes, layout.slaves, layout.cells, layout.springs, layout.bending,
                       layout.membranes, layout.meshBytes / 1024, layout.clothBytes / 1024,
                       ratio(bytesOf(layout), layout.cells));
}

} // namespace

Result<Pattern> withFineBoxes(const Pattern& pattern, const std::vector<FineBox>& boxes) {
    Pattern painted = eachPiece(pattern, [](Piece& piece) { piece.regions.clear(); });
    int number = 0;
    for (const FineBox& box : boxes) {
        const auto found = std::ranges::find_if(painted.pieces, [&](const auto& piece) {
            return piece->name == box.piece || piece->id.value == box.piece;
        });
        if (found == painted.pieces.end())
            return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", box.piece));
        Piece piece = **found;
        const Place place{.object = fmt::format("piece \"{}\"", box.piece)};
        if (piece.mirror)
            return fail(ErrorCode::invalidInput,
                        fmt::format("It is the mirror image of \"{}\": paint that one, both get the region.",
                                    piece.mirror->source.value),
                        place);
        if (!(box.left < box.right && box.bottom < box.top))
            return fail(ErrorCode::invalidInput,
                        "A box runs from its left to its right and from its bottom to its top.", place);
        piece.regions.push_back(regionOf(box, piece, ++number));
        *found = Shared<Piece>(std::move(piece));
    }
    return painted;
}

Result<StorageStudy> studyStorage(const Pattern& pattern) {
    const double finest = finestRegion(pattern);
    if (!std::isfinite(finest))
        return fail(ErrorCode::invalidInput, "The pattern has no region that is finer than its piece: there is nothing "
                                             "to compare. Paint one, or name a box with --fine.");
    const double main = mainSpacing(pattern);
    const auto coarse =
        meshed("uniform at the main spacing", main, uniform(pattern, std::numeric_limits<double>::infinity()));
    if (!coarse) return tl::unexpected(coarse.error());
    const auto regions = meshed("regions", finest, pattern);
    if (!regions) return tl::unexpected(regions.error());
    const auto fine = meshed("uniform at the finest", finest, uniform(pattern, finest));
    if (!fine) return tl::unexpected(fine.error());
    return StorageStudy{coarse->layout, regions->layout, fine->layout, shareOfFineCells(pattern, *regions->mesh)};
}

double idealShare(const StorageStudy& study) {
    return study.fineShare + (1 - study.fineShare) * ratio(study.coarse.nodes, study.fine.nodes);
}

std::string storageText(const StorageStudy& study, const std::string& document, const Circumstances& circumstances) {
    std::string text = fmt::format("# Storage: {}\n\n`{}`. Cloth before its seams are merged; bytes are what arrays "
                                   "hold.\n\n| layout | spacing mm | nodes | of them slaves | cells | springs | "
                                   "bending | membranes | mesh KiB | cloth KiB | B a cell |\n"
                                   "|---|---|---|---|---|---|---|---|---|---|---|\n",
                                   document, circumstances.command);
    for (const StorageLayout* layout : {&study.coarse, &study.regions, &study.fine}) text += rowOf(*layout);
    const StorageLayout &regions = study.regions, &fine = study.fine;
    return text + fmt::format("\n{:.0f} % of the area is finer. The regions take {:.2f} times the nodes of the uniform "
                              "fine mesh, {:.2f} times its elements and {:.2f} times its bytes; the areas alone would "
                              "come to {:.2f} times the nodes. The rest is what joints and sewn edges refine beside "
                              "them.\n",
                              100 * study.fineShare, ratio(regions.nodes, fine.nodes),
                              ratio(regions.springs + regions.bending + regions.membranes,
                                    fine.springs + fine.bending + fine.membranes),
                              ratio(bytesOf(regions), bytesOf(fine)), idealShare(study));
}

std::vector<Json> recordsOf(const StorageStudy& study, const std::string& document,
                            const Circumstances& circumstances) {
    Json scene;
    scene.set("name", document).set("fineShare", study.fineShare).set("idealShare", idealShare(study));
    std::vector<Json> records;
    for (const StorageLayout* layout : {&study.coarse, &study.regions, &study.fine}) {
        Json method, cost, record;
        method.set("layout", layout->name).set("spacing", layout->spacing);
        cost.set("nodes", layout->nodes).set("slaves", layout->slaves).set("cells", layout->cells);
        cost.set("springs", layout->springs).set("bending", layout->bending).set("membranes", layout->membranes);
        cost.set("meshBytes", layout->meshBytes).set("clothBytes", layout->clothBytes);
        record.set("scene", scene).set("method", method).set("cost", cost);
        note(record, "toile-storage-1", circumstances);
        records.push_back(std::move(record));
    }
    return records;
}

} // namespace toile::study
