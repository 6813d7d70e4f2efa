// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

/// Inputs and referees that the mesher's tests share.
namespace toile::meshing {

inline BoundaryLoop loopThrough(const std::vector<Vec2>& corners) {
    BoundaryLoop loop;
    for (std::size_t i = 0; i < corners.size(); ++i)
        loop.push_back({Curve{corners[i], corners[(i + 1) % corners.size()], {}}, {}, "e" + std::to_string(i)});
    return loop;
}

inline PieceInput polygonPiece(const std::vector<Vec2>& corners, double spacing, std::string label = "Piece") {
    PieceInput piece;
    piece.label = std::move(label);
    piece.outline = loopThrough(corners);
    piece.spacing = spacing;
    return piece;
}

inline PieceInput rectanglePiece(double width, double height, double spacing, std::string label = "Rectangle") {
    return polygonPiece({{0, 0}, {width, 0}, {width, height}, {0, height}}, spacing, std::move(label));
}

/// A full circle of two half-circle arcs; clockwise = a hole.
inline BoundaryLoop circleLoop(Vec2 centre, double radius, bool clockwise = false) {
    const Vec2 left = centre - Vec2{radius, 0}, right = centre + Vec2{radius, 0};
    const double bulge = clockwise ? -1 : 1;
    return {{Curve{left, right, geometry::ArcShape{bulge}}, {}, "half 1"},
            {Curve{right, left, geometry::ArcShape{bulge}}, {}, "half 2"}};
}

inline PieceInput circlePiece(double radius, double spacing) {
    PieceInput piece;
    piece.label = "Circle";
    piece.outline = circleLoop({0, 0}, radius);
    piece.spacing = spacing;
    return piece;
}

/// A made-up bodice front with curved neckline and armhole, 0.26 m wide and 0.62 m long.
inline PieceInput bodicePiece(double spacing) {
    PieceInput piece;
    piece.label = "Bodice";
    piece.spacing = spacing;
    const auto line = [](Vec2 a, Vec2 b, std::string label) {
        return BoundaryEdge{Curve{a, b, {}}, {}, std::move(label)};
    };
    const auto cubic = [](Vec2 a, Vec2 c1, Vec2 c2, Vec2 b, std::string label) {
        return BoundaryEdge{Curve{a, b, geometry::CubicShape{c1, c2}}, {}, std::move(label)};
    };
    piece.outline = {line({0, 0}, {0.25, 0.005}, "hem"),
                     cubic({0.25, 0.005}, {0.235, 0.12}, {0.235, 0.24}, {0.26, 0.4}, "side"),
                     cubic({0.26, 0.4}, {0.19, 0.41}, {0.175, 0.47}, {0.19, 0.575}, "armhole"),
                     line({0.19, 0.575}, {0.075, 0.62}, "shoulder"),
                     cubic({0.075, 0.62}, {0.07, 0.56}, {0.05, 0.53}, {0, 0.53}, "neckline"),
                     line({0, 0.53}, {0, 0}, "centre front")};
    return piece;
}

inline MeshInput inputOf(PieceInput piece) {
    return {{std::move(piece)}, {}};
}

inline double triangleArea(Vec2 a, Vec2 b, Vec2 c) {
    return 0.5 * cross(b - a, c - a);
}

inline double displayArea(const PieceMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.display)
        sum += triangleArea(mesh.nodes[static_cast<std::size_t>(t[0])], mesh.nodes[static_cast<std::size_t>(t[1])],
                            mesh.nodes[static_cast<std::size_t>(t[2])]);
    return sum;
}

/// The area of the polygon through the boundary nodes, holes taken off.
inline double boundaryArea(const PieceMesh& mesh) {
    double sum = 0;
    for (const auto& loop : mesh.loops) {
        geometry::Polygon ring;
        for (const EdgeNodes& edge : loop)
            for (std::size_t k = 0; k + 1 < edge.size(); ++k)
                ring.push_back(mesh.nodes[static_cast<std::size_t>(edge[k].node)]);
        sum += std::abs(geometry::signedArea(ring)) * (&loop == &mesh.loops.front() ? 1 : -1);
    }
    return sum;
}

/// What must hold for every mesh; empty when it does.
inline std::string defectOf(const PieceMesh& mesh, int holes = 0) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::map<std::array<int, 2>, int> directed;
    std::set<int> used;
    for (const auto& t : mesh.display) {
        if (triangleArea(mesh.nodes[at(t[0])], mesh.nodes[at(t[1])], mesh.nodes[at(t[2])]) <= 0)
            return "an inverted triangle";
        for (std::size_t i = 0; i < 3; ++i) {
            used.insert(t[i]);
            if (++directed[{t[i], t[(i + 1) % 3]}] > 1) return "an edge used twice in one direction";
        }
    }
    if (used.size() != mesh.nodes.size()) return "a node without a triangle";
    std::set<std::array<int, 2>> border;
    for (const auto& loop : mesh.loops)
        for (const EdgeNodes& edge : loop)
            for (std::size_t k = 0; k + 1 < edge.size(); ++k)
                if (edge[k].node != edge[k + 1].node)
                    border.insert({std::min(edge[k].node, edge[k + 1].node), std::max(edge[k].node, edge[k + 1].node)});
    std::size_t open = 0, edges = 0;
    for (const auto& [edge, count] : directed) {
        const bool twin = directed.contains({edge[1], edge[0]});
        edges += twin ? (edge[0] < edge[1] ? 1 : 0) : 1;
        if (twin) continue;
        ++open;
        if (!border.contains({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}))
            return "a crack or an edge beside the border";
    }
    if (open != border.size()) return "a border segment that bears no triangle";
    const long euler =
        static_cast<long>(mesh.nodes.size()) - static_cast<long>(edges) + static_cast<long>(mesh.display.size());
    if (euler != 1 - holes) return "Euler's number is " + std::to_string(euler);
    if (std::abs(displayArea(mesh) - boundaryArea(mesh)) > 1e-9 * boundaryArea(mesh)) return "the areas differ";
    for (const Rectangle& r : mesh.rectangles) {
        const auto corner = [&](std::size_t i) { return mesh.material[at(r.nodes[i])]; };
        if (corner(0).y != corner(1).y || corner(1).x != corner(2).x || corner(2).y != corner(3).y ||
            corner(3).x != corner(0).x || corner(1).x <= corner(0).x || corner(3).y <= corner(0).y)
            return "a rectangle that is none";
    }
    std::set<int> slaves, onBorder;
    for (const SlaveNode& slave : mesh.slaves) slaves.insert(slave.node);
    for (const auto& [low, high] : border) onBorder.insert({low, high});
    for (const SlaveNode& slave : mesh.slaves) {
        Vec2 sum;
        double weights = 0;
        for (const auto& [master, weight] : slave.masters) {
            if (slaves.contains(master)) return "a slave of a slave";
            sum += mesh.material[at(master)] * weight;
            weights += weight;
        }
        if (onBorder.contains(slave.node)) return "a slave on the border";
        if (std::abs(weights - 1) > 1e-14) return "weights that do not sum to one";
        if (distance(sum, mesh.material[at(slave.node)]) > 1e-12) return "a slave beside its masters' line";
    }
    return {};
}

} // namespace toile::meshing
