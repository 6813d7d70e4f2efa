// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/BodyPoses.h"

#include "core/io/BodyFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <tuple>

namespace toile::io {
namespace {

namespace fs = std::filesystem;

constexpr double samePlace = 1e-3; ///< of a vertex of the body in the first pose [m]

/// The vertex of a pose that is nearest to a place, by a grid.
class PlaceIndex {
public:
    explicit PlaceIndex(const std::vector<Vec3>& vertices) : vertices_(vertices) {
        for (int v = 0; v < std::ssize(vertices); ++v) cells_[cellOf(vertices[v])].push_back(v);
    }
    /// −1: none is so near as samePlace.
    [[nodiscard]] int nearest(const Vec3& p) const {
        const auto [cx, cy, cz] = cellOf(p);
        int best = -1;
        double least = samePlace * samePlace;
        for (long x = cx - 1; x <= cx + 1; ++x)
            for (long y = cy - 1; y <= cy + 1; ++y)
                for (long z = cz - 1; z <= cz + 1; ++z) {
                    const auto cell = cells_.find({x, y, z});
                    if (cell == cells_.end()) continue;
                    for (const int v : cell->second)
                        if (const double d = squaredLength(vertices_[v] - p); d < least) {
                            least = d;
                            best = v;
                        }
                }
        return best;
    }

private:
    using Cell = std::tuple<long, long, long>;
    static Cell cellOf(const Vec3& p) {
        const auto at = [](double x) { return std::lround(std::floor(x / samePlace)); };
        return {at(p.x), at(p.y), at(p.z)};
    }
    const std::vector<Vec3>& vertices_;
    std::map<Cell, std::vector<int>> cells_;
};

/// For each vertex of the body, which one of the first pose it is.
Result<std::vector<int>> verticesOf(const body::Body& body, const std::vector<Vec3>& first, const fs::path& file) {
    const PlaceIndex index(first);
    std::vector<int> found;
    found.reserve(body.mesh.vertices.size());
    for (const Vec3& v : body.mesh.vertices) {
        found.push_back(index.nearest(v));
        if (found.back() < 0)
            return fail(ErrorCode::invalidInput,
                        fmt::format("The first pose must be the avatar as it stands: it has no vertex within {:.0f} mm "
                                    "of ({:.3f}, {:.3f}, {:.3f}) m.",
                                    1000 * samePlace, v.x, v.y, v.z),
                        {.file = file.string()});
    }
    return found;
}

} // namespace

Result<std::vector<fs::path>> posesIn(const fs::path& folder) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem))
        if (isBodyFile(entry->path())) files.push_back(entry->path());
    if (problem)
        return fail(ErrorCode::io, fmt::format("The folder cannot be read: {}.", problem.message()),
                    {.file = folder.string()});
    if (files.size() < 2)
        return fail(ErrorCode::invalidInput, "Holds no two models: a motion needs two poses at least.",
                    {.file = folder.string()});
    std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
        return strverscmp(a.filename().c_str(), b.filename().c_str()) < 0;
    });
    return files;
}

Result<geometry::VertexMotion> readBodyPoses(const fs::path& folder, const body::Body& body, double step) {
    const auto files = posesIn(folder);
    if (!files) return tl::unexpected(files.error());
    const bool isHuman = !body.axes.empty(); // what is not may have any size, and is in metres
    auto first = readPose(files->front(), isHuman ? std::nullopt : std::optional(PoseReading{}));
    if (!first) return tl::unexpected(first.error());
    const auto vertices = verticesOf(body, first->vertices, files->front());
    if (!vertices) return tl::unexpected(vertices.error());

    geometry::VertexMotion motion{step, {}};
    for (const fs::path& file : *files) {
        const auto pose = readPose(file, first->reading);
        if (!pose) return tl::unexpected(pose.error());
        if (pose->vertices.size() != first->vertices.size())
            return fail(
                ErrorCode::invalidInput,
                fmt::format("Has {} vertices, the first pose has {}.", pose->vertices.size(), first->vertices.size()),
                {.file = file.string()});
        std::vector<Vec3>& places = motion.poses.emplace_back();
        places.reserve(vertices->size());
        for (const int v : *vertices) places.push_back(pose->vertices[v]);
    }
    return motion;
}

} // namespace toile::io
