// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/CurvedMembranes.h"

#include <algorithm>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr int lanes = 4;

/// The points of a curve that lie beyond those before them, as cloth::tensionSecant goes along it: f(0) = 1 first.
std::vector<material::TensionPoint> knotsOf(const std::vector<material::TensionPoint>& curve) {
    std::vector<material::TensionPoint> knots(1);
    for (const material::TensionPoint& point : curve)
        if (point.strain > knots.back().strain) knots.push_back(point);
    return knots;
}

} // namespace

double complianceOf(double stiffness, double h) {
    return stiffness > 0 ? 1 / (stiffness * h * h) : std::numeric_limits<double>::infinity();
}

Membrane::Slack Membrane::slack(double h) const {
    const double r = stiffness.c22 > 0 ? stiffness.c12 / stiffness.c22 : 0;
    const double along = complianceOf(area * stiffness.c11, h), across = complianceOf(area * stiffness.c22, h);
    return {r, {complianceOf(area * (stiffness.c11 - r * stiffness.c12), h), across, along, across}};
}

void CurvedMembranes::add(const std::array<Membrane, 4>& four, const std::vector<cloth::TensionCurves>& curves) {
    static const Points linear;
    FourMembranes& membranes = fours_.emplace_back();
    std::array<const Points*, lanes> weft{}, warp{};
    for (int lane = 0; lane < lanes; ++lane) {
        const Membrane& membrane = four[lane];
        membranes.area[lane] = membrane.area;
        membranes.c11[lane] = membrane.stiffness.c11;
        membranes.c22[lane] = membrane.stiffness.c22;
        membranes.c12[lane] = membrane.stiffness.c12;
        const bool isCurved = membrane.tension >= 0;
        areLinear_ = areLinear_ && !isCurved;
        weft[lane] = isCurved ? &curves[membrane.tension].weft : &linear;
        warp[lane] = isCurved ? &curves[membrane.tension].warp : &linear;
    }
    membranes.weft = curveOf(weft);
    membranes.warp = curveOf(warp);
}

int CurvedMembranes::curveOf(const std::array<const Points*, 4>& points) {
    const auto [at, isNew] = known_.try_emplace(points, static_cast<int>(curves_.size()));
    if (!isNew) return at->second;
    FourCurves& curve = curves_.emplace_back();
    curve.first = curve.end = static_cast<int>(bends_.size());
    for (int lane = 0; lane < lanes; ++lane) {
        const Points knots = knotsOf(*points[lane]);
        double slope = 0;
        for (int k = 0; k + 1 < static_cast<int>(knots.size()); ++k) {
            if (curve.first + k == curve.end) {
                bends_.emplace_back();
                ++curve.end;
            }
            FourBends& bend = bends_[curve.first + k];
            bend.strain[lane] = knots[k].strain;
            bend.factor[lane] = knots[k].modulusFactor;
            bend.rise[lane] = knots[k + 1].modulusFactor - knots[k].modulusFactor;
            bend.run[lane] = knots[k + 1].strain - knots[k].strain;
            slope = bend.rise[lane] / bend.run[lane];
        }
        if (knots.size() == 1) continue; // linear
        const material::TensionPoint& last = knots.back();
        curve.last[lane] = last.strain;
        curve.stress[lane] = last.modulusFactor * last.strain;
        curve.tangent[lane] = std::max(0.0, last.modulusFactor + slope * last.strain);
    }
    return at->second;
}

std::size_t CurvedMembranes::bytes() const {
    return fours_.capacity() * sizeof(FourMembranes) + curves_.capacity() * sizeof(FourCurves) +
           bends_.capacity() * sizeof(FourBends);
}

} // namespace toile::dynamics
