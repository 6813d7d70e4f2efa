// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/GarmentMesher.h"
#include "core/base/Index.h"

#include "core/base/Team.h"
#include "core/base/WallTime.h"
#include "core/meshing/BorderSpacing.h"
#include "core/meshing/DividedBorders.h"
#include "core/meshing/PieceMesher.h"
#include "core/meshing/Quality.h"
#include "core/meshing/SewnNodes.h"

#include <chrono>
#include <mutex>

namespace toile::meshing {
namespace {

/// The finest spacing wanted along a stretch of an edge.
struct StretchSpacing {
    int loop = 0, edge = 0;
    double from = 0, to = 0;
    double spacing = 0; ///< [m]
};

/// What a piece's mesh was made of. Each part is worth something only together with those above it.
struct PieceMemory {
    PieceInput input;
    bool isChecked = false;          ///< the boundary in the garment's memory is that of the input
    std::pmr::vector<Vec2> seamEnds; ///< for which the main mesh was laid, as for the stretches
    GrainStretches stretches;
    LaidLattice laid;
    bool isLaid = false;
    std::vector<StretchSpacing> spacings; ///< asked of the laid lattice's regions
    BorderMemory border;
    bool isMeshed = false; ///< mesh and report in the garment are those of all this

    void forget() { isChecked = isLaid = border.isKnown = isMeshed = false; }
    double spacingAlong(const PieceBoundary& boundary, int loop, int edge, double from, double to);
};

double PieceMemory::spacingAlong(const PieceBoundary& boundary, int loop, int edge, double from, double to) {
    if (input.regions.empty()) return input.spacing;
    for (const StretchSpacing& known : spacings)
        if (known.loop == loop && known.edge == edge && known.from == from && known.to == to) return known.spacing;
    const double spacing = finestSpacingAlong(input, boundary, laid.lattice, loop, edge, from, to);
    spacings.push_back({loop, edge, from, to, spacing});
    return spacing;
}

/// The ends of seam parts on a piece, in its frame.
std::pmr::vector<Vec2> seamEnds(std::span<const CheckedSeam> seams, int piece, const PieceBoundary& boundary,
                                Arena& arena) {
    std::pmr::vector<Vec2> ends(&arena);
    for (const CheckedSeam& seam : seams)
        for (const SeamChain& side : seam.sides)
            for (const ChainPart& part : side.parts)
                for (const double fraction : {part.part.from, part.part.to})
                    if (part.part.piece == piece)
                        ends.push_back(boundary.frame.frameOf(
                            boundary.loops[at(part.part.loop)].edges[at(part.part.edge)].arc.pointAt(fraction)));
    return ends;
}

} // namespace

struct GarmentMesher::Memory {
    MeshSettings settings;
    MeshingWork work;
    std::vector<PieceMemory> pieces;
    std::vector<PieceBoundary> boundaries;
    GarmentMesh garment;
    Arena arena; ///< of what a call works in but the meshing of pieces
    LatticeLayer layer;
    Team team;                                      ///< that meshes pieces
    std::mutex guard;                               ///< of `idle`
    std::vector<std::unique_ptr<PieceMesher>> idle; ///< one for each thread that has meshed

    std::unique_ptr<PieceMesher> takeMesher();
    void giveBack(std::unique_ptr<PieceMesher> mesher);
    Result<void> checkPieces(const MeshInput& input);
    Result<std::pmr::vector<CheckedSeam>> checkSeams(const MeshInput& input);
    Result<void> layLattice(const MeshInput& input, std::span<const CheckedSeam> seams, std::size_t piece,
                            const GrainStretches& stretches);
    Result<BoundaryDivision> divide(const MeshInput& input, std::span<const CheckedSeam> seams);
    Result<void> meshPieces(const MeshInput& input);
    Result<void> meshPiece(const MeshInput& input, std::size_t piece);
    void sew(const MeshInput& input, std::span<const CheckedSeam> seams, const BoundaryDivision& division);
    Result<const GarmentMesh*> mesh(const MeshInput& input);
};

Result<void> GarmentMesher::Memory::checkPieces(const MeshInput& input) {
    pieces.resize(input.pieces.size());
    boundaries.resize(input.pieces.size());
    garment.pieces.resize(input.pieces.size());
    garment.report.pieces.resize(input.pieces.size());
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        if (pieces[p].isChecked && pieces[p].input == input.pieces[p]) continue;
        pieces[p].forget();
        if (auto checked = checkBoundary(input.pieces[p], arena, boundaries[p]); !checked) return checked;
        pieces[p].input = input.pieces[p];
        pieces[p].isChecked = true;
        ++work.checkedPieces;
    }
    return {};
}

Result<std::pmr::vector<CheckedSeam>> GarmentMesher::Memory::checkSeams(const MeshInput& input) {
    std::pmr::vector<CheckedSeam> seams(&arena);
    seams.reserve(input.seams.size());
    for (const SeamInput& seam : input.seams) {
        auto checked = checkedSeam(input, seam, boundaries, arena, garment.report.warnings);
        if (!checked) return tl::unexpected(checked.error());
        seams.push_back(std::move(*checked));
    }
    return seams;
}

Result<void> GarmentMesher::Memory::layLattice(const MeshInput& input, std::span<const CheckedSeam> seams,
                                               std::size_t piece, const GrainStretches& stretches) {
    PieceMemory& memory = pieces[piece];
    const std::pmr::vector<Vec2> ends = seamEnds(seams, static_cast<int>(piece), boundaries[piece], arena);
    if (!memory.isLaid || memory.seamEnds != ends || memory.stretches != stretches) {
        memory.isLaid = memory.isMeshed = false;
        memory.spacings.clear();
        memory.seamEnds = ends;
        memory.stretches = stretches;
        if (auto laid = layer.run(input.pieces[piece], boundaries[piece], ends, stretches, arena, memory.laid); !laid)
            return laid;
        memory.isLaid = true;
    }
    auto& said = garment.report.warnings;
    said.insert(said.end(), memory.laid.warnings.begin(), memory.laid.warnings.end());
    return {};
}

/// Regions are snapped before the border is divided, because they say how finely; without regions it is the other way
/// round, and lines can pass through whatever nodes the seams ask for.
Result<BoundaryDivision> GarmentMesher::Memory::divide(const MeshInput& input, std::span<const CheckedSeam> seams) {
    const auto points = fixedPoints(input, boundaries, seams, arena);
    if (!points) return tl::unexpected(points.error());
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        if (!input.pieces[p].regions.empty())
            if (auto laid =
                    layLattice(input, seams, p, grainStretches(input.pieces[p], boundaries[p], (*points)[p], arena));
                !laid)
                return tl::unexpected(laid.error());
    const SpacingAlong spacing = [this](int piece, int loop, int edge, double from, double to) {
        return pieces[at(piece)].spacingAlong(boundaries[at(piece)], loop, edge, from, to);
    };
    std::pmr::vector<BorderMemory*> borders(&arena);
    for (PieceMemory& piece : pieces) borders.push_back(&piece.border);
    auto division = divideBorders(input, boundaries, seams, *points, spacing, arena, borders);
    if (!division) return division;
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        if (input.pieces[p].regions.empty())
            if (auto laid =
                    layLattice(input, seams, p,
                               division->grainStretches(input.pieces[p], static_cast<int>(p), boundaries[p], arena));
                !laid)
                return tl::unexpected(laid.error());
    return division;
}

Result<void> GarmentMesher::Memory::meshPiece(const MeshInput& input, std::size_t piece) {
    PieceMemory& memory = pieces[piece];
    const FrozenBorder& border = memory.border.known;
    const auto start = std::chrono::steady_clock::now();
    std::unique_ptr<PieceMesher> mesher = takeMesher();
    auto done = mesher->run(input.pieces[piece], boundaries[piece], border.nodes, border.seeds, memory.laid.lattice,
                            garment.pieces[piece]);
    giveBack(std::move(mesher));
    if (!done) return done;
    const double seconds = secondsSince(start);
    PieceReport& report = garment.report.pieces[piece];
    reportOn(input.pieces[piece], boundaries[piece], border.nodes, garment.pieces[piece], settings.judged, report);
    report.seconds = seconds;
    report.regions = memory.laid.regions;
    memory.isMeshed = true;
    return {};
}

std::unique_ptr<PieceMesher> GarmentMesher::Memory::takeMesher() {
    const std::lock_guard lock(guard);
    if (idle.empty()) return std::make_unique<PieceMesher>();
    auto mesher = std::move(idle.back());
    idle.pop_back();
    return mesher;
}

void GarmentMesher::Memory::giveBack(std::unique_ptr<PieceMesher> mesher) {
    const std::lock_guard lock(guard);
    idle.push_back(std::move(mesher));
}

/// Each piece on its own: the result does not depend on the threads.
Result<void> GarmentMesher::Memory::meshPieces(const MeshInput& input) {
    std::pmr::vector<std::size_t> changed(&arena);
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        PieceMemory& piece = pieces[p];
        if (BorderMemory& border = piece.border; border.isNext) {
            const bool same =
                border.isKnown && border.known.nodes == border.next.nodes && border.known.seeds == border.next.seeds;
            piece.isMeshed = piece.isMeshed && same;
            std::swap(border.known, border.next);
            border.isKnown = true;
        }
        if (!piece.isMeshed) changed.push_back(p);
    }
    std::pmr::vector<Result<void>> done(changed.size(), &arena);
    const auto meshOne = [&](int i) { done[at(i)] = meshPiece(input, changed[at(i)]); };
    team.run(static_cast<int>(changed.size()), std::ref(meshOne)); // a reference: std::function takes no memory for it
    for (const Result<void>& result : done)
        if (!result) return result;
    work.meshedPieces = static_cast<int>(changed.size());
    return {};
}

void GarmentMesher::Memory::sew(const MeshInput& input, std::span<const CheckedSeam> seams,
                                const BoundaryDivision& division) {
    garment.seams.resize(seams.size());
    garment.report.seams.resize(seams.size());
    for (std::size_t s = 0; s < seams.size(); ++s) {
        meshing::sew(seams[s], division, garment.pieces, arena, garment.seams[s]);
        judgeSeam(input.seams[s], seams[s], garment.seams[s], division, garment.pieces, garment.report.seams[s]);
    }
}

Result<const GarmentMesh*> GarmentMesher::Memory::mesh(const MeshInput& input) {
    work = {};
    arena.rewind();
    garment.report.warnings.clear();
    if (auto checked = checkPieces(input); !checked) return tl::unexpected(checked.error());
    const auto seams = checkSeams(input);
    if (!seams) return tl::unexpected(seams.error());
    const auto division = divide(input, *seams);
    if (!division) return tl::unexpected(division.error());
    if (auto meshed = meshPieces(input); !meshed) return tl::unexpected(meshed.error());
    garment.report.total = totalOf(garment.report.pieces);
    sew(input, *seams, *division);
    return &garment;
}

GarmentMesher::GarmentMesher(MeshSettings settings) : memory_(std::make_unique<Memory>()) {
    memory_->settings = settings;
}
GarmentMesher::~GarmentMesher() = default;
GarmentMesher::GarmentMesher(GarmentMesher&&) noexcept = default;
GarmentMesher& GarmentMesher::operator=(GarmentMesher&&) noexcept = default;

Result<const GarmentMesh*> GarmentMesher::mesh(const MeshInput& input) {
    return memory_->mesh(input);
}

void GarmentMesher::forget() {
    for (PieceMemory& piece : memory_->pieces) piece.forget();
}

GarmentMesh GarmentMesher::take() && {
    return std::move(memory_->garment);
}

MeshingWork GarmentMesher::work() const {
    return memory_->work;
}

Result<GarmentMesh> meshGarment(const MeshInput& input, const MeshSettings& settings) {
    GarmentMesher mesher(settings);
    if (const auto mesh = mesher.mesh(input); !mesh) return tl::unexpected(mesh.error());
    return std::move(mesher).take();
}

} // namespace toile::meshing
