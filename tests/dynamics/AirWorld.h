// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Faces.h"
#include "tests/cloth/Fixtures.h"
#include "tests/dynamics/DenseSink.h"

#include <QTest>
#include <cmath>
#include <numbers>

namespace toile::fixtures {

/// The cells of a patch, by their area at rest.
inline std::vector<dynamics::Face> facesOf(const Patch& patch, double density, double pressure = 0) {
    std::vector<dynamics::Face> faces;
    const auto areaBetween = [&](int a, int b, int c) {
        return cross(patch.material[b] - patch.material[a], patch.material[c] - patch.material[a]) / 2;
    };
    const auto particle = [&](int node) { return patch.particles[node]; };
    for (const auto& cell : patch.rectangles) {
        const auto [a, b, c, d] = cell.nodes;
        dynamics::appendRectangle(faces, {particle(a), particle(b), particle(c), particle(d)},
                                  2 * density * areaBetween(a, b, c), pressure);
    }
    for (const auto& t : patch.triangles) {
        const auto [a, b, c] = t.nodes;
        faces.push_back({{particle(a), particle(b), particle(c)}, density * areaBetween(a, b, c), 1, pressure});
    }
    return faces;
}

/// Cells of a sheet closed to a tube about z, right side out, with free ends: n sides round, so many along.
inline Patch tubePatch(double radius, int sides, double length, int along) {
    const double girth = 2 * sides * radius * std::sin(std::numbers::pi / sides);
    Patch patch = gridPatch(evenLines(girth, sides), evenLines(length, along));
    for (int node = 0; node < static_cast<int>(patch.material.size()); ++node)
        patch.particles[node] = node / (sides + 1) * sides + node % (sides + 1) % sides;
    return patch;
}

inline std::vector<Vec3> tubePositions(double radius, int sides, double length, int along) {
    std::vector<Vec3> positions;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            positions.push_back({radius * std::cos(angle), radius * std::sin(angle), length * j / along});
        }
    return positions;
}

inline Vec3 sumOf(const std::vector<Vec3>& vectors) {
    Vec3 sum;
    for (const Vec3& v : vectors) sum += v;
    return sum;
}

inline std::vector<Vec3> forcesOf(const dynamics::Stage& stage, const std::vector<Vec3>& positions) {
    std::vector<Vec3> forces(positions.size());
    stage.addForces(positions, forces);
    return forces;
}

/// Forces against central differences of the energy, and the Hessian against those of the forces.
inline void compareWithDifferences(const dynamics::Stage& stage, const std::vector<Vec3>& positions) {
    constexpr double step =
        1e-6; // [m]: an error of its square times third derivatives, and of 1e-16/step from rounding
    const std::vector<Vec3> forces = forcesOf(stage, positions);
    double largestForce = 0, largestStiffness = 0;
    DenseSink hessian(static_cast<int>(positions.size()));
    stage.addHessian(positions, hessian);
    for (const Vec3& f : forces) largestForce = std::max(largestForce, length(f));
    for (const double k : hessian.values) largestStiffness = std::max(largestStiffness, std::abs(k));
    QVERIFY(largestForce > 0 && largestStiffness > 0);
    for (std::size_t p = 0; p < positions.size(); ++p)
        for (int i = 0; i < 3; ++i) {
            auto ahead = positions, behind = positions;
            ahead[p][i] += step;
            behind[p][i] -= step;
            const double slope = (stage.energy(ahead) - stage.energy(behind)) / (2 * step);
            QVERIFY2(std::abs(slope + forces[p][i]) <= 1e-5 * largestForce, qPrintable(QString::number(slope)));
            const auto forcesAhead = forcesOf(stage, ahead), forcesBehind = forcesOf(stage, behind);
            for (std::size_t q = 0; q < positions.size(); ++q)
                for (int j = 0; j < 3; ++j) {
                    const double change = (forcesBehind[q][j] - forcesAhead[q][j]) / (2 * step);
                    const double k = hessian.values[(3 * q + j) * hessian.size + 3 * p + i];
                    QVERIFY2(std::abs(change - k) <= 1e-4 * largestStiffness,
                             qPrintable(QString("%1 %2").arg(change).arg(k)));
                }
        }
}

} // namespace toile::fixtures
