// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/Editing.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::pattern {

Place placeOf(const Piece& piece) {
    return {.object = fmt::format("piece \"{}\"", piece.name)};
}
Place placeOf(const Seam& seam) {
    return {.object = fmt::format("seam \"{}\"", seam.name)};
}
Place placeOf(const Piece& piece, const Fold& fold) {
    return {.object = fmt::format("piece \"{}\", fold \"{}\"", piece.name, fold.name)};
}

Result<Pattern> changed(const Pattern& pattern, const PieceId& id, const std::function<Result<void>(Piece&)>& change) {
    const auto found = std::ranges::find_if(pattern.pieces, [&](const auto& piece) { return piece->id == id; });
    if (found == pattern.pieces.end())
        return fail(ErrorCode::notFound, fmt::format("There is no piece \"{}\".", id.value));
    Piece piece = **found;
    if (auto done = change(piece); !done) return tl::unexpected<Error>(std::move(done).error());
    Pattern next = pattern;
    next.pieces[static_cast<std::size_t>(found - pattern.pieces.begin())] = std::move(piece);
    return next;
}

Result<Pattern> changedShape(const Pattern& pattern, const PieceId& id,
                             const std::function<Result<void>(Piece&)>& change) {
    return changed(pattern, id, [&](Piece& piece) -> Result<void> {
        if (piece.mirror)
            return fail(ErrorCode::invalidInput, "This piece is a mirror image: edit the piece it is made from.",
                        placeOf(piece));
        return change(piece);
    });
}

Result<Pattern> changed(const Pattern& pattern, const SeamId& id, const std::function<Result<void>(Seam&)>& change) {
    Pattern next = pattern;
    const auto found = std::ranges::find_if(next.seams, [&](const Seam& seam) { return seam.id == id; });
    if (found == next.seams.end()) return fail(ErrorCode::notFound, fmt::format("There is no seam \"{}\".", id.value));
    if (auto done = change(*found); !done) return tl::unexpected<Error>(std::move(done).error());
    return next;
}

} // namespace toile::pattern
