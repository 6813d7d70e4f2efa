// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/MeshJson.h"

#include <fmt/format.h>
#include <numbers>

namespace toile::batch {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

Json regionJson(const meshing::RegionReport& region) {
    Json json;
    json.set("name", region.label).set("spacing", region.spacing).set("ratio", region.ratio).set("cells", region.cells);
    return json.set("displacement", region.displacement).set("areaChange", region.areaChange);
}

Json foldJson(const meshing::FoldReport& fold) {
    Json json;
    json.set("name", fold.label).set("nodes", fold.nodes).set("length", fold.length);
    return json.set("deviation", fold.deviation);
}

Json pieceJson(const meshing::PieceReport& piece) {
    Json json;
    if (!piece.label.empty()) json.set("name", piece.label);
    json.set("nodes", piece.nodes)
        .set("slaves", piece.slaves)
        .set("quads", piece.quads)
        .set("triangles", piece.triangles);
    json.set("rectangles", piece.rectangles).set("rectangleFraction", piece.rectangleFraction);
    json.set("minimumAngleDegrees", piece.minimumAngle * degrees)
        .set("maximumAngleDegrees", piece.maximumAngle * degrees);
    json.set("inputMinimumAngleDegrees", piece.inputMinimumAngle * degrees).set("maximumAspect", piece.maximumAspect);
    Json percentiles;
    for (const int part : {1, 5, 50, 95, 99})
        percentiles.set(fmt::format("p{}", part), meshing::angleBelow(piece, 0.01 * part));
    json.set("anglePercentilesDegrees", percentiles).set("neighbourSizeRatio", piece.neighbourSizeRatio);
    json.set("grainAlignment", piece.grainAlignment);
    json.set("areaRelativeError", piece.areaRelativeError).set("boundaryDeviation", piece.boundaryDeviation);
    json.set("invertedCells", piece.invertedCells).set("missingBoundaryNodes", piece.missingBoundaryNodes);
    json.set("nonManifoldEdges", piece.nonManifoldEdges).set("seconds", piece.seconds).set("bytes", piece.bytes);
    Json regions(Json::Array{}), folds(Json::Array{});
    for (const meshing::RegionReport& region : piece.regions) regions.push(regionJson(region));
    for (const meshing::FoldReport& fold : piece.folds) folds.push(foldJson(fold));
    return json.set("regions", regions).set("folds", folds);
}

Json seamJson(const meshing::SeamReport& seam) {
    Json json;
    json.set("name", seam.label).set("countA", seam.countA).set("countB", seam.countB);
    json.set("lengthA", seam.lengthA).set("lengthB", seam.lengthB).set("ease", seam.ease);
    const meshing::SewnAlike alike = meshing::sewnAlike(seam);
    json.set("largestSpacingMismatch", seam.largestSpacingMismatch);
    return json.set("equalLength", alike.length).set("equalCount", alike.count).set("equalUnitLength", alike.unit);
}

} // namespace

Json toJson(const meshing::MeshReport& report) {
    Json pieces(Json::Array{}), seams(Json::Array{}), warnings(Json::Array{});
    for (const meshing::PieceReport& piece : report.pieces) pieces.push(pieceJson(piece));
    for (const meshing::SeamReport& seam : report.seams) seams.push(seamJson(seam));
    for (const Warning& warning : report.warnings) {
        Json json;
        warnings.push(json.set("place", warning.place).set("text", warning.text));
    }
    Json json;
    return json.set("pieces", pieces)
        .set("total", pieceJson(report.total))
        .set("seams", seams)
        .set("warnings", warnings);
}

} // namespace toile::batch
