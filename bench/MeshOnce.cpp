// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes the blouse's back once and prints its spacing [mm], cells and border nodes: for counting instructions.
//
//   toile-mesh-once SPACING
#include "bench/MeshInputs.h"
#include "core/meshing/GarmentMesh.h"

#include <cstdio>

using namespace toile;

int main(int count, char** arguments) {
    const double spacing = count == 2 ? std::atof(arguments[1]) * 1e-3 : 0;
    if (!(spacing > 0)) return std::fprintf(stderr, "usage: toile-mesh-once SPACING\n"), 2;
    const auto mesh = meshing::meshGarment(bench::blouseBack(spacing), {.judged = false});
    if (!mesh) return std::fprintf(stderr, "%s\n", toString(mesh.error()).c_str()), 1;
    std::size_t border = 0;
    for (const auto& loop : mesh->pieces[0].loops)
        for (const meshing::EdgeNodes& edge : loop) border += edge.size() - 1;
    const auto& total = mesh->report.total;
    std::printf("%g %d %zu\n", 1000 * spacing, total.quads + total.triangles, border);
    return 0;
}
