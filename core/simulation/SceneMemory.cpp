// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SceneMemory.h"

#include "core/base/Memory.h"

#include <fmt/format.h>

namespace toile::simulation {
namespace {

std::size_t nodesOf(const meshing::GarmentMesh& mesh) {
    std::size_t nodes = 0;
    for (const meshing::PieceMesh& piece : mesh.pieces) nodes += piece.nodes.size();
    return nodes;
}

} // namespace

std::size_t estimatedBytes(const meshing::GarmentMesh& mesh) {
    constexpr std::size_t perNode = 4300; // docs/simulation.md, "Memory"
    return perNode * nodesOf(mesh);
}

Result<void> checkedMemory(const Scene& scene, const meshing::GarmentMesh& mesh) {
    const std::size_t needed = estimatedBytes(mesh), room = scene.memory.value_or(availableMemory());
    if (needed <= room) return {};
    const auto megabytes = [](std::size_t bytes) { return 1e-6 * static_cast<double>(bytes); };
    return fail(ErrorCode::tooLarge,
                fmt::format("A garment of {} nodes takes about {:.0f} MB to simulate; {:.0f} MB {}: choose a larger "
                            "spacing, or allow more memory.",
                            nodesOf(mesh), megabytes(needed), megabytes(room),
                            scene.memory ? "are allowed" : "can be had"));
}

std::optional<std::size_t> factorBytesOf(const Scene& scene, const meshing::GarmentMesh& mesh) {
    if (!scene.memory) return std::nullopt;
    const std::size_t taken = estimatedBytes(mesh);
    return *scene.memory > taken ? *scene.memory - taken : 0;
}

} // namespace toile::simulation
