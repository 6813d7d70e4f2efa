// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/Ids.h"

#include <algorithm>
#include <charconv>

namespace toile::pattern {
namespace {

/// The number at the end of an id; 0 when there is none, or none that an id of ours could have.
int numberOf(const std::string& id) {
    const std::size_t digits = id.find_last_not_of("0123456789") + 1; // npos + 1 = 0
    int number = 0;
    std::from_chars(id.data() + digits, id.data() + id.size(), number);
    return std::min(number, 1'000'000'000);
}

} // namespace

int firstFreeNumber(const Pattern& pattern) {
    int largest = 0;
    const auto note = [&](const auto& id) { largest = std::max(largest, numberOf(id.value)); };
    const auto noteContour = [&](const Contour& contour) {
        for (const Vertex& vertex : contour.vertices) note(vertex.id);
        for (const Edge& edge : contour.edges) note(edge.id);
    };
    for (const auto& piece : pattern.pieces) {
        note(piece->id);
        noteContour(piece->outline);
        for (const Contour& hole : piece->holes) noteContour(hole);
        for (const Region& region : piece->regions) note(region.id);
        for (const Fold& fold : piece->folds) note(fold.id);
    }
    for (const Seam& seam : pattern.seams) note(seam.id);
    for (const auto& fabric : pattern.fabrics) note(fabric->id);
    for (const Pin& pin : pattern.pins) note(pin.id);
    for (const Tack& tack : pattern.tacks) note(tack.id);
    return largest + 1;
}

} // namespace toile::pattern
