// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/WindingNumber.h"

#include <algorithm>
#include <numbers>

namespace toile::collision {
namespace {

/// Of a triangle seen from the origin, positive when its back is seen [sr]. Ref: van Oosterom & Strackee 1983
double solidAngleOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = length(a), lb = length(b), lc = length(c);
    return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

} // namespace

WindingNumber::WindingNumber(geometry::TriangleMesh mesh) : mesh_(std::move(mesh)), boxes_(boxTreeOf(mesh_)) {
    for (int node = 0; node < static_cast<int>(boxes_.size()); ++node) plates_.push_back(plateOf(trianglesBelow(node)));
}

double WindingNumber::at(const Vec3& point) const {
    return solidAngle(point, -1) / (4 * std::numbers::pi);
}

double WindingNumber::onTriangle(int triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle]; // from its own plane it is seen under no angle
    return solidAngle((mesh_.vertices[a] + mesh_.vertices[b] + mesh_.vertices[c]) / 3, triangle) /
           (4 * std::numbers::pi);
}

std::vector<int> WindingNumber::trianglesBelow(int node) const {
    std::vector<int> triangles, open{node};
    while (!open.empty()) {
        const BoxNode& box = boxes_[open.back()];
        open.pop_back();
        if (box.triangle >= 0) triangles.push_back(box.triangle);
        else open.insert(open.end(), {box.firstChild, box.firstChild + 1});
    }
    return triangles;
}

WindingNumber::Plate WindingNumber::plateOf(const std::vector<int>& triangles) const {
    Plate plate;
    double weight = 0;
    for (const int triangle : triangles) {
        const auto& [ia, ib, ic] = mesh_.triangles[triangle];
        const Vec3 &a = mesh_.vertices[ia], &b = mesh_.vertices[ib], &c = mesh_.vertices[ic];
        const Vec3 area = 0.5 * cross(b - a, c - a);
        plate.area += area;
        plate.centre += (a + b + c) / 3 * length(area);
        weight += length(area);
    }
    plate.centre = weight > 0 ? plate.centre / weight : mesh_.vertices[mesh_.triangles[triangles.front()][0]];
    for (const int triangle : triangles)
        for (const int corner : mesh_.triangles[triangle])
            plate.reach = std::max(plate.reach, geometry::distance(plate.centre, mesh_.vertices[corner]));
    return plate;
}

double WindingNumber::solidAngle(const Vec3& point, int leftOut) const {
    constexpr double far = 3; // times its reach: then all plates together are wrong by less than the header promises
    double sum = 0;
    std::vector<int> open{0};
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        const BoxNode& box = boxes_[node];
        const Plate& plate = plates_[node];
        const Vec3 way = plate.centre - point;
        const double distance = length(way);
        if (distance > far * plate.reach) sum += dot(way, plate.area) / (distance * distance * distance);
        else if (box.triangle < 0) open.insert(open.end(), {box.firstChild, box.firstChild + 1});
        else if (box.triangle != leftOut) {
            const auto& [a, b, c] = mesh_.triangles[box.triangle];
            sum += solidAngleOf(mesh_.vertices[a] - point, mesh_.vertices[b] - point, mesh_.vertices[c] - point);
        }
    }
    return sum;
}

} // namespace toile::collision
