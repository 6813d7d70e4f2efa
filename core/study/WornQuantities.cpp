// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/WornQuantities.h"

#include "core/body/Measuring.h"
#include "core/simulation/BackNeck.h"
#include "core/simulation/Inspect.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace toile::study {
namespace {

using simulation::Opening;
using simulation::OpeningReport;

Found absent(const char* why) {
    return tl::unexpected(std::string(why));
}

/// A garment with its borders and what passes through them.
struct Seen {
    const WornDrape& worn;
    const body::Body& body;
    geometry::TriangleMesh cloth;
    std::vector<Opening> rims;
    std::vector<OpeningReport> reports; ///< of each rim
};

Seen seen(const WornDrape& worn) {
    Seen all{worn, *worn.body, {worn.drape.positions, {}}, {}, {}};
    for (const auto& t : worn.drape.triangles)
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) all.cloth.triangles.push_back(t);
    all.rims = simulation::openingsOf(all.cloth.triangles);
    all.reports = simulation::openingReports(all.rims, worn.drape, *worn.body);
    return all;
}

std::vector<Vec3> pointsOf(const Opening& rim, const Seen& all) {
    std::vector<Vec3> points;
    for (const int particle : rim) points.push_back(all.cloth.vertices[particle]);
    return points;
}

const Opening* rimNamed(const Seen& all, std::string_view name) {
    const auto report = std::ranges::find(all.reports, name, &OpeningReport::name);
    return report == all.reports.end() ? nullptr : &all.rims[static_cast<std::size_t>(report - all.reports.begin())];
}

/// The lowest border that goes round the trunk or round both legs. One alone, without a neckline above it, is a waist.
tl::expected<const Opening*, std::string> hemOf(const Seen& all) {
    const Opening* hem = nullptr;
    double lowest = 0;
    int round = 0;
    for (std::size_t i = 0; i < all.rims.size(); ++i) {
        const auto& limbs = all.reports[i].limbs;
        const bool trunk = std::ranges::count(limbs, "torso") > 0;
        if (!trunk && (std::ranges::count(limbs, "left leg") == 0 || std::ranges::count(limbs, "right leg") == 0))
            continue;
        ++round;
        if (hem && all.reports[i].height >= lowest) continue;
        hem = &all.rims[i];
        lowest = all.reports[i].height;
    }
    if (round > (rimNamed(all, "neck") ? 0 : 1)) return hem;
    return tl::unexpected(std::string("No hem goes round the body: each leg has its own, or there is none."));
}

/// Mean height where the line passes the upright half-plane that begins at the centre and lies in this level direction.
Found heightTowards(const Vec3& direction, const Vec3& centre, const std::vector<Vec3>& line) {
    const Vec3 across{direction.z, 0, -direction.x};
    double sum = 0;
    int times = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 p = line[i] - centre, q = line[(i + 1) % line.size()] - centre;
        const double from = dot(p, across), to = dot(q, across);
        if ((from < 0) == (to < 0)) continue;
        const Vec3 through = lerp(p, q, from / (from - to));
        if (dot(through, direction) <= 0) continue;
        sum += (centre + through).y;
        ++times;
    }
    return times > 0 ? Found(sum / times) : absent("The hem does not pass there.");
}

void appendHem(std::vector<Found>& found, const Seen& all) {
    const auto hem = hemOf(all);
    const auto trunk = body::acrossTrunk(all.body, all.body.landmarks.hip.y);
    if (!hem || !trunk) {
        found.insert(found.end(), 5, hem ? absent("The body has no trunk.") : tl::unexpected(hem.error()));
        return;
    }
    const std::vector<Vec3> line = pointsOf(**hem, all);
    for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}})
        found.push_back(heightTowards(direction, trunk->origin, line));
    found.push_back(foldsOf(line));
}

/// The cloth's own length round the trunk, less what a tape round the body finds at the same level.
Found easeAt(double height, const Seen& all) {
    const auto plane = body::acrossTrunk(all.body, height);
    const auto tape = plane ? body::sectionRound(all.body.mesh, *plane) : std::nullopt;
    if (!tape) return absent("No tape goes round the body there.");
    const auto girth = body::sectionRound(all.cloth, *plane);
    if (!girth) return absent("The garment does not go round the body there.");
    // A section that meets a border was closed by a straight line.
    for (const Opening& rim : all.rims)
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const Vec3 &p = all.cloth.vertices[rim[i]], &q = all.cloth.vertices[rim[(i + 1) % rim.size()]];
            if ((p.y < height) == (q.y < height)) continue;
            const Vec3 border = lerp(p, q, (height - p.y) / (q.y - p.y));
            constexpr double same = 1e-9; // [m]
            if (std::ranges::any_of(girth->points, [&](const Vec3& x) { return distance(x, border) < same; }))
                return absent("The garment is open there.");
        }
    return body::perimeter(*girth) - body::tapeGirth(*tape);
}

Found napeDistance(const Seen& all) {
    const Opening* neck = rimNamed(all, "neck");
    if (!neck) return absent("No opening goes round the neck.");
    const auto& drape = all.worn.drape;
    return simulation::backNeckOf(*neck, drape.triangles, drape.piece, drape.positions, all.body.landmarks)
        .napeDistance;
}

/// Of each particle, how many pieces and borders meet there.
std::vector<int> meetingsOf(const Seen& all) {
    std::vector<std::set<int>> pieces(all.cloth.vertices.size());
    const auto& drape = all.worn.drape;
    for (std::size_t t = 0; t < drape.piece.size(); ++t)
        for (const int particle : drape.triangles[t]) pieces[particle].insert(drape.piece[t]);
    std::vector<int> meetings;
    for (const auto& of : pieces) meetings.push_back(static_cast<int>(of.size()));
    for (const Opening& rim : all.rims)
        for (const int particle : rim) ++meetings[particle];
    return meetings;
}

/// Where the shoulder seam ends: at the sleeve, or at the border of a garment without one.
std::optional<Vec3> shoulderPoint(const Vec3& acromion, const std::vector<int>& meetings, const Seen& all) {
    constexpr double farthest = 0.08; // [m]; a raglan sleeve has no such point
    std::optional<Vec3> nearest;
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        const Vec3& p = all.cloth.vertices[i];
        if (meetings[i] >= 3 && distance(p, acromion) < (nearest ? distance(*nearest, acromion) : farthest))
            nearest = p;
    }
    return nearest;
}

void appendShoulders(std::vector<Found>& found, const Seen& all) {
    const std::vector<int> meetings = meetingsOf(all);
    const auto left = shoulderPoint(all.body.landmarks.acromionLeft, meetings, all),
               right = shoulderPoint(all.body.landmarks.acromionRight, meetings, all);
    if (!left || !right) {
        found.insert(found.end(), 2, absent("No seam ends at the shoulders."));
        return;
    }
    found.push_back(0.5 * (left->y + right->y));
    found.push_back(distance(*left, *right));
}

} // namespace

std::vector<Found> wornQuantities(const WornDrape& worn) {
    if (!worn.body || worn.body->axes.empty())
        return std::vector<Found>(wornQuantityCount, absent("There is no body with limbs."));
    const Seen all = seen(worn);
    std::vector<Found> found;
    appendHem(found, all);
    for (const double level : {all.body.landmarks.bustLeft.y, all.body.landmarks.waist.y, all.body.landmarks.hip.y})
        found.push_back(easeAt(level, all));
    found.push_back(napeDistance(all));
    appendShoulders(found, all);
    return found;
}

} // namespace toile::study
