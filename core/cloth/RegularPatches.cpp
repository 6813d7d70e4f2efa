// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/RegularPatches.h"

namespace toile::cloth {

material::Fabric unequalWeave() {
    material::Fabric fabric;
    fabric.name = "test weave";
    fabric.arealDensity = 0.2;
    fabric.warpStiffness = 900;
    fabric.weftStiffness = 600;
    fabric.shearStiffness = 30;
    fabric.warpBending = 30e-6;
    fabric.weftBending = 20e-6;
    fabric.biasBending = 22e-6;
    return fabric;
}

std::vector<double> evenLines(double extent, int cells) {
    std::vector<double> lines;
    for (int i = 0; i <= cells; ++i) lines.push_back(extent * i / cells);
    return lines;
}

Patch gridPatch(const std::vector<double>& weft, const std::vector<double>& warp) {
    Patch patch;
    const int columns = static_cast<int>(weft.size());
    for (double v : warp)
        for (double u : weft) {
            patch.particles.push_back(static_cast<int>(patch.material.size()));
            patch.material.push_back({u, v});
        }
    for (int j = 0; j + 1 < static_cast<int>(warp.size()); ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const int n = j * columns + i;
            patch.rectangles.push_back({{n, n + 1, n + columns + 1, n + columns}, {}});
        }
    return patch;
}

Patch trianglePatch(const std::vector<double>& weft, const std::vector<double>& warp) {
    Patch patch = gridPatch(weft, warp);
    for (const auto& cell : patch.rectangles) {
        const auto& n = cell.nodes;
        patch.triangles.push_back({{n[0], n[1], n[2]}, {}});
        patch.triangles.push_back({{n[0], n[2], n[3]}, {}});
    }
    patch.rectangles.clear();
    return patch;
}

Patch twoRegionPatch(double width, int coarseColumns, double split, int coarseRows, double height, int fineRows,
                     int ratio) {
    Patch coarse = gridPatch(evenLines(width, coarseColumns), evenLines(split, coarseRows));
    std::vector<double> fineWarp;
    for (int j = 0; j <= fineRows; ++j) fineWarp.push_back(split + (height - split) * j / fineRows);
    const Patch fine = gridPatch(evenLines(width, ratio * coarseColumns), fineWarp);
    const int fineColumns = ratio * coarseColumns + 1, firstTop = coarseRows * (coarseColumns + 1);
    std::vector<int> nodeOf(fine.material.size());
    for (int n = 0; n < static_cast<int>(fine.material.size()); ++n) {
        if (n < fineColumns && n % ratio == 0) {
            nodeOf[n] = firstTop + n / ratio;
            continue;
        }
        nodeOf[n] = static_cast<int>(coarse.material.size());
        coarse.particles.push_back(nodeOf[n]);
        coarse.material.push_back(fine.material[n]);
        if (n < fineColumns) {
            const double t = double(n % ratio) / ratio;
            coarse.slaves.push_back({nodeOf[n], {{firstTop + n / ratio, 1 - t}, {firstTop + n / ratio + 1, t}}});
        }
    }
    for (auto cell : fine.rectangles) {
        for (int& n : cell.nodes) n = nodeOf[n];
        coarse.rectangles.push_back(cell);
    }
    return coarse;
}

std::vector<Vec3> flatPositions(const Patch& patch) {
    std::vector<Vec3> positions(patch.material.size());
    for (std::size_t n = 0; n < positions.size(); ++n)
        positions[patch.particles[n]] = {patch.material[n].x, patch.material[n].y, 0};
    return positions;
}

} // namespace toile::cloth
