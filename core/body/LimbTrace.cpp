// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/LimbTrace.h"

#include <algorithm>
#include <cmath>

namespace toile::body {

namespace {

using geometry::TriangleMesh;

/// Highest point of the curves in the plane x = const that end between two heights.
std::optional<Vec3> topAt(const TriangleMesh& mesh, double x, double above, double below) {
    std::optional<Vec3> top;
    for (const SectionLoop& loop : sectionsOf(mesh, {{x, 0, 0}, {1, 0, 0}})) {
        const Vec3 p = farthest(loop, {0, 1, 0});
        if (p.y > above && p.y < below && (!top || p.y > top->y)) top = p;
    }
    return top;
}

/// Lowest point of the curve that holds the arm's top: the underside of the arm.
std::optional<Vec3> undersideAt(const TriangleMesh& mesh, double x, const Vec3& top) {
    std::optional<Vec3> under;
    for (const SectionLoop& loop : sectionsOf(mesh, {{x, 0, 0}, {1, 0, 0}}))
        if (farthest(loop, {0, 1, 0}).y > top.y - 1e-9) under = farthest(loop, {0, -1, 0});
    return under;
}

} // namespace

std::optional<Shoulder> shoulderOf(const TriangleMesh& mesh, const BodyProfile& profile, const Vec3& sideNeck,
                                   double armpit) {
    const double h = profile.height, step = 0.003 * h, low = armpit - 0.10 * h, high = sideNeck.y + 0.01 * h;
    std::vector<Vec3> line; // the ridge from neck to upper arm
    for (double x = sideNeck.x + step; x < sideNeck.x + 0.16 * h; x += step) {
        const auto top = topAt(mesh, x, low, high);
        if (!top) break;
        line.push_back(*top);
    }
    if (line.size() < 10) return std::nullopt;
    // The acromion stands out farthest above the chord; where the arm goes on level (a T-pose) it lies over
    // the armpit.
    const Vec3 from = line.front(), along = line.back() - from;
    const auto above = [&](const Vec3& p) { return p.y - from.y - along.y / along.x * (p.x - from.x); };
    Shoulder shoulder;
    shoulder.acromion = *std::ranges::max_element(line, {}, above);
    const double armpitX = boundsOf(trunkAt(mesh, profile, armpit).value_or(SectionLoop{{}, {from}})).high.x;
    const Vec3 hand = *std::ranges::max_element(mesh.vertices, {}, &Vec3::x) - sideNeck;
    const bool stretchedOut = -hand.y < 0.35 * hand.x;
    if (stretchedOut)
        shoulder.acromion =
            *std::ranges::min_element(line, {}, [&](const Vec3& p) { return std::abs(p.x - armpitX - 0.015 * h); });
    const double jointX = std::max(shoulder.acromion.x, armpitX);
    const auto top = topAt(mesh, jointX + 0.02 * h, low, high);
    const auto under = top ? undersideAt(mesh, jointX + 0.02 * h, *top) : std::nullopt;
    if (!under) return std::nullopt;
    shoulder.joint = lerp(*top, *under, 0.5);
    return shoulder;
}

std::optional<TracedArm> armOf(const TriangleMesh& mesh, const BodyProfile& profile, const Vec3& joint) {
    const double h = profile.height, step = 0.008 * h;
    const Vec3 tip = *std::ranges::max_element(mesh.vertices, {}, &Vec3::x);
    const double whole = distance(joint, tip);
    if (whole < 0.2 * h) return std::nullopt;
    struct Ring {
        Vec3 centre;
        double girth, along;
    };
    std::vector<Ring> rings;
    Vec3 at = joint, direction = normalized(tip - joint);
    double gone = 0;
    while (gone < 1.1 * whole) {
        at += direction * step;
        gone += step;
        const auto loop = sectionRound(mesh, {at, direction});
        if (!loop || tapeGirth(*loop) > 0.35 * h) { // the trunk is still in the plane, or the hand has ended
            if (rings.empty() && gone < 0.35 * whole) continue;
            break;
        }
        at = centreOf(*loop);
        rings.push_back({at, tapeGirth(*loop), gone});
        const std::size_t back = std::min<std::size_t>(rings.size() - 1, 6);
        const Vec3 run = at - rings[rings.size() - 1 - back].centre;
        if (back >= 3) direction = normalized(lerp(direction, normalized(run), 0.5));
    }
    const auto isForearm = [&](const Ring& r) { return r.along > 0.50 * whole && r.along < 0.85 * whole; };
    const Ring* wrist = nullptr;
    for (const Ring& r : rings)
        if (isForearm(r) && (!wrist || r.girth < wrist->girth)) wrist = &r;
    if (!wrist) return std::nullopt;
    const double thin = 1.03 * wrist->girth; // a slender forearm: the wrist is where it ends
    for (const Ring& r : rings)
        if (isForearm(r) && r.girth < thin) wrist = &r;
    TracedArm arm{{joint}, wrist->centre};
    for (std::size_t i = 0; i < rings.size() && rings[i].along < wrist->along - step; i += 6)
        arm.axis.push_back(rings[i].centre);
    arm.axis.push_back(wrist->centre);
    const Vec3 forearm = normalized(wrist->centre - arm.axis[arm.axis.size() - 2]);
    arm.axis.push_back(wrist->centre + forearm * (distance(wrist->centre, tip) + 0.05 * h));
    return arm;
}

std::optional<TracedLeg> legOf(const TriangleMesh& mesh, const BodyProfile& profile, double crotch) {
    const double h = profile.height;
    const auto loopAt = [&](double fraction) { return leftLegAt(mesh, profile, profile.floor + fraction * h); };
    const auto foot = loopAt(0.02);
    if (!foot) return std::nullopt;
    TracedLeg leg;
    double least = 1e9;
    for (double fraction = 0.045; fraction < 0.12; fraction += 0.0025)
        if (const auto loop = loopAt(fraction); loop && tapeGirth(*loop) < least) {
            least = tapeGirth(*loop);
            leg.ankle = centreOf(*loop);
        }
    if (least > 1) return std::nullopt;
    const double top = (crotch - profile.floor) / h - 0.02, low = (leg.ankle.y - profile.floor) / h;
    for (int n = 0; n < 6; ++n)
        if (const auto loop = loopAt(top + (low - top) * n / 6)) leg.axis.push_back(centreOf(*loop));
    leg.axis.push_back(leg.ankle);
    leg.axis.push_back({leg.ankle.x, profile.floor - 0.06 * h, leg.ankle.z});
    const geometry::Box3 sole = boundsOf(*foot);
    leg.facesFront = sole.high.z - leg.ankle.z > leg.ankle.z - sole.low.z;
    return leg;
}

} // namespace toile::body
