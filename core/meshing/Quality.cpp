// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Quality.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>

namespace toile::meshing {
namespace {

double angleAt(Vec2 corner, Vec2 a, Vec2 b) {
    const double angle = std::atan2(cross(a - corner, b - corner), dot(a - corner, b - corner));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

constexpr double degree = std::numbers::pi / 180;
constexpr double alongGrain = 2 * degree; ///< sides that lean less count as aligned

void countAngle(double angle, PieceReport& report) {
    report.minimumAngle = std::min(report.minimumAngle, angle);
    report.maximumAngle = std::max(report.maximumAngle, angle);
    const auto whole = static_cast<std::size_t>(std::clamp(angle / degree + 1e-6, 0.0, 180.0));
    ++report.angles[whole];
}

bool isAlongGrain(Vec2 side) {
    const double across = std::min(std::abs(side.x), std::abs(side.y)),
                 along = std::max(std::abs(side.x), std::abs(side.y));
    return across <= std::tan(alongGrain) * along;
}

/// Sums over the displayed elements.
struct Sides {
    double all = 0, aligned = 0; ///< [m]
};

/// Adds one displayed element, given by its corners in counter-clockwise order.
void judgeElement(std::span<const Vec2> corners, PieceReport& report, Sides& sides) {
    double shortest = 1e300, longest = 0, doubledArea = 0;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 here = corners[i], next = corners[(i + 1) % n], before = corners[(i + n - 1) % n];
        countAngle(angleAt(here, next, before), report);
        const double side = distance(here, next);
        shortest = std::min(shortest, side);
        longest = std::max(longest, side);
        sides.all += side;
        if (isAlongGrain(next - here)) sides.aligned += side;
        doubledArea += cross(here - corners[0], next - corners[0]);
    }
    if (doubledArea <= 0) ++report.invertedCells;
    if (shortest > 0) report.maximumAspect = std::max(report.maximumAspect, longest / shortest);
}

/// Directed sides of the displayed triangles, by the node they leave.
class SidesByNode {
public:
    explicit SidesByNode(const PieceMesh& mesh) : first_(mesh.nodes.size() + 1, 0), sides_(3 * mesh.display.size()) {
        for (const auto& t : mesh.display)
            for (const int from : t) ++first_[at(from) + 1];
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t k = 0; k < mesh.display.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i)
                sides_[next[at(mesh.display[k][i])]++] = {mesh.display[k][(i + 1) % 3], static_cast<int>(k)};
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
            std::sort(sides_.begin() + static_cast<std::ptrdiff_t>(first_[node]),
                      sides_.begin() + static_cast<std::ptrdiff_t>(first_[node + 1]));
    }

    /// The other ends of the sides that leave a node, rising, and their triangles.
    [[nodiscard]] std::span<const std::pair<int, int>> leaving(int node) const {
        return std::span(sides_).subspan(first_[at(node)], first_[at(node) + 1] - first_[at(node)]);
    }

private:
    std::vector<std::size_t> first_;
    std::vector<std::pair<int, int>> sides_;
};

/// Sides that more than two of the displayed triangles share, or two in the same direction.
int nonManifoldEdges(const PieceMesh& mesh, const SidesByNode& sides) {
    int count = 0;
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        const auto leaving = sides.leaving(node);
        for (std::size_t i = 1; i < leaving.size(); ++i) count += leaving[i].first == leaving[i - 1].first;
    }
    return count;
}

double neighbourSizeRatio(const PieceMesh& mesh, const SidesByNode& sides) {
    const auto area = [&](int triangle) {
        const auto& t = mesh.display[at(triangle)];
        const Vec2 a = mesh.material[at(t[0])];
        return std::abs(cross(mesh.material[at(t[1])] - a, mesh.material[at(t[2])] - a));
    };
    double largest = 0;
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node)
        for (const auto& [other, triangle] : sides.leaving(node)) {
            if (other < node) continue;
            const auto back = sides.leaving(other);
            const auto twin = std::lower_bound(back.begin(), back.end(), std::pair(node, 0));
            if (twin == back.end() || twin->first != node) continue;
            const double here = area(triangle), there = area(twin->second);
            if (here > 0 && there > 0) largest = std::max({largest, here / there, there / here});
        }
    return std::sqrt(largest);
}

int missingBoundaryNodes(const PieceMesh& mesh) {
    std::vector<char> used(mesh.nodes.size(), 0);
    for (const auto& t : mesh.display)
        for (const int node : t) used[at(node)] = 1;
    std::vector<char> counted(mesh.nodes.size(), 0);
    int missing = 0;
    for (const auto& loop : mesh.loops)
        for (const EdgeNodes& edge : loop)
            for (const EdgeNode& node : edge)
                if (!used[at(node.node)] && !counted[at(node.node)]) {
                    counted[at(node.node)] = 1;
                    ++missing;
                }
    return missing;
}

/// The four corners of two triangles that share an edge, counter-clockwise.
std::array<int, 4> mergedCorners(const Triangle& a, const Triangle& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const int apex = a.nodes[i];
        if (std::find(b.nodes.begin(), b.nodes.end(), apex) != b.nodes.end()) continue;
        for (const int other : b.nodes)
            if (std::find(a.nodes.begin(), a.nodes.end(), other) == a.nodes.end())
                return {apex, a.nodes[(i + 1) % 3], other, a.nodes[(i + 2) % 3]};
    }
    return {a.nodes[0], a.nodes[1], a.nodes[2], a.nodes[2]};
}

} // namespace

PieceReport countsOf(const PieceMesh& mesh) {
    PieceReport report;
    report.nodes = static_cast<int>(mesh.nodes.size());
    report.slaves = static_cast<int>(mesh.slaves.size());
    report.rectangles = static_cast<int>(mesh.rectangles.size());
    const auto merged = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                      [](const Triangle& triangle) { return triangle.mergedWith >= 0; });
    report.quads = report.rectangles + static_cast<int>(merged) / 2;
    report.triangles = static_cast<int>(mesh.triangles.size()) - static_cast<int>(merged);
    const int elements = report.quads + report.triangles;
    report.rectangleFraction = elements > 0 ? static_cast<double>(report.rectangles) / elements : 0;
    report.bytes = mesh.nodes.size() * 2 * sizeof(Vec2) + mesh.rectangles.size() * sizeof(Rectangle) +
                   mesh.triangles.size() * sizeof(Triangle) + mesh.display.size() * sizeof(std::array<int, 3>);
    for (const SlaveNode& slave : mesh.slaves)
        report.bytes += sizeof(SlaveNode) + slave.masters.size() * sizeof(slave.masters[0]);
    for (const auto& loop : mesh.loops)
        for (const EdgeNodes& edge : loop) report.bytes += sizeof(EdgeNodes) + edge.size() * sizeof(EdgeNode);
    return report;
}

void judge(const PieceMesh& mesh, PieceReport& report) {
    report.minimumAngle = std::numbers::pi;
    Sides sums;
    const auto element = [&](auto nodes) {
        std::array<Vec2, std::tuple_size_v<decltype(nodes)>> corners;
        for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = mesh.material[at(nodes[i])];
        judgeElement(corners, report, sums);
    };
    for (const Rectangle& r : mesh.rectangles) element(r.nodes);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (t.mergedWith < 0) element(t.nodes);
        else if (static_cast<int>(i) < t.mergedWith) element(mergedCorners(t, mesh.triangles[at(t.mergedWith)]));
    }
    report.sideLength = sums.all;
    report.grainAlignment = sums.all > 0 ? sums.aligned / sums.all : 0;
    const SidesByNode sides(mesh);
    report.nonManifoldEdges = nonManifoldEdges(mesh, sides);
    report.neighbourSizeRatio = neighbourSizeRatio(mesh, sides);
    report.missingBoundaryNodes = missingBoundaryNodes(mesh);
}

int angleBelow(const PieceReport& report, double part) {
    const double corners = std::accumulate(report.angles.begin(), report.angles.end(), 0.0);
    double below = 0;
    for (std::size_t degrees = 0; degrees < report.angles.size(); ++degrees) {
        below += report.angles[degrees];
        if (below > part * corners) return static_cast<int>(degrees);
    }
    return 0;
}

double meshedArea(const PieceMesh& mesh) {
    double doubled = 0;
    for (const auto& t : mesh.display)
        doubled += cross(mesh.nodes[at(t[1])] - mesh.nodes[at(t[0])], mesh.nodes[at(t[2])] - mesh.nodes[at(t[0])]);
    return 0.5 * doubled;
}

PieceReport totalOf(const std::vector<PieceReport>& pieces) {
    PieceReport total;
    total.label = "total";
    total.minimumAngle = total.inputMinimumAngle = std::numbers::pi;
    for (const PieceReport& p : pieces) {
        total.nodes += p.nodes;
        total.slaves += p.slaves;
        total.quads += p.quads;
        total.triangles += p.triangles;
        total.rectangles += p.rectangles;
        total.minimumAngle = std::min(total.minimumAngle, p.minimumAngle);
        total.maximumAngle = std::max(total.maximumAngle, p.maximumAngle);
        total.inputMinimumAngle = std::min(total.inputMinimumAngle, p.inputMinimumAngle);
        for (std::size_t i = 0; i < p.angles.size(); ++i) total.angles[i] += p.angles[i];
        total.neighbourSizeRatio = std::max(total.neighbourSizeRatio, p.neighbourSizeRatio);
        total.sideLength += p.sideLength;
        total.grainAlignment += p.grainAlignment * p.sideLength;
        total.maximumAspect = std::max(total.maximumAspect, p.maximumAspect);
        total.areaRelativeError = std::max(total.areaRelativeError, p.areaRelativeError);
        total.boundaryDeviation = std::max(total.boundaryDeviation, p.boundaryDeviation);
        total.invertedCells += p.invertedCells;
        total.missingBoundaryNodes += p.missingBoundaryNodes;
        total.nonManifoldEdges += p.nonManifoldEdges;
        total.seconds += p.seconds;
        total.bytes += p.bytes;
    }
    if (total.sideLength > 0) total.grainAlignment /= total.sideLength;
    const int elements = total.quads + total.triangles;
    total.rectangleFraction = elements > 0 ? static_cast<double>(total.rectangles) / elements : 0;
    return total;
}

} // namespace toile::meshing
