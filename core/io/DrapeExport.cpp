// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/DrapeExport.h"

#include "core/base/AtomicFile.h"
#include "core/base/Extension.h"

#include <algorithm>
#include <array>

namespace toile::io {
namespace {

using simulation::FrameTopology;
using Writer = std::string (*)(const FrameTopology&, std::span<const Vec3>);

constexpr std::array<std::pair<const char*, Writer>, 4> writers{
    {{".glb", drapeGlb}, {".obj", drapeObj}, {".ply", drapePly}, {".stl", drapeStl}}};

Result<void> checked(const FrameTopology& topology, std::span<const Vec3> positions) {
    if (topology.triangles.empty() || positions.size() != topology.material.size())
        return fail(ErrorCode::invalidInput, "There is no drape to write.");
    if (!std::ranges::all_of(positions, [](const Vec3& p) { return isFinite(p); }))
        return fail(ErrorCode::invalidInput, "The drape is not written: a position is not a finite number.");
    return {};
}

} // namespace

Result<void> writeDrape(const std::filesystem::path& path, const FrameTopology& topology,
                        std::span<const Vec3> positions) {
    const std::string extension = extensionOf(path);
    const auto writer =
        std::ranges::find_if(writers, [&](const auto& candidate) { return extension == candidate.first; });
    if (writer == writers.end())
        return fail(ErrorCode::unsupported, "A drape is written as .glb, .obj, .ply or .stl.", {.file = path.string()});
    if (auto sound = checked(topology, positions); !sound)
        return fail(sound.error().code, sound.error().text, {.file = path.string()});
    return writeFileAtomically(path, writer->second(topology, positions));
}

} // namespace toile::io
