// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Worn.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <ranges>

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
    for (const body::LimbAxis& axis : body.axes) switch (axis.limb) {
        case Limb::neck:
        case Limb::torso: break;
        case Limb::leftArm: axes.push_back({"left arm", axis.points}); break;
        case Limb::rightArm: axes.push_back({"right arm", axis.points}); break;
        case Limb::leftLeg: axes.push_back({"left leg", axis.points}); break;
        case Limb::rightLeg: axes.push_back({"right leg", axis.points}); break;
        }
    return axes;
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

Vec3 centreOf(const std::array<int, 3>& triangle, const std::vector<Vec3>& positions) {
    return (positions[triangle[0]] + positions[triangle[1]] + positions[triangle[2]]) / 3;
}

/// For each triangle the patch of its piece that it belongs to: patches are some 0.2 m across where the piece was
/// placed.
std::vector<int> patchesOf(const Drape& drape) {
    constexpr double size = 0.2; // [m]: wider than folds are deep, narrow enough that a turned side of a piece is one
    struct Seed {
        int piece;
        Vec3 at;
    };
    std::vector<Seed> seeds;
    const auto pieceOf = [&](std::size_t t) { return drape.piece.empty() ? 0 : drape.piece[t]; };
    const auto nearestTo = [&](std::size_t t) { // of the seeds of its piece: index and distance
        std::pair<int, double> nearest{-1, std::numeric_limits<double>::infinity()};
        for (std::size_t i = 0; i < seeds.size(); ++i)
            if (const double d = geometry::distance(seeds[i].at, centreOf(drape.triangles[t], drape.start));
                seeds[i].piece == pieceOf(t) && d < nearest.second)
                nearest = {static_cast<int>(i), d};
        return nearest;
    };
    for (std::size_t t = 0; t < drape.triangles.size(); ++t)
        if (nearestTo(t).second > size) seeds.push_back({pieceOf(t), centreOf(drape.triangles[t], drape.start)});
    std::vector<int> patches;
    for (std::size_t t = 0; t < drape.triangles.size(); ++t) patches.push_back(nearestTo(t).first);
    return patches;
}

/// The share of the area in patches whose right side faces away from the body on the whole. A single triangle may face
/// it: folds hang over. What a fold adds to ∫ n·dA of a patch on one flank it takes away on the other.
double rightSideShare(const Drape& drape, const collision::BodySurface& surface) {
    constexpr double searchRadius = 0.5; // cloth farther off than this from the body is not worn anyway
    const std::vector<int> patches = patchesOf(drape);
    std::vector<double> areas(patches.size(), 0), outward(patches.size(), 0);
    for (std::size_t t = 0; t < patches.size(); ++t) {
        const auto& [a, b, c] = drape.triangles[t];
        const Vec3& corner = drape.positions[a];
        const Vec3 doubledArea = cross(drape.positions[b] - corner, drape.positions[c] - corner);
        areas[patches[t]] += 0.5 * length(doubledArea);
        if (const auto nearest = surface.nearest(centreOf(drape.triangles[t], drape.positions), searchRadius))
            outward[patches[t]] += 0.5 * dot(nearest->normal, doubledArea);
    }
    double whole = 0, right = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        whole += areas[i];
        if (outward[i] > 0) right += areas[i];
    }
    return whole > 0 ? right / whole : 0;
}

double turnedLength(const Drape& drape) {
    double sum = 0;
    for (const auto& [a, b] : turnedEdgesOf(drape.triangles))
        sum += geometry::distance(drape.positions[a], drape.positions[b]);
    return sum;
}

/// The point of a neck opening in the sagittal plane at the back.
Vec3 backNeckPoint(const std::vector<Vec3>& loop) {
    const double middle = meanOf(loop).z;
    Vec3 best = loop.front();
    double bestSide = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) { // where the loop passes x = 0 behind its middle
        const Vec3 &p = loop[i], &q = loop[(i + 1) % loop.size()];
        const double t = p.x == q.x ? 0 : std::clamp(p.x / (p.x - q.x), 0.0, 1.0);
        const Vec3 at = lerp(p, q, t);
        if (at.z < middle && std::abs(at.x) < bestSide) {
            bestSide = std::abs(at.x);
            best = at;
        }
    }
    return best;
}

void judgeNeckOrWaist(WornReport& report, const std::vector<Opening>& openings, const Drape& drape,
                      const body::Body& body, const WornSettings& settings) {
    const auto neck = std::ranges::find(report.openings, "neck", &OpeningReport::name);
    if (neck != report.openings.end()) {
        const auto& opening = openings[static_cast<std::size_t>(neck - report.openings.begin())];
        report.napeDistance =
            geometry::distance(backNeckPoint(pointsOf(opening, drape.positions)), body.landmarks.nape);
        if (*report.napeDistance > settings.napeDistance)
            report.why.push_back(
                fmt::format("The back-neck point lies {:.1f} mm from the nape.", 1000 * *report.napeDistance));
        return;
    }
    const auto top = std::ranges::max_element(report.openings, {}, &OpeningReport::startHeight);
    if (top == report.openings.end()) return;
    report.waistDrop = top->startHeight - top->height;
    if (std::abs(*report.waistDrop) > settings.waistDrop)
        report.why.push_back(fmt::format("The uppermost opening lies {:.1f} mm from the level it was placed at.",
                                         1000 * *report.waistDrop));
}

void judgeSymmetry(WornReport& report, const Drape& drape, const WornSettings& settings) {
    if (drape.mirrorPairs.empty()) return;
    double largest = 0;
    for (const auto& [left, right] : drape.mirrorPairs) {
        const Vec3& p = drape.positions[left];
        largest = std::max(largest, geometry::distance({-p.x, p.y, p.z}, drape.positions[right]));
    }
    report.symmetryDifference = largest;
    if (largest > settings.symmetry)
        report.why.push_back(fmt::format("Left and right differ by {:.1f} mm.", 1000 * largest));
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

std::vector<OpeningReport> openingReports(const std::vector<Opening>& openings, const Drape& drape,
                                          const body::Body& body) {
    const std::vector<NamedAxis> axes = axesOf(body);
    std::vector<OpeningReport> reports;
    for (const Opening& opening : openings) reports.push_back(openingReport(opening, drape, body, axes));
    return reports;
}

} // namespace

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
    report.rightSideOut = rightSideShare(drape, surface);
    if (report.rightSideOut < settings.rightSideShare)
        report.why.push_back(
            fmt::format("Only {:.1f} % of the cloth has its right side out.", 100 * report.rightSideOut));
    judgeNeckOrWaist(report, openings, drape, body, settings);
    judgeSymmetry(report, drape, settings);
    judgeStretch(report, drape, settings);
    report.worn = report.why.empty();
    return report;
}

} // namespace toile::simulation
