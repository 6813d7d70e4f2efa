// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/PinNodes.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::simulation {

/// The first node of the edge that leaves its vertex.
Result<meshing::NodeRef> nodeOf(const pattern::Pin& pin, const pattern::Pattern& pattern,
                                const meshing::GarmentMesh& mesh) {
    const Place place{.object = fmt::format("pin \"{}\"", pin.id.value)};
    const auto at = std::ranges::find_if(pattern.pieces, [&](const auto& piece) { return piece->id == pin.piece; });
    if (at == pattern.pieces.end())
        return fail(ErrorCode::invalidInput, fmt::format("There is no piece \"{}\".", pin.piece.value), place);
    const int index = static_cast<int>(at - pattern.pieces.begin());
    const pattern::Piece piece = pattern::resolved(pattern, **at);
    const auto& loops = mesh.pieces[index].loops;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        const pattern::Contour& contour = loop == 0 ? piece.outline : piece.holes[loop - 1];
        for (std::size_t vertex = 0; vertex < contour.vertices.size(); ++vertex)
            if (contour.vertices[vertex].id == pin.vertex)
                return meshing::NodeRef{index, loops[loop][vertex].front().node};
    }
    return fail(ErrorCode::invalidInput,
                fmt::format("Piece \"{}\" has no vertex \"{}\".", piece.name, pin.vertex.value), place);
}

} // namespace toile::simulation
