// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Worn.h"

#include "core/simulation/BackNeck.h"
#include "core/simulation/RightSide.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <ranges>
#include <set>

namespace toile::simulation {
namespace {

using body::Limb;

struct NamedAxis {
    std::string name;
    std::vector<Vec3> points;
};

/// Neck and torso as one line from the head down: where a low neckline crosses it does not hang on where the one ends
/// and the other begins. The two overlap at the base of the neck; there the torso's points are left out.
std::vector<Vec3> trunkLine(const body::Body& body) {
    std::vector<Vec3> neck, torso;
    for (const body::LimbAxis& axis : body.axes) {
        if (axis.limb == Limb::neck) neck.assign(axis.points.rbegin(), axis.points.rend());
        if (axis.limb == Limb::torso) torso = axis.points;
    }
    if (!neck.empty()) {
        const auto below = std::ranges::find_if(torso, [&](const Vec3& p) { return p.y < neck.back().y; });
        neck.insert(neck.end(), below, torso.end());
    }
    return neck.empty() ? torso : neck;
}

/// The middle lines under the names of the report.
std::vector<NamedAxis> axesOf(const body::Body& body) {
    std::vector<NamedAxis> axes{{"trunk", trunkLine(body)}};
    for (const body::LimbAxis& axis : body.axes)
        if (axis.limb != Limb::neck && axis.limb != Limb::torso)
            axes.push_back({std::string(nameOf(axis.limb)), axis.points});
    return axes;
}

Surroundings surroundingsOf(const Drape& drape, const body::Body& body) {
    Surroundings around;
    for (std::size_t t = 0; t < drape.piece.size(); ++t)
        if (drape.piece[t] == Drape::noPiece) around.plackets.push_back(drape.triangles[t]);
    for (NamedAxis& axis : axesOf(body)) around.limbs.push_back(std::move(axis.points));
    return around;
}

/// +1 along the triangle's normal, −1 against it, 0 where the segment passes by.
int crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 direction = q - p;
    const auto side = [&](const Vec3& from, const Vec3& to) { return dot(direction, cross(from - p, to - p)); };
    const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
    const bool through = (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    if (!through) return 0;
    const Vec3 normal = cross(b - a, c - a);
    const double before = dot(normal, p - a), after = dot(normal, q - a);
    return (before < 0) == (after < 0) ? 0 : before < 0 ? 1 : -1;
}

std::vector<Vec3> pointsOf(const Opening& opening, const std::vector<Vec3>& positions) {
    std::vector<Vec3> points;
    for (const int particle : opening) points.push_back(positions[particle]);
    return points;
}

Vec3 meanOf(const std::vector<Vec3>& points) {
    Vec3 sum;
    for (const Vec3& p : points) sum += p;
    return points.empty() ? sum : sum / static_cast<double>(points.size());
}

double perimeterOf(const std::vector<Vec3>& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) sum += geometry::distance(loop[i], loop[(i + 1) % loop.size()]);
    return sum;
}

double shoulderHeight(const body::Landmarks& marks) {
    return 0.5 * (marks.acromionLeft.y + marks.acromionRight.y);
}

OpeningReport openingReport(const Opening& opening, const Drape& drape, const body::Body& body,
                            const std::vector<NamedAxis>& axes) {
    const std::vector<Vec3> loop = pointsOf(opening, drape.positions);
    OpeningReport report;
    report.perimeter = perimeterOf(loop);
    report.height = meanOf(loop).y;
    report.startHeight = meanOf(pointsOf(opening, drape.start)).y;
    for (const NamedAxis& axis : axes)
        if (const int times = crossings(loop, axis.points); times > 0) {
            report.crossings += times;
            report.limbs.push_back(axis.name != "trunk"                                    ? axis.name
                                   : report.height > shoulderHeight(body.landmarks) - 0.06 ? "neck"
                                                                                           : "torso");
        }
    report.name = report.limbs.empty() ? "free edge" : report.limbs.front();
    return report;
}

/// One limb, or both legs with or without the trunk's end between them: a skirt's hem.
bool isSound(const OpeningReport& opening) {
    if (opening.crossings != static_cast<int>(opening.limbs.size())) return false;
    if (opening.limbs.size() == 1) return true;
    const auto has = [&](const char* limb) { return std::ranges::count(opening.limbs, limb) == 1; };
    const bool legs = has("left leg") && has("right leg");
    return legs && (opening.limbs.size() == 2 || (opening.limbs.size() == 3 && has("torso")));
}

void judgeOpenings(WornReport& report, const std::vector<Opening>& openings, const Drape& drape) {
    if (report.openings.empty()) report.why.push_back("The garment has no opening.");
    for (std::size_t i = 0; i < report.openings.size(); ++i) {
        const OpeningReport& opening = report.openings[i];
        if (opening.limbs.empty())
            report.why.push_back(
                fmt::format("No limb passes through the opening at height {:.0f} mm.", 1000 * opening.height));
        else if (!isSound(opening))
            report.why.push_back(fmt::format("The opening at height {:.0f} mm is crossed {} times ({}).",
                                             1000 * opening.height, opening.crossings, fmt::join(opening.limbs, ", ")));
        // The arm must be the one beside which the opening was placed.
        const double startSide = meanOf(pointsOf(openings[i], drape.start)).x;
        if ((opening.name == "left arm" && startSide < 0) || (opening.name == "right arm" && startSide > 0))
            report.why.push_back(
                fmt::format("The {} is in an opening that was placed on the other side.", opening.name));
    }
    for (const char* limb : {"neck", "left arm", "right arm"})
        if (std::ranges::count(report.openings, limb, &OpeningReport::name) > 1)
            report.why.push_back(fmt::format("The {} passes through more than one opening.", limb));
}

double turnedLength(const Drape& drape) {
    double sum = 0;
    for (const auto& [a, b] : turnedEdgesOf(drape.triangles))
        sum += geometry::distance(drape.positions[a], drape.positions[b]);
    return sum;
}

void judgeNeckOrWaist(WornReport& report, const std::vector<Opening>& openings, const Drape& drape,
                      const body::Body& body, const WornSettings& settings) {
    const auto neck = std::ranges::find(report.openings, "neck", &OpeningReport::name);
    if (neck != report.openings.end()) {
        const Opening& rim = openings[static_cast<std::size_t>(neck - report.openings.begin())];
        const BackNeck back = backNeckOf(rim, drape.triangles, drape.piece, drape.positions, body.landmarks);
        report.napeDistance = back.napeDistance;
        report.necklineWiderBy = back.widerBy;
        const double allowed = settings.napeDistance + (back.below ? back.widerBy : 0);
        if (back.napeDistance > allowed)
            report.why.push_back(fmt::format(
                "The back-neck point lies {:.1f} mm from the nape, more than the {:.0f} mm that suit its neckline.",
                1000 * back.napeDistance, 1000 * allowed));
        return;
    }
    const auto top = std::ranges::max_element(report.openings, {}, &OpeningReport::startHeight);
    if (top == report.openings.end()) return;
    report.waistDrop = top->startHeight - top->height;
    if (std::abs(*report.waistDrop) > settings.waistDrop)
        report.why.push_back(fmt::format("The uppermost opening lies {:.1f} mm {} the level it was placed at.",
                                         1000 * std::abs(*report.waistDrop),
                                         *report.waistDrop > 0 ? "below" : "above"));
}

/// The particles on rims that hang free of the body: what such a hem's folds do is chance.
std::set<int> onFreeRims(const std::vector<Opening>& openings, const Drape& drape,
                         const collision::BodySurface& surface, double freeRim) {
    constexpr double searchRadius = 0.5; // [m]; what is farther off counts as so far
    std::set<int> particles;
    for (const Opening& opening : openings) {
        double sum = 0;
        for (const int particle : opening) {
            const auto nearest = surface.nearest(drape.positions[particle], searchRadius);
            sum += nearest ? nearest->signedDistance : searchRadius;
        }
        if (sum > freeRim * static_cast<double>(opening.size())) particles.insert(opening.begin(), opening.end());
    }
    return particles;
}

void judgeSymmetry(WornReport& report, const std::vector<Opening>& openings, const Drape& drape,
                   const collision::BodySurface& surface, const WornSettings& settings) {
    const std::set<int> free = onFreeRims(openings, drape, surface, settings.freeRim);
    for (const auto& [left, right] : drape.mirrorPairs) {
        if (free.contains(left) && free.contains(right)) continue;
        const Vec3& p = drape.positions[left];
        const double difference = geometry::distance({-p.x, p.y, p.z}, drape.positions[right]);
        report.symmetryDifference = std::max(report.symmetryDifference.value_or(0), difference);
    }
    if (report.symmetryDifference && *report.symmetryDifference > settings.symmetry)
        report.why.push_back(fmt::format("Left and right differ by {:.1f} mm.", 1000 * *report.symmetryDifference));
}

/// Knits are meant to stretch.
void judgeStretch(WornReport& report, const Drape& drape, const WornSettings& settings) {
    report.wovenStrain = drape.wovenStrain;
    if (!drape.wovenStrain) return;
    const auto judge = [&](const char* direction, double percentile99, double maximum) {
        if (percentile99 > settings.stretchPercentile99)
            report.why.push_back(
                fmt::format("A hundredth of the woven cloth is stretched by more than {:.1f} % along its {}.",
                            100 * percentile99, direction));
        if (maximum > settings.stretchMaximum)
            report.why.push_back(
                fmt::format("Woven cloth is stretched by {:.1f} % along its {}.", 100 * maximum, direction));
    };
    judge("warp", drape.wovenStrain->warpPercentile99, drape.wovenStrain->warpMaximum);
    judge("weft", drape.wovenStrain->weftPercentile99, drape.wovenStrain->weftMaximum);
}

} // namespace

std::vector<OpeningReport> openingReports(const std::vector<Opening>& openings, const Drape& drape,
                                          const body::Body& body) {
    const std::vector<NamedAxis> axes = axesOf(body);
    std::vector<OpeningReport> reports;
    for (const Opening& opening : openings) reports.push_back(openingReport(opening, drape, body, axes));
    return reports;
}

bool hasNeckOpening(const Drape& drape, const body::Body& body) {
    const std::vector<OpeningReport> reports = openingReports(openingsOf(drape.triangles), drape, body);
    return std::ranges::count(reports, "neck", &OpeningReport::name) > 0;
}

int crossings(const std::vector<Vec3>& loop, const std::vector<Vec3>& polyline) {
    const Vec3 centre = meanOf(loop);
    int net = 0, all = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
            const int sign = crossing(polyline[k], polyline[k + 1], centre, loop[i], loop[(i + 1) % loop.size()]);
            net += sign;
            all += std::abs(sign);
        }
    return net != 0 ? std::abs(net) : all;
}

WornReport wornReport(const Drape& drape, const body::Body& body, const collision::BodySurface& surface,
                      const WornSettings& settings) {
    WornReport report;
    const std::vector<Opening> openings = openingsOf(drape.triangles);
    report.openings = openingReports(openings, drape, body);
    judgeOpenings(report, openings, drape);
    report.turnedLength = turnedLength(drape);
    if (report.turnedLength > 0)
        report.why.push_back(
            fmt::format("Right side is sewn to wrong side along {:.0f} mm.", 1000 * report.turnedLength));
    report.rightSideOut = rightSideOutShare(drape.triangles, drape.positions, surroundingsOf(drape, body));
    if (report.rightSideOut < settings.rightSideShare)
        report.why.push_back(
            fmt::format("Only {:.1f} % of the cloth has its right side out.", 100 * report.rightSideOut));
    judgeNeckOrWaist(report, openings, drape, body, settings);
    judgeSymmetry(report, openings, drape, surface, settings);
    judgeStretch(report, drape, settings);
    report.worn = report.why.empty();
    return report;
}

} // namespace toile::simulation
