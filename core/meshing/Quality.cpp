// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

double angleAt(Vec2 corner, Vec2 a, Vec2 b) {
    const double angle = std::atan2(cross(a - corner, b - corner), dot(a - corner, b - corner));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Adds one displayed element, given by its corners in counter-clockwise order.
void judge(const std::vector<Vec2>& corners, PieceReport& report) {
    double shortest = 1e300, longest = 0, doubledArea = 0;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 here = corners[i], next = corners[(i + 1) % n], before = corners[(i + n - 1) % n];
        const double angle = angleAt(here, next, before);
        report.minimumAngle = std::min(report.minimumAngle, angle);
        report.maximumAngle = std::max(report.maximumAngle, angle);
        shortest = std::min(shortest, distance(here, next));
        longest = std::max(longest, distance(here, next));
        doubledArea += cross(here - corners[0], next - corners[0]);
    }
    if (doubledArea <= 0) ++report.invertedCells;
    if (shortest > 0) report.maximumAspect = std::max(report.maximumAspect, longest / shortest);
}

/// Edges of the displayed triangles that more than two of them share, or two in the same direction.
int nonManifoldEdges(const PieceMesh& mesh) {
    std::vector<std::array<int, 2>> directed;
    directed.reserve(3 * mesh.display.size());
    for (const auto& t : mesh.display)
        for (std::size_t i = 0; i < 3; ++i) directed.push_back({t[i], t[(i + 1) % 3]});
    std::sort(directed.begin(), directed.end());
    int count = 0;
    for (std::size_t i = 1; i < directed.size(); ++i) count += directed[i] == directed[i - 1];
    return count;
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

std::vector<Vec2> cornersOf(const PieceMesh& mesh, std::initializer_list<int> nodes) {
    std::vector<Vec2> corners;
    for (const int node : nodes) corners.push_back(mesh.material[at(node)]);
    return corners;
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

PieceReport qualityOf(const PieceMesh& mesh) {
    PieceReport report;
    report.nodes = static_cast<int>(mesh.nodes.size());
    report.slaves = static_cast<int>(mesh.slaves.size());
    report.rectangles = static_cast<int>(mesh.rectangles.size());
    report.quads = report.rectangles;
    report.minimumAngle = std::numbers::pi;
    for (const Rectangle& r : mesh.rectangles)
        judge(cornersOf(mesh, {r.nodes[0], r.nodes[1], r.nodes[2], r.nodes[3]}), report);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (t.mergedWith < 0) {
            ++report.triangles;
            judge(cornersOf(mesh, {t.nodes[0], t.nodes[1], t.nodes[2]}), report);
        } else if (static_cast<int>(i) < t.mergedWith) {
            ++report.quads;
            const auto q = mergedCorners(t, mesh.triangles[at(t.mergedWith)]);
            judge(cornersOf(mesh, {q[0], q[1], q[2], q[3]}), report);
        }
    }
    const int elements = report.quads + report.triangles;
    report.rectangleFraction = elements > 0 ? static_cast<double>(report.rectangles) / elements : 0;
    report.nonManifoldEdges = nonManifoldEdges(mesh);
    report.missingBoundaryNodes = missingBoundaryNodes(mesh);
    report.bytes = mesh.nodes.size() * 2 * sizeof(Vec2) + mesh.rectangles.size() * sizeof(Rectangle) +
                   mesh.triangles.size() * sizeof(Triangle) +
                   mesh.display.size() * sizeof(std::array<int, 3>);
    return report;
}

double meshedArea(const PieceMesh& mesh) {
    double doubled = 0;
    for (const auto& t : mesh.display)
        doubled +=
            cross(mesh.nodes[at(t[1])] - mesh.nodes[at(t[0])], mesh.nodes[at(t[2])] - mesh.nodes[at(t[0])]);
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
        total.maximumAspect = std::max(total.maximumAspect, p.maximumAspect);
        total.areaRelativeError = std::max(total.areaRelativeError, p.areaRelativeError);
        total.boundaryDeviation = std::max(total.boundaryDeviation, p.boundaryDeviation);
        total.invertedCells += p.invertedCells;
        total.missingBoundaryNodes += p.missingBoundaryNodes;
        total.nonManifoldEdges += p.nonManifoldEdges;
        total.seconds += p.seconds;
        total.bytes += p.bytes;
    }
    const int elements = total.quads + total.triangles;
    total.rectangleFraction = elements > 0 ? static_cast<double>(total.rectangles) / elements : 0;
    return total;
}

} // namespace toile::meshing
