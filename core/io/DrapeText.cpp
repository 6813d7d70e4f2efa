// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/DrapeExport.h"
#include "core/io/DrapeFaces.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>

namespace toile::io {
namespace {

using simulation::FrameTopology;

void appendFloat(std::string& bytes, double value) {
    const auto real = static_cast<float>(value);
    bytes.append(reinterpret_cast<const char*>(&real), sizeof real);
}

void append(std::string& bytes, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) appendFloat(bytes, v[axis]);
}

template <class Integer>
void appendInteger(std::string& bytes, Integer value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A name on one line.
std::string oneLine(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return name.empty() ? "piece" : name;
}

} // namespace

std::string drapeObj(const FrameTopology& topology, std::span<const Vec3> positions) {
    std::string text = "# drape; metres, y up; vt = flat pattern in metres\n";
    const auto out = std::back_inserter(text);
    for (const Vec3& p : positions) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    for (const Vec2& m : topology.material) fmt::format_to(out, "vt {:.9g} {:.9g}\n", m.x, m.y);
    for (const Vec3& n : drapeNormals(topology, positions))
        fmt::format_to(out, "vn {:.5f} {:.5f} {:.5f}\n", n.x, n.y, n.z);
    for (const FrameTopology::PieceRange& piece : topology.pieces) {
        fmt::format_to(out, "o {0}\ng {0}\n", oneLine(piece.name));
        for (const std::vector<int>& face : facesOf(topology, piece)) {
            text += 'f';
            for (const int corner : face) fmt::format_to(out, " {0}/{0}/{0}", corner + 1);
            text += '\n';
        }
    }
    return text;
}

std::string drapePly(const FrameTopology& topology, std::span<const Vec3> positions) {
    std::string bytes = fmt::format("ply\nformat binary_little_endian 1.0\ncomment drape; metres, y up; s and t = flat "
                                    "pattern in metres\nelement vertex {}\n",
                                    positions.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
        bytes += fmt::format("property float {}\n", name);
    bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nproperty int piece\nend_header\n",
                         topology.triangles.size());
    const std::vector<Vec3> normals = drapeNormals(topology, positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        append(bytes, positions[i]);
        append(bytes, normals[i]);
        appendFloat(bytes, topology.material[i].x);
        appendFloat(bytes, topology.material[i].y);
    }
    for (std::size_t piece = 0; piece < topology.pieces.size(); ++piece)
        for (const auto& triangle : trianglesOf(topology, topology.pieces[piece])) {
            appendInteger(bytes, std::uint8_t{3});
            for (const int corner : triangle) appendInteger(bytes, static_cast<std::int32_t>(corner));
            appendInteger(bytes, static_cast<std::int32_t>(piece));
        }
    return bytes;
}

std::string drapeStl(const FrameTopology& topology, std::span<const Vec3> positions) {
    std::string bytes = "drape; metres, y up";
    bytes.resize(80, ' ');
    appendInteger(bytes, static_cast<std::uint32_t>(topology.triangles.size()));
    for (const auto& [a, b, c] : topology.triangles) {
        const Vec3 area = cross(positions[b] - positions[a], positions[c] - positions[a]);
        append(bytes, length(area) > 0 ? normalized(area) : Vec3{});
        for (const int corner : {a, b, c}) append(bytes, positions[corner]);
        appendInteger(bytes, std::uint16_t{0});
    }
    return bytes;
}

} // namespace toile::io
