// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes two pieces that are sewn side to side, with the installed mesher: docs/how-to/use-the-mesher.md.
#include "core/meshing/GarmentMesh.h"

#include <cstdio>

using namespace toile::meshing;

int main() {
    PieceInput back;
    back.label = "Back";
    back.spacing = 0.02;                                              // ε_m, the largest distance of nodes [m]
    back.outline = {{Curve{{0, 0}, {0.5, 0}, {}}, {}, "hem"},         // edge after edge, counter-clockwise
                    {Curve{{0.5, 0}, {0.5, 0.6}, {}}, {0.4}, "side"}, // a notch at 40 % of its length
                    {Curve{{0.5, 0.6}, {0, 0.6}, {}}, {}, "yoke seam"},
                    {Curve{{0, 0.6}, {0, 0}, {}}, {}, "other side"}};
    back.regions = {{"shoulder", {{0, 0.4}, {0.5, 0.4}, {0.5, 0.6}, {0, 0.6}}, {}, 1}}; // spacing ε_m / 2¹

    PieceInput front = back;
    front.label = "Front";
    front.regions.clear();

    MeshInput input{{back, front}, {}};
    input.seams = {{"side", {{{{0, 0, 1}}, {{1, 0, 1}}}}, {}}}; // piece, loop, edge; no ease declared
    const toile::Result<GarmentMesh> garment = meshGarment(input);
    if (!garment) {
        std::fprintf(stderr, "%s\n", toString(garment.error()).c_str()); // names piece, edge and point
        return 1;
    }
    for (const auto& [a, b] : garment->seams[0].pairs) // from the start of the seam to its end
        std::printf("sew node %d of piece %d to node %d of piece %d\n", a.node, a.piece, b.node, b.piece);

    for (const PieceReport& piece : garment->report.pieces)
        std::printf("%s: %d nodes, %d rectangles, %d slaves\n", piece.label.c_str(), piece.nodes, piece.rectangles,
                    piece.slaves);
    return 0;
}
