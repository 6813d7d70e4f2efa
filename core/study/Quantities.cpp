// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Quantities.h"

#include "core/base/Contracts.h"
#include "core/body/Measuring.h"
#include "core/geometry/Polygon.h"
#include "core/simulation/BackNeck.h"
#include "core/simulation/Inspect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace toile::study {
namespace {

constexpr double contactMargin = 0.5e-3; ///< beyond the distance that contact keeps [m]

using simulation::Opening;
using simulation::OpeningReport;

/// A number, or the sentence why there is none.
using Found = tl::expected<double, std::string>;

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

Found contactArea(const Seen& all) {
    std::vector<bool> touches;
    for (std::size_t i = 0; i < all.cloth.vertices.size(); ++i) {
        const auto nearest = all.worn.surface->nearest(all.cloth.vertices[i], all.worn.touching[i] + contactMargin);
        touches.push_back(nearest && nearest->signedDistance <= all.worn.touching[i] + contactMargin);
    }
    double area = 0;
    for (const auto& [a, b, c] : all.cloth.triangles) {
        const auto &p = all.cloth.vertices[a], &q = all.cloth.vertices[b], &r = all.cloth.vertices[c];
        area += length(cross(q - p, r - p)) / 2 * (int(touches[a]) + int(touches[b]) + int(touches[c])) / 3;
    }
    return area;
}

struct Description {
    const char *name, *key;
    Measure measure;
};

constexpr std::array descriptions{Description{"hem at the centre front", "hemFront", Measure::length},
                                  Description{"hem at the centre back", "hemBack", Measure::length},
                                  Description{"hem at the left side", "hemLeft", Measure::length},
                                  Description{"hem at the right side", "hemRight", Measure::length},
                                  Description{"folds at the hem", "hemFolds", Measure::count},
                                  Description{"ease at the bust", "bustEase", Measure::length},
                                  Description{"ease at the waist", "waistEase", Measure::length},
                                  Description{"ease at the hip", "hipEase", Measure::length},
                                  Description{"back neck to nape", "napeDistance", Measure::length},
                                  Description{"height of the shoulder points", "shoulderHeight", Measure::length},
                                  Description{"distance of the shoulder points", "shoulderDistance", Measure::length},
                                  Description{"contact with the body", "contactArea", Measure::area},
                                  Description{"strain along warp, 95 %", "warpStrain", Measure::strain},
                                  Description{"strain along weft, 95 %", "weftStrain", Measure::strain},
                                  Description{"shear, 95 %", "shear", Measure::strain}};
constexpr std::size_t ofTheBody = 12; ///< of them; the others need none

void appendWorn(std::vector<Found>& found, const WornDrape& worn) {
    if (!worn.body || worn.body->axes.empty()) {
        found.insert(found.end(), ofTheBody, absent("There is no body with limbs."));
        return;
    }
    const Seen all = seen(worn);
    appendHem(found, all);
    for (const double level : {all.body.landmarks.bustLeft.y, all.body.landmarks.waist.y, all.body.landmarks.hip.y})
        found.push_back(easeAt(level, all));
    found.push_back(napeDistance(all));
    appendShoulders(found, all);
    found.push_back(contactArea(all));
}

} // namespace

double resolutionOf(Measure measure) {
    switch (measure) {
    case Measure::length: return 0.5e-3; // half a division of a tape
    case Measure::strain: return 0.5e-3;
    case Measure::area: return 1e-3;
    case Measure::count: break;
    }
    return 0.5;
}

double shown(Measure measure, double value) {
    switch (measure) {
    case Measure::length: return 1e3 * value;
    case Measure::strain: return 1e2 * value;
    case Measure::area: return 1e4 * value;
    case Measure::count: break;
    }
    return value;
}

std::string_view unitOf(Measure measure) {
    switch (measure) {
    case Measure::length: return "mm";
    case Measure::strain: return "%";
    case Measure::area: return "cm²";
    case Measure::count: break;
    }
    return "";
}

int foldsOf(const std::vector<Vec3>& line) {
    constexpr double deep = 0.005; // [m]
    std::vector<Vec2> seenFromAbove;
    for (const Vec3& p : line) seenFromAbove.push_back({p.x, p.z});
    const std::vector<Vec2> tape = body::convexHull(seenFromAbove);
    const auto inValley = [&](const Vec2& p) { return geometry::distanceToBorder(tape, p) > deep; };
    int folds = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
        folds += inValley(seenFromAbove[i]) && !inValley(seenFromAbove[(i + 1) % line.size()]);
    return folds;
}

std::vector<Quantity> quantitiesOf(const WornDrape& worn) {
    std::vector<Found> found;
    appendWorn(found, worn);
    for (const double strain :
         {worn.strain.warpPercentile95, worn.strain.weftPercentile95, worn.strain.shearPercentile95})
        found.push_back(strain);
    expects(found.size() == descriptions.size(), "a finding for each quantity");
    std::vector<Quantity> quantities = noQuantities();
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i]) quantities[i].value = *found[i];
        else quantities[i].whyAbsent = found[i].error();
    return quantities;
}

std::vector<Quantity> noQuantities() {
    std::vector<Quantity> quantities;
    for (const auto& [name, key, measure] : descriptions) quantities.push_back({name, key, measure, std::nullopt, ""});
    return quantities;
}

std::vector<Quantity> quantitiesOf(const simulation::Simulation& simulation) {
    const simulation::Drape drape = simulation::drapeOf(simulation);
    const simulation::Scene& scene = simulation.scene();
    WornDrape worn{
        drape, scene.body ? &**scene.body : nullptr, simulation.body(), {}, simulation::strainOf(simulation)};
    for (const double half : simulation.garment().halfThickness)
        worn.touching.push_back(scene.settings.skinOffset + half);
    return quantitiesOf(worn);
}

} // namespace toile::study
