// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>

/// Inputs that the mesher's tests share, and areas to hold their meshes to.
namespace toile::meshing {

inline BoundaryLoop loopThrough(const std::vector<Vec2>& corners) {
    BoundaryLoop loop;
    for (std::size_t i = 0; i < corners.size(); ++i)
        loop.push_back({Curve{corners[i], corners[(i + 1) % corners.size()], {}}, {}, fmt::format("e{}", i)});
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

inline geometry::Polygon box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline SeamInput seamOf(std::vector<SeamPartInput> a, std::vector<SeamPartInput> b,
                        std::vector<SeamSectionInput> sections = {}) {
    return {"seam", {std::move(a), std::move(b)}, std::move(sections)};
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

} // namespace toile::meshing
