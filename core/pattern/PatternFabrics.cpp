// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFabrics.h"

#include "core/material/Plies.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::pattern {
namespace {

auto positionOf(const Pattern& pattern, const FabricId& id) {
    return std::ranges::find_if(pattern.fabrics, [&](const auto& fabric) { return fabric->id == id; });
}

Error unknownFabric(const FabricId& id) {
    return {ErrorCode::notFound, fmt::format("There is no fabric \"{}\".", id.value), {}};
}

} // namespace

Result<Pattern> addFabric(const Pattern& pattern, Fabric fabric) {
    if (fabric.id.empty()) return fail(ErrorCode::invalidInput, "A fabric needs an id.");
    if (findFabric(pattern, fabric.id))
        return fail(ErrorCode::invalidInput, fmt::format("There is a fabric \"{}\" already.", fabric.id.value));
    return material::checked(fabric).map([&] {
        Pattern next = pattern;
        next.fabrics.emplace_back(std::move(fabric));
        return next;
    });
}

Result<Pattern> replaceFabric(const Pattern& pattern, Fabric fabric) {
    const auto found = positionOf(pattern, fabric.id);
    if (found == pattern.fabrics.end()) return tl::unexpected<Error>(unknownFabric(fabric.id));
    return material::checked(fabric).map([&] {
        Pattern next = pattern;
        next.fabrics[static_cast<std::size_t>(found - pattern.fabrics.begin())] = std::move(fabric);
        return next;
    });
}

Result<Pattern> removeFabric(const Pattern& pattern, const FabricId& fabric) {
    const auto found = positionOf(pattern, fabric);
    if (found == pattern.fabrics.end()) return tl::unexpected<Error>(unknownFabric(fabric));
    for (const auto& piece : pattern.pieces)
        if (piece->fabric == fabric)
            return fail(ErrorCode::invalidInput, fmt::format("The fabric \"{}\" is in use.", (*found)->name),
                        placeOf(*piece));
    Pattern next = pattern;
    next.fabrics.erase(next.fabrics.begin() + (found - pattern.fabrics.begin()));
    return next;
}

Result<Pattern> setPieceFabric(const Pattern& pattern, const PieceId& piece, const FabricId& fabric) {
    if (!findFabric(pattern, fabric)) return tl::unexpected<Error>(unknownFabric(fabric));
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        p.fabric = fabric;
        return {};
    });
}

Result<Pattern> setInterfacing(const Pattern& pattern, const PieceId& piece,
                               const std::optional<Interfacing>& interfacing) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (interfacing)
            if (const auto ok = material::checked(*interfacing); !ok)
                return fail(ErrorCode::invalidInput, ok.error().text, placeOf(p));
        p.interfacing = interfacing;
        return {};
    });
}

Result<Pattern> setPlies(const Pattern& pattern, const PieceId& piece, int plies) {
    return changed(pattern, piece, [&](Piece& p) -> Result<void> {
        if (plies < 1 || plies > mostPlies)
            return fail(ErrorCode::invalidInput, fmt::format("A piece has 1 to {} plies.", mostPlies), placeOf(p));
        p.plies = plies;
        return {};
    });
}

std::optional<Fabric> clothOf(const Pattern& pattern, const Piece& piece) {
    const Fabric* fabric = findFabric(pattern, piece.fabric);
    if (!fabric) return std::nullopt;
    const Fabric ply = piece.interfacing ? material::fused(*fabric, *piece.interfacing) : *fabric;
    Fabric cloth = material::backed(ply, *fabric, piece.plies - 1);
    if (piece.strengthened)
        for (double* bending : {&cloth.warpBending, &cloth.weftBending, &cloth.biasBending}) *bending *= strengthening;
    return cloth;
}

} // namespace toile::pattern
