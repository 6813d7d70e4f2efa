// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/BodyProfile.h"
#include "core/body/LimbTrace.h"
#include "core/body/Mannequin.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <optional>

namespace toile::body {

namespace {

using geometry::TriangleMesh;

/// The side of the body that is traced; the other one is traced in a mirror.
struct Side {
    Vec3 neck, acromion, bust, wrist, ankle;
    std::vector<Vec3> arm, leg;
};

tl::unexpected<Error> notABody(const std::string& name, const std::string& reason) {
    return fail(ErrorCode::invalidInput,
                fmt::format("The shape does not look like a body that stands upright, faces +z and holds its arms away "
                            "from its sides: {}.",
                            reason),
                {.object = name});
}

/// The place in [low, high] where a function is least, looked for on a grid.
double placeOfLeast(double low, double high, int steps, const std::function<double(double)>& f) {
    double best = low, least = f(low);
    for (int n = 1; n <= steps; ++n) {
        const double at = low + (high - low) * n / steps;
        if (const double value = f(at); value < least) least = value, best = at;
    }
    return best;
}

struct Trunk {
    double crotch = 0, hip = 0, waist = 0, bust = 0, armpit = 0, sideNeck = 0, nape = 0, frontNeck = 0, throat = 0;
};

/// Reads heights off the sections of one mesh.
class TrunkReader {
public:
    TrunkReader(const TriangleMesh& mesh, const BodyProfile& profile) : mesh_(mesh), profile_(profile) {}

    [[nodiscard]] double at(double fraction) const { return profile_.floor + fraction * profile_.height; }
    [[nodiscard]] std::optional<SectionLoop> loop(double y) const { return trunkAt(mesh_, profile_, y); }
    [[nodiscard]] double girth(double y) const {
        const auto outline = loop(y);
        return outline ? tapeGirth(*outline) : 1e9;
    }
    [[nodiscard]] double halfWidth(double y) const {
        const auto outline = loop(y);
        return outline ? (boundsOf(*outline).high.x - boundsOf(*outline).low.x) / 2 : 1e9;
    }
    [[nodiscard]] double front(double y) const {
        const auto outline = loop(y);
        return outline ? boundsOf(*outline).high.z : -1e9;
    }

    /// Where the legs join, by halving; none if there is no such place between knee and waist.
    [[nodiscard]] std::optional<double> crotch() const {
        double low = at(0.30), high = at(0.60);
        if (loop(low) || !loop(high)) return std::nullopt;
        while (high - low > 1e-4 * profile_.height) {
            const double middle = (low + high) / 2;
            (loop(middle) ? high : low) = middle;
        }
        return high;
    }
    /// Where the arms leave the trunk: going up, the outline becomes suddenly wider.
    [[nodiscard]] double armpit(double from) const {
        const double step = 0.005 * profile_.height;
        double width = halfWidth(from);
        for (double y = from + step; y < at(0.88); y += step) {
            const double next = halfWidth(y);
            if (next > width + 0.035 * profile_.height) return y - step;
            width = next;
        }
        return 0;
    }
    /// Going down from the throat, where the neck has become wider by a share.
    [[nodiscard]] double flare(double throat, double share) const {
        const double wanted = share * halfWidth(throat), step = 0.002 * profile_.height;
        double y = throat;
        while (y > at(0.7) && halfWidth(y) < wanted) y -= step;
        return y;
    }

private:
    const TriangleMesh& mesh_;
    const BodyProfile& profile_;
};

/// The foremost level of the chest. A flat chest has none: there it is the one that stands out most before a
/// line from the ribs to the collar.
double bustLevel(const TrunkReader& read, double armpit, double h) {
    const double step = 0.003 * h, low = armpit - 0.09 * h, high = armpit + 0.01 * h;
    std::vector<double> front;
    for (double y = high; y > low; y -= step) front.push_back(read.front(y));
    for (std::size_t i = 4; i + 4 < front.size(); ++i) {
        const auto near = std::ranges::subrange(front.begin() + static_cast<std::ptrdiff_t>(i - 4),
                                                front.begin() + static_cast<std::ptrdiff_t>(i + 5));
        if (front[i] >= *std::ranges::max_element(near)) return high - step * static_cast<double>(i);
    }
    const double ribs = read.front(low), collar = read.front(armpit + 0.06 * h);
    return placeOfLeast(low, high, 40,
                        [&](double y) { return ribs + (collar - ribs) * (y - low) / (0.15 * h) - read.front(y); });
}

/// Heights of the trunk; the fractions of the stature bound where each is looked for.
Result<Trunk> trunkOf(const std::string& name, const TriangleMesh& mesh, const BodyProfile& profile) {
    const TrunkReader read(mesh, profile);
    const double h = profile.height;
    Trunk t;
    const auto crotch = read.crotch();
    if (!crotch) return notABody(name, "there are no two legs that join between knee and waist");
    t.crotch = *crotch;
    t.armpit = read.armpit(t.crotch + 0.12 * h);
    if (t.armpit == 0) return notABody(name, "no arms leave the trunk below the shoulders");
    t.throat = placeOfLeast(read.at(0.82), read.at(0.92), 50, [&](double y) { return read.girth(y); });
    t.sideNeck = read.flare(t.throat, 1.45);
    if (t.sideNeck < t.armpit || read.girth(t.throat) > 0.5 * read.girth(t.armpit))
        return notABody(name, "there is no neck between shoulders and head");
    t.nape = t.sideNeck + 0.006 * h;
    t.frontNeck = t.sideNeck - 0.025 * h;
    t.bust = bustLevel(read, t.armpit, h);
    t.waist = placeOfLeast(t.crotch + 0.10 * h, t.bust - 0.05 * h, 60, [&](double y) { return read.girth(y); });
    t.hip = placeOfLeast(t.crotch + 0.001 * h, t.waist, 80, [&](double y) { return -read.girth(y); });
    return t;
}

Vec3 middleAt(const TrunkReader& read, const BodyProfile& profile, double y) {
    const auto outline = read.loop(y);
    const auto ends = outline ? crossingsAt(*outline, profile.middle) : std::nullopt;
    return ends ? lerp(ends->back, ends->front, 0.5) : Vec3{profile.middle, y, 0};
}

/// The landmarks and limbs of the left side.
Result<Side> leftSideOf(const std::string& name, const TriangleMesh& mesh, const BodyProfile& profile,
                        const Trunk& trunk) {
    const TrunkReader read(mesh, profile);
    Side side;
    side.neck = farthest(*read.loop(trunk.sideNeck), {1, 0, 0});
    const auto shoulder = shoulderOf(mesh, profile, side.neck, trunk.armpit);
    if (!shoulder) return notABody(name, "no shoulder was found between neck and arm");
    side.acromion = shoulder->acromion;
    side.bust = farthest(*read.loop(trunk.bust), {0.26, 0, 1}); // a breast points a little outward
    const auto arm = armOf(mesh, profile, shoulder->joint);
    if (!arm) return notABody(name, "no arm could be followed from the shoulder to the hand");
    side.arm = arm->axis;
    side.wrist = arm->wrist;
    const auto leg = legOf(mesh, profile, trunk.crotch);
    if (!leg) return notABody(name, "no leg could be followed from the crotch to the floor");
    if (!leg->facesFront)
        return fail(ErrorCode::invalidInput, "The body's toes point toward −z; turn it round so that it faces +z.",
                    {.object = name});
    side.leg = leg->axis;
    side.ankle = leg->ankle;
    return side;
}

Side mirrored(Side side, double middle) {
    const auto flip = [&](Vec3& p) { p.x = 2 * middle - p.x; };
    for (Vec3* p : {&side.neck, &side.acromion, &side.bust, &side.wrist, &side.ankle}) flip(*p);
    std::ranges::for_each(side.arm, flip);
    std::ranges::for_each(side.leg, flip);
    return side;
}

Landmarks landmarksOf(const TrunkReader& read, const BodyProfile& profile, const Trunk& t, const Side& left,
                      const Side& right) {
    Landmarks l;
    const auto backAndFront = [&](double y) {
        return crossingsAt(*read.loop(y), profile.middle).value_or(BackAndFront{});
    };
    l.nape = backAndFront(t.nape).back;
    l.frontNeck = backAndFront(t.frontNeck).front;
    l.neckLeft = left.neck, l.neckRight = right.neck;
    l.acromionLeft = left.acromion, l.acromionRight = right.acromion;
    l.bustLeft = left.bust, l.bustRight = right.bust;
    l.waist = middleAt(read, profile, t.waist);
    l.hip = middleAt(read, profile, t.hip);
    const Vec3 crotch = middleAt(read, profile, t.crotch + 1e-3 * profile.height);
    l.crotch = {profile.middle, t.crotch, crotch.z};
    l.wristLeft = left.wrist, l.wristRight = right.wrist;
    l.ankleLeft = left.ankle, l.ankleRight = right.ankle;
    return l;
}

std::vector<LimbAxis> axesOf(const TrunkReader& read, const BodyProfile& profile, const Trunk& t, const Side& left,
                             const Side& right) {
    const double h = profile.height;
    const auto middle = [&](double y) { return middleAt(read, profile, y); };
    const Vec3 chest = middle(t.armpit), base = middle(t.sideNeck), head = middle(read.at(0.94));
    const Vec3 below = middle(t.crotch + 0.02 * h);
    return {
        {Limb::neck, {chest, base, middle(t.throat), head, {head.x, read.at(1.06), head.z}}},
        {Limb::torso,
         {base, chest, middle(t.bust), middle(t.waist), middle(t.hip), below, {below.x, t.crotch - 0.27 * h, below.z}}},
        {Limb::leftArm, left.arm},
        {Limb::rightArm, right.arm},
        {Limb::leftLeg, left.leg},
        {Limb::rightLeg, right.leg}};
}

} // namespace

Result<Body> recognizedBody(std::string name, TriangleMesh mesh) {
    const BodyProfile profile = profileOf(mesh);
    if (mesh.triangles.empty() || !(profile.height > 0.5 && profile.height < 3))
        return notABody(name, fmt::format("it is {:.2f} m high", mesh.vertices.empty() ? 0 : profile.height));
    const auto trunk = trunkOf(name, mesh, profile);
    if (!trunk) return tl::unexpected(trunk.error());
    const auto left = leftSideOf(name, mesh, profile, *trunk);
    if (!left) return tl::unexpected(left.error());
    const auto right = leftSideOf(name, mirrored(mesh, profile.middle), profile, *trunk);
    if (!right) return tl::unexpected(right.error());
    const Side other = mirrored(*right, profile.middle);
    const TrunkReader read(mesh, profile);
    Landmarks landmarks = landmarksOf(read, profile, *trunk, *left, other);
    std::vector<LimbAxis> axes = axesOf(read, profile, *trunk, *left, other);
    return Body{std::move(name), std::move(mesh), landmarks, std::move(axes)};
}

} // namespace toile::body
