// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternCheck.h"

#include "core/pattern/CheckParts.h"
#include "core/pattern/Editing.h"
#include "core/pattern/PatternFabrics.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternPieces.h"
#include "core/pattern/PatternPlacement.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace toile::pattern {
namespace {

/// Finds ids that are given twice.
template <class IdType>
class Unique {
public:
    void check(const IdType& id, const std::string& member, Problems& problems) {
        if (!seen_.insert(id).second)
            problems.error(member + "id", fmt::format("The id \"{}\" is given twice.", id.value));
    }

private:
    std::set<IdType> seen_;
};

void checkIdsWithin(const Piece& piece, Problems& problems) {
    Unique<VertexId> vertices;
    Unique<EdgeId> edges;
    Unique<RegionId> regions;
    Unique<FoldId> folds;
    for (int loop = 0; loop <= static_cast<int>(piece.holes.size()); ++loop) {
        const Contour& contour = loopOf(piece, loop);
        const std::string at = loop == 0 ? "" : fmt::format("holes[{}].", loop - 1);
        for (std::size_t i = 0; i < contour.vertices.size(); ++i)
            vertices.check(contour.vertices[i].id, fmt::format("{}vertices[{}].", at, i), problems);
        for (std::size_t i = 0; i < contour.edges.size(); ++i)
            edges.check(contour.edges[i].id, fmt::format("{}edges[{}].", at, i), problems);
    }
    for (std::size_t i = 0; i < piece.regions.size(); ++i)
        regions.check(piece.regions[i].id, fmt::format("regions[{}].", i), problems);
    for (std::size_t i = 0; i < piece.folds.size(); ++i)
        folds.check(piece.folds[i].id, fmt::format("folds[{}].", i), problems);
}

void checkNumbers(const Pattern& pattern, const Piece& piece, Problems& problems) {
    if (!(piece.spacing > 0 && std::isfinite(piece.spacing)))
        problems.error("spacing",
                       fmt::format("The spacing is {} mm, but must be a positive length.", piece.spacing * 1000));
    if (!(piece.seamAllowance >= 0 && std::isfinite(piece.seamAllowance)))
        problems.error("seamAllowance", "A seam allowance cannot be negative.");
    if (piece.plies < 1 || piece.plies > mostPlies)
        problems.error("plies", fmt::format("The piece has {} plies, but must have 1 to {}.", piece.plies, mostPlies));
    if (piece.layer < 0 || piece.layer > outermostLayer)
        problems.error("layer", fmt::format("The layer is {}, but must be from 0 to {}.", piece.layer, outermostLayer));
    if (!(std::abs(piece.pressure) <= mostPressure))
        problems.error("pressure", fmt::format("The pressure is {} Pa, but must be from {} to {} Pa.", piece.pressure,
                                               -mostPressure, mostPressure));
    if (!std::isfinite(piece.grain)) problems.error("grainDegrees", "The grain needs a finite angle.");
    if (!geometry::isFinite(piece.tablePosition))
        problems.error("tablePosition", "A position must have finite coordinates.");
    if (piece.fabric.empty()) problems.error("fabric", "The piece is cut from no fabric.");
    else if (!findFabric(pattern, piece.fabric))
        problems.error("fabric", fmt::format("There is no fabric \"{}\".", piece.fabric.value));
    if (!piece.interfacing) return;
    if (const auto ok = material::checked(*piece.interfacing); !ok)
        problems.error("interfacing." + ok.error().place.path, ok.error().text);
}

void checkPlacement(const Piece& piece, Problems& problems) {
    if (!piece.placement) return;
    if (!isRigid(piece.placement->transform))
        problems.error("placement.matrix", "A placement moves and turns a piece, but does not stretch or mirror it.");
    if (!piece.placement->curl) return;
    const Curl& curl = *piece.placement->curl;
    if (!(std::abs(curl.radius) > 0 && std::isfinite(curl.radius)))
        problems.error("placement.curl.radius", "The radius of a curl must be a length other than 0.");
    if (!(std::abs(geometry::length(curl.axis) - 1) < 1e-6))
        problems.error("placement.curl.axis", "The axis of a curl must be a unit direction.");
    if (curl.bent && !isLine(*curl.bent))
        problems.error("placement.curl.bent",
                       "A bent middle needs two points at least, and no two neighbours in one place.");
}

void checkNotches(const Piece& piece, Problems& problems) {
    for (std::size_t i = 0; i < piece.notches.size(); ++i) {
        const Notch& notch = piece.notches[i];
        if (!findEdge(piece, notch.edge))
            problems.error(fmt::format("notches[{}].edge", i),
                           fmt::format("The piece has no edge \"{}\".", notch.edge.value));
        if (!(notch.position >= 0 && notch.position <= 1))
            problems.error(
                fmt::format("notches[{}].position", i),
                fmt::format("A notch lies at a fraction from 0 to 1 of its edge, but this one at {}.", notch.position));
    }
    for (std::size_t i = 0; i < piece.internalLines.size(); ++i)
        if (!std::ranges::all_of(piece.internalLines[i].points, [](Vec2 p) { return geometry::isFinite(p); }))
            problems.error(fmt::format("internalLines[{}].points", i), "A point must have finite coordinates.");
}

void checkMirror(const Pattern& pattern, const Piece& piece, Problems& problems) {
    const MirrorOf& mirror = *piece.mirror;
    const Piece* source = findPiece(pattern, mirror.source);
    if (!source) problems.error("mirror.source", fmt::format("There is no piece \"{}\".", mirror.source.value));
    else if (source->mirror)
        problems.error(
            "mirror.source",
            fmt::format("The piece \"{}\" is a mirror image itself: name the piece it is made from.", source->name));
    if (!(geometry::distance(mirror.lineStart, mirror.lineEnd) > 1e-9))
        problems.error("mirror.line", "A mirror line needs two different points.");
}

/// Returns the pieces whose contours cannot be worked with.
std::set<PieceId> checkPieces(const Pattern& pattern, std::vector<Problem>& all) {
    std::set<PieceId> unsound;
    Unique<PieceId> ids;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const Piece& piece = *pattern.pieces[i];
        Problems problems(all, fmt::format("pieces[{}]", i), placeOf(piece).object);
        ids.check(piece.id, "", problems);
        checkNumbers(pattern, piece, problems);
        checkPlacement(piece, problems);
        if (piece.mirror) {
            checkMirror(pattern, piece, problems);
            continue;
        }
        checkIdsWithin(piece, problems);
        const bool sound = checkContours(piece, problems);
        checkNotches(piece, problems);
        if (sound) {
            checkRegions(piece, problems);
            checkFolds(piece, problems);
        } else unsound.insert(piece.id);
    }
    return unsound;
}

/// Springs of woven cloth are coupled by its shear stiffness; membrane cells, which it gets where these would be
/// negative, by its own coupling.
void checkStiffness(const Fabric& fabric, Problems& problems) {
    if (const auto cells = material::membraneStiffness(fabric, fabric.coupling); !cells)
        return problems.error("coupling", cells.error().text);
    if (fabric.kind == material::FabricKind::knit) return;
    if (const auto springs = material::membraneStiffness(fabric, fabric.shearStiffness); !springs)
        problems.error("shearStiffness", springs.error().text);
}

void checkFabrics(const Pattern& pattern, std::vector<Problem>& all) {
    Unique<FabricId> ids;
    for (std::size_t i = 0; i < pattern.fabrics.size(); ++i) {
        const Fabric& fabric = *pattern.fabrics[i];
        Problems problems(all, fmt::format("fabrics[{}]", i), fmt::format("fabric \"{}\"", fabric.name));
        ids.check(fabric.id, "", problems);
        if (const auto ok = material::checked(fabric); !ok) problems.error(ok.error().place.path, ok.error().text);
        else checkStiffness(fabric, problems);
    }
}

void checkPins(const Pattern& pattern, std::vector<Problem>& all) {
    Unique<PinId> ids;
    std::set<std::pair<PieceId, VertexId>> held;
    for (std::size_t i = 0; i < pattern.pins.size(); ++i) {
        const Pin& pin = pattern.pins[i];
        Problems problems(all, fmt::format("pins[{}]", i), fmt::format("pin \"{}\"", pin.id.value));
        ids.check(pin.id, "", problems);
        const Piece* piece = findPiece(pattern, pin.piece);
        const Piece* shape = piece ? shapeOf(pattern, *piece) : nullptr;
        if (!piece) problems.error("piece", fmt::format("There is no piece \"{}\".", pin.piece.value));
        else if (shape && !findVertex(*shape, pin.vertex))
            problems.error("vertex",
                           fmt::format("The piece \"{}\" has no point \"{}\".", piece->name, pin.vertex.value));
        else if (!held.insert({pin.piece, pin.vertex}).second)
            problems.error("vertex", fmt::format("The point \"{}\" of the piece \"{}\" is pinned twice.",
                                                 pin.vertex.value, piece->name));
        else if (pin.toBody && piece->frozen)
            problems.warning("toBody",
                             fmt::format("The piece \"{}\" is frozen: its cloth stays where it lies, whatever the body "
                                         "does.",
                                         piece->name));
    }
}

} // namespace

std::vector<Problem> checkPattern(const Pattern& pattern, const SeamTolerance& tolerance) {
    std::vector<Problem> problems;
    checkFabrics(pattern, problems);
    const std::set<PieceId> unsound = checkPieces(pattern, problems);
    Unique<SeamId> seamIds;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        Problems of(problems, fmt::format("seams[{}]", i), placeOf(pattern.seams[i]).object);
        seamIds.check(pattern.seams[i].id, "", of);
    }
    checkSeams(pattern, unsound, tolerance, problems);
    checkPins(pattern, problems);
    checkTacks(pattern, unsound, problems);
    return problems;
}

std::string toString(const Problem& problem) {
    return toile::toString(
        Error{ErrorCode::invalidInput, (problem.isError ? "" : "warning: ") + problem.text, problem.place});
}

bool hasErrors(const std::vector<Problem>& problems) {
    return std::ranges::any_of(problems, &Problem::isError);
}

} // namespace toile::pattern
