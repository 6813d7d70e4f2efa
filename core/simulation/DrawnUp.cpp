// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/DrawnUp.h"

#include "core/pattern/PatternSeams.h"

#include <algorithm>

namespace toile::simulation {
namespace {

/// A stitch whose sides differ by less is left alone [–]: as much may the sides of a plain seam differ.
constexpr double leastFullness = 0.003;

bool isEased(const pattern::Seam& seam) {
    return std::ranges::any_of(seam.sections, [](const pattern::SeamSection& s) { return s.ease != 0; });
}

bool isWoven(const pattern::Pattern& pattern, int piece) {
    const material::Fabric* fabric = pattern::findFabric(pattern, pattern.pieces[piece]->fabric);
    return fabric && fabric->kind == material::FabricKind::woven;
}

} // namespace

std::vector<std::vector<cloth::DrawnSide>> drawnUp(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                                   const std::vector<bool>& mergedSeams) {
    std::vector<std::vector<cloth::DrawnSide>> drawn(mesh.pieces.size());
    for (std::size_t seam = 0; seam < mergedSeams.size(); ++seam) {
        const bool gathered = pattern::isGathered(pattern.seams[seam]);
        if (!mergedSeams[seam] || !(gathered || isEased(pattern.seams[seam]))) continue;
        const auto& pairs = mesh.seams[seam].pairs;
        for (std::size_t stitch = 1; stitch < pairs.size(); ++stitch) {
            const auto lengthOf = [&](int side) {
                const auto& [piece, node] = pairs[stitch][side];
                const auto& material = mesh.pieces[piece].material;
                return geometry::distance(material[pairs[stitch - 1][side].node], material[node]);
            };
            const double a = lengthOf(0), b = lengthOf(1);
            const int longer = a > b ? 0 : 1;
            const double factor = std::min(a, b) / std::max(a, b);
            if (!(factor < 1 - leastFullness)) continue;
            if (!gathered && !isWoven(pattern, pairs[stitch][1 - longer].piece)) continue;
            const meshing::NodeRef &from = pairs[stitch - 1][longer], &to = pairs[stitch][longer];
            if (from.piece == to.piece) drawn[from.piece].push_back({std::minmax({from.node, to.node}), factor});
        }
    }
    for (auto& sides : drawn) std::ranges::sort(sides);
    return drawn;
}

} // namespace toile::simulation
