// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/IsoSurface.h"

#include "core/body/HalfMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace toile::body {

namespace {

using geometry::TriangleIndices;
using geometry::TriangleMesh;

struct Lattice {
    int i = 0, j = 0, k = 0;
    friend auto operator<=>(const Lattice&, const Lattice&) = default;
};

constexpr Lattice step(Lattice at, int axis, int by) {
    (axis == 0 ? at.i : axis == 1 ? at.j : at.k) += by;
    return at;
}

/// The pieces of surface in one cell; each gets a vertex of its own, so that thin parts stay manifold
/// (Nielson 2004).
struct Sheets {
    int count = 0;
    std::array<int, 12> ofEdge{-1, -1, -1, -1, -1, -1,
                               -1, -1, -1, -1, -1, -1}; ///< sheet through each edge, −1 = not crossed
    std::array<int, 4> vertex{};                        ///< index in the mesh
};

/// Surface nets on the half x ≥ 0. Sample (i, j, k) stands at x = (i + ½)·h and is the uppermost corner of
/// cell (i, j, k), so that the cells i = 0 straddle the plane of symmetry.
class HalfNet {
public:
    HalfNet(const Field& field, const Vec3& origin, double spacing) : field_(field), origin_(origin), h_(spacing) {}

    /// Walks over the surface from the first sign change above the seed.
    void follow() {
        Lattice cell{0, 0, 0};
        while (value(cell) < 0) ++cell.j; // the field grows without bound above the body
        std::vector<Lattice> waiting{cell};
        while (!waiting.empty()) {
            const Lattice at = waiting.back();
            waiting.pop_back();
            if (at.i < 0 || sheets_.contains(at) || !crosses(at)) continue;
            sheets_.emplace(at, sheetsIn(at));
            for (int axis = 0; axis < 3; ++axis)
                for (const int by : {-1, 1}) waiting.push_back(step(at, axis, by));
        }
    }

    [[nodiscard]] TriangleMesh triangles() {
        TriangleMesh mesh;
        for (auto& [cell, sheets] : sheets_)
            for (int sheet = 0; sheet < sheets.count; ++sheet) {
                sheets.vertex[static_cast<std::size_t>(sheet)] = static_cast<int>(mesh.vertices.size());
                mesh.vertices.push_back(vertexIn(cell, sheets, sheet));
            }
        for (const auto& [cell, sheets] : sheets_)
            for (int axis = 0; axis < 3; ++axis) addQuad(mesh, cell, axis);
        return mesh;
    }

private:
    [[nodiscard]] Vec3 place(Lattice s) const { return {(s.i + 0.5) * h_, origin_.y + s.j * h_, origin_.z + s.k * h_}; }
    /// Samples left of the plane are those of their mirror image.
    double value(Lattice s) {
        if (s.i < 0) s.i = -1 - s.i;
        const auto [found, isNew] = values_.try_emplace(s, 0.0);
        if (isNew) found->second = field_(place(s));
        return found->second;
    }
    /// The corners of a cell are the samples one back to its own in each direction.
    [[nodiscard]] static Lattice corner(Lattice cell, int c) {
        return {cell.i - 1 + (c & 1), cell.j - 1 + (c >> 1 & 1), cell.k - 1 + (c >> 2 & 1)};
    }
    bool crosses(Lattice cell) {
        int inside = 0;
        for (int c = 0; c < 8; ++c) inside += value(corner(cell, c)) < 0;
        return inside > 0 && inside < 8;
    }
    /// The crossed edges of a cell, joined where a face connects them. A face crossed four times connects the
    /// two edges at each inside corner: both cells at that face decide alike.
    Sheets sheetsIn(Lattice cell) {
        std::array<bool, 8> inside{};
        for (int c = 0; c < 8; ++c) inside[static_cast<std::size_t>(c)] = value(corner(cell, c)) < 0;
        std::array<int, 12> root{};
        for (int e = 0; e < 12; ++e) root[static_cast<std::size_t>(e)] = e;
        const auto join = [&](int a, int b) {
            const int from = root[static_cast<std::size_t>(a)], to = root[static_cast<std::size_t>(b)];
            std::ranges::replace(root, from, to);
        };
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side) joinOnFace(inside, axis, side, join);
        Sheets sheets;
        for (int e = 0; e < 12; ++e) {
            const auto [low, high] = cornersOf(e);
            if (inside[static_cast<std::size_t>(low)] == inside[static_cast<std::size_t>(high)]) continue;
            const int r = root[static_cast<std::size_t>(e)];
            int& sheet = sheets.ofEdge[static_cast<std::size_t>(e)];
            for (int earlier = 0; earlier < e; ++earlier)
                if (sheets.ofEdge[static_cast<std::size_t>(earlier)] >= 0 &&
                    root[static_cast<std::size_t>(earlier)] == r)
                    sheet = sheets.ofEdge[static_cast<std::size_t>(earlier)];
            if (sheet < 0) sheet = sheets.count++;
        }
        return sheets;
    }
    template <class Join>
    static void joinOnFace(const std::array<bool, 8>& inside, int axis, int side, const Join& join) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
        const std::array<int, 4> ring{base, base | u, base | u | v, base | v};
        const auto isIn = [&](std::size_t c) { return inside[static_cast<std::size_t>(ring[c % 4])]; };
        std::vector<int> crossed; // edges in order round the face, first the one after an outside corner
        std::size_t start = 0;
        while (start < 4 && (isIn(start) || !isIn(start + 1))) ++start;
        if (start == 4) return; // not crossed
        for (std::size_t c = start; c < start + 4; ++c)
            if (isIn(c) != isIn(c + 1)) crossed.push_back(edgeBetween(ring[c % 4], ring[(c + 1) % 4]));
        for (std::size_t c = 0; c + 1 < crossed.size(); c += 2) join(crossed[c], crossed[c + 1]);
    }
    /// Edge number: four per axis, by the two other bits of its corners.
    static int edgeBetween(int a, int b) {
        const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2, low = a & b;
        return 4 * axis + (low >> (axis + 1) % 3 & 1) + 2 * (low >> (axis + 2) % 3 & 1);
    }
    static std::pair<int, int> cornersOf(int edge) {
        const int axis = edge / 4, low = (edge & 1) << (axis + 1) % 3 | (edge >> 1 & 1) << (axis + 2) % 3;
        return {low, low | 1 << axis};
    }
    /// The mean of a sheet's crossings; on the plane of symmetry for cells that straddle it.
    Vec3 vertexIn(Lattice cell, const Sheets& sheets, int sheet) {
        Vec3 sum;
        int count = 0;
        for (int e = 0; e < 12; ++e) {
            if (sheets.ofEdge[static_cast<std::size_t>(e)] != sheet) continue;
            const auto [a, b] = cornersOf(e);
            const Lattice low = corner(cell, a), high = corner(cell, b);
            const double fa = value(low), fb = value(high);
            sum += lerp(place(low), place(high), fa / (fa - fb));
            ++count;
        }
        Vec3 mean = sum / count;
        if (cell.i == 0) mean.x = 0;
        return mean;
    }
    /// The quad round the edge that comes along the axis to a cell's own sample, if the surface crosses that
    /// edge.
    void addQuad(TriangleMesh& mesh, Lattice cell, int axis) {
        const bool inside = value(step(cell, axis, -1)) < 0;
        if (inside == (value(cell) < 0)) return;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const std::array<Lattice, 4> round{cell, step(cell, u, 1), step(step(cell, u, 1), v, 1), step(cell, v, 1)};
        std::array<int, 4> q{};
        for (std::size_t c = 0; c < 4; ++c) {
            const Sheets& sheets = sheets_.at(round[c]);
            const Lattice low = corner(round[c], 0); // where the edge lies in this cell
            const int u1 = (u == 0 ? cell.i - low.i : u == 1 ? cell.j - low.j : cell.k - low.k);
            const int v1 = (v == 0 ? cell.i - low.i : v == 1 ? cell.j - low.j : cell.k - low.k);
            const int sheet = sheets.ofEdge[static_cast<std::size_t>(4 * axis + u1 + 2 * v1)];
            q[c] = sheets.vertex[static_cast<std::size_t>(sheet)];
        }
        if (!inside) std::swap(q[1], q[3]);
        addSplit(mesh, q);
    }
    /// Two triangles along the shorter diagonal.
    static void addSplit(TriangleMesh& mesh, const std::array<int, 4>& q) {
        const auto& p = mesh.vertices;
        if (distance(p[q[0]], p[q[2]]) <= distance(p[q[1]], p[q[3]])) {
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
        } else {
            mesh.triangles.push_back({q[1], q[2], q[3]});
            mesh.triangles.push_back({q[1], q[3], q[0]});
        }
    }

    const Field& field_;
    Vec3 origin_;
    double h_;
    std::map<Lattice, double> values_;
    std::map<Lattice, Sheets> sheets_;
};

} // namespace

Vec3 ontoSurface(const Field& field, Vec3 point, int steps) {
    const double e = 1e-4;
    for (int n = 0; n < steps; ++n) {
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 low = point, high = point;
            low[axis] -= e, high[axis] += e;
            gradient[axis] = (field(high) - field(low)) / (2 * e);
        }
        const double squared = squaredLength(gradient);
        if (squared < 1e-6) return point;
        point -= gradient * (field(point) / squared);
    }
    return point;
}

Result<TriangleMesh> isoSurface(const Field& field, const Vec3& seed, const IsoSurfaceSettings& settings) {
    for (int attempt = 0; attempt < settings.attempts; ++attempt) {
        const double shift = settings.spacing * attempt / settings.attempts;
        HalfNet net(field, seed + Vec3{0, shift, 0.7 * shift}, settings.spacing);
        net.follow();
        TriangleMesh half = net.triangles();
        relax(
            half, [&](const Vec3& p) { return ontoSurface(field, p, 1); }, settings.relaxations);
        TriangleMesh whole = mirroredWhole(half);
        if (geometry::isClosedManifold(whole)) return whole;
    }
    return fail(ErrorCode::notConverged,
                "No closed mesh of the body was found; choose measurements nearer to a usual body.");
}

} // namespace toile::body
