// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/StripImprovement.h"
#include "core/base/Index.h"

#include "core/meshing/FlatTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace toile::meshing {
namespace {

/// Angles are compared by their cotangents, which fall as they grow and need no more than products: there is none
/// greater than this.
constexpr double flat = std::numeric_limits<double>::infinity();

double dotAt(GridPoint corner, GridPoint a, GridPoint b) {
    const double ax = static_cast<double>(a.x) - corner.x, ay = static_cast<double>(a.y) - corner.y;
    const double bx = static_cast<double>(b.x) - corner.x, by = static_cast<double>(b.y) - corner.y;
    return ax * bx + ay * by;
}

} // namespace

void StripImprover::run(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                        const NodePlaces& places, GridFill& fill, CellLayer& layer, Strip& strip,
                        const ImprovementSettings& settings) {
    boundary_ = &boundary;
    lattice_ = &lattice;
    places_ = &places;
    fill_ = &fill;
    layer_ = &layer;
    strip_ = &strip;
    settings_ = settings;
    wanted_ = 1 / std::tan(settings.wantedAngle * std::numbers::pi / 180);
    moved_.clear();
    dropped_.clear();
    added_.clear();
    after_.assign(boundary.points.size(), -1);
    folds_.assign(boundary);
    for (const auto& ring : boundary.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) after_[at(ring[i])] = ring[i + 1 < ring.size() ? i + 1 : 0];
    collect();
    triangulate();
    gradeAll();
    if (!bad_.empty()) {
        keepAsBest();
        for (int pass = 0; pass < settings_.passes && !bad_.empty(); ++pass) {
            changed_.clear();
            const bool moved = moveNodes();
            const bool freed = (pass % 2 == 1 || !moved) && freeNodes();
            const bool added = (pass % 2 == 1 || !moved) && addNodes();
            if (!moved && !freed && !added) break;
            follow(freed);
            if (grade_.betterThan(best_.grade)) keepAsBest();
        }
        restoreBest();
    }
    finish(frame);
}

/// Walls and nodes of the strip, as the filled cells leave them.
void StripImprover::collect() {
    collector_.run(*boundary_, *lattice_, *fill_, *layer_);
    strip_->points.clear();
    for (const int node : layer_->stripNodes) strip_->points.push_back(places_->grid(node));
    for (const auto& [node, place] : moved_)
        if (layer_->isInStrip(node)) strip_->points[at(layer_->stripIndex[at(node)])] = place;
}

void StripImprover::triangulate() {
    sweep_.run(strip_->points, layer_->walls, strip_->sides);
    flips_.run(strip_->points, strip_->sides);
}

/// Triangulates and grades again what a pass has changed: the same as doing all anew, for Delaunay triangles are
/// determined by the points.
void StripImprover::follow(bool freed) {
    if (settings_.anew || (freed && !canFillLocally())) {
        collect();
        best_.collected = false;
        triangulate();
        gradeAll();
        return;
    }
    if (freed) fillDropped();
    flips_.runFrom(changed_, strip_->points, strip_->sides);
    sharpness_.resize(at(strip_->sides.triangles()));
    for (const std::span<const int> sides : {std::span<const int>(changed_), flips_.turned()})
        for (const int side : sides) sharpness_[at(side / 3)] = sharpness(side / 3);
    listBad();
    turnFlatOnes();
}

/// The corner where a side starts is the border's own: nothing inside can change its angle.
bool StripImprover::isBorderAngle(int side) const {
    const int here = nodeOf(strip_->sides.startOf(side)), next = nodeOf(strip_->sides.endOf(side)),
              before = nodeOf(strip_->sides.apexOf(side)), count = places_->borderCount();
    return here < count && next < count && before < count && after_[at(here)] == next && after_[at(before)] == here;
}

/// Cotangent of the smallest angle of a triangle, the border's own corners left out; infinite where it has no area
/// or is turned over.
double StripImprover::sharpness(int triangle) const {
    const std::array<int, 3> t = strip_->sides.corners(triangle);
    const GridPoint a = point(t[0]), b = point(t[1]), c = point(t[2]);
    const std::int64_t area = orientation(a, b, c);
    if (area <= 0) return flat;
    const std::array<double, 3> dots{dotAt(a, b, c), dotAt(b, c, a), dotAt(c, a, b)};
    double sharpest = -flat;
    for (std::size_t i = 0; i < 3; ++i)
        if (dots[i] > sharpest && !isBorderAngle(3 * triangle + static_cast<int>(i))) sharpest = dots[i];
    return sharpest / static_cast<double>(area);
}

/// Grades the strip and lists what is below the wanted angle; flat triangles are among that, and are turned.
void StripImprover::gradeAll() {
    gradeEach();
    turnFlatOnes();
}

void StripImprover::gradeEach() {
    sharpness_.resize(at(strip_->sides.triangles()));
    for (int t = 0; t < strip_->sides.triangles(); ++t) sharpness_[at(t)] = sharpness(t);
    listBad();
}

void StripImprover::turnFlatOnes() {
    if (!bad_.empty() && turnFlatTriangles(bad_, strip_->points, strip_->sides)) gradeEach();
}

void StripImprover::listBad() {
    bad_.clear();
    grade_ = {0, -flat};
    for (std::size_t t = 0; t < sharpness_.size(); ++t) {
        grade_.sharpest = std::max(grade_.sharpest, sharpness_[t]);
        if (sharpness_[t] > wanted_) bad_.push_back(static_cast<int>(t));
    }
    grade_.bad = static_cast<int>(bad_.size());
}

void StripImprover::keepAsBest() {
    best_.grade = grade_;
    best_.points = strip_->points;
    best_.sides = strip_->sides;
    best_.stripNodes = layer_->stripNodes;
    best_.isFree = layer_->isFree;
    best_.dropped = dropped_.size();
    best_.added = added_.size();
    best_.collected = true;
}

/// Fills what was given up since, and gives back the nodes taken since; mixed cells are listed again.
void StripImprover::restoreBest() {
    for (; added_.size() > best_.added; added_.pop_back()) fill_->inner[at(added_.back())] = 0;
    for (std::size_t i = best_.dropped; i < dropped_.size(); ++i) fill_->filled[at(dropped_[i])] = 1;
    if (!best_.collected) collector_.run(*boundary_, *lattice_, *fill_, *layer_);
    layer_->stripNodes = best_.stripNodes;
    layer_->isFree = best_.isFree;
    for (std::size_t v = 0; v < best_.stripNodes.size(); ++v)
        layer_->stripIndex[at(best_.stripNodes[v])] = static_cast<int>(v);
    strip_->points = best_.points;
    strip_->sides = best_.sides;
}

/// Places of the nodes, and the region of each triangle: that of the main cell in which its middle lies.
void StripImprover::finish(const PieceFrame& frame) {
    strip_->places.clear();
    for (std::size_t v = 0; v < strip_->points.size(); ++v) {
        const int node = layer_->stripNodes[v];
        const bool lies = !layer_->isFree[v] || strip_->points[v] == places_->grid(node);
        strip_->places.push_back(lies ? (*places_)(node) : frame.placeOf(strip_->points[v]));
    }
    strip_->region.assign(at(strip_->sides.triangles()), -1);
    if (lattice_->region.empty()) return;
    for (int t = 0; t < strip_->sides.triangles(); ++t) {
        Vec2 middle;
        for (const int corner : strip_->sides.corners(t)) middle += strip_->places[at(corner)] / 3.0;
        strip_->region[at(t)] =
            lattice_->regionOf(lattice_->cell(lattice_->columnOf(middle.x), lattice_->rowOf(middle.y)));
    }
}

/// Collects the triangles of each strip node.
void StripImprover::collectStars() {
    const std::vector<int>& corners = strip_->sides.start;
    firstOfStar_.assign(strip_->points.size() + 1, 0);
    for (const int vertex : corners) ++firstOfStar_[at(vertex)];
    std::partial_sum(firstOfStar_.begin(), firstOfStar_.end(), firstOfStar_.begin());
    stars_.resize(corners.size());
    for (std::size_t side = corners.size(); side-- > 0;)
        stars_[at(--firstOfStar_[at(corners[side])])] = static_cast<int>(side / 3);
}

std::span<const int> StripImprover::star(int vertex) const {
    const int first = firstOfStar_[at(vertex)];
    return std::span(stars_).subspan(at(first), at(firstOfStar_[at(vertex) + 1] - first));
}

bool StripImprover::moveNodes() {
    constexpr std::size_t crowded = 24; // triangles: a node of so many cannot have good angles
    movable_.clear();
    for (const int t : bad_)
        for (const int vertex : strip_->sides.corners(t))
            if (layer_->isFree[at(vertex)]) movable_.push_back(vertex);
    if (movable_.empty()) return false;
    std::sort(movable_.begin(), movable_.end(), [&](int a, int b) { return nearerMiddle(point(a), point(b)); });
    movable_.erase(std::unique(movable_.begin(), movable_.end()), movable_.end());
    collectStars();
    bool moved = false;
    for (const int vertex : movable_)
        if (star(vertex).size() < crowded) moved |= moveNode(vertex);
    return moved;
}

void StripImprover::collectRim(int vertex) {
    rim_.clear();
    for (const int t : star(vertex)) {
        std::array<int, 3> corners = strip_->sides.corners(t);
        while (corners[0] != vertex) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        rim_.push_back({point(corners[1]), point(corners[2])});
    }
}

/// Cotangent of the smallest angle of the triangles between the rim and a place for the node in its middle, or one that
/// is not below the limit; infinite if a triangle would turn over. None of the angles is the border's own.
double StripImprover::starSharpness(GridPoint middle, double limit) const {
    double sharpest = -flat;
    for (const auto& [a, b] : rim_) {
        const std::int64_t area = orientation(middle, a, b);
        if (area <= 0) return flat;
        const double dots = std::max({dotAt(middle, a, b), dotAt(a, b, middle), dotAt(b, middle, a)});
        sharpest = std::max(sharpest, dots / static_cast<double>(area));
        if (sharpest >= limit) break;
    }
    return sharpest;
}

/// Tries steps all round that shrink, on both sides of the piece's middle in the mirrored order.
bool StripImprover::moveNode(int vertex) {
    constexpr double leastGain = 1e-6; // [rad]: the cotangent of an angle falls by 1 + its square
    const GridPoint before = point(vertex);
    GridPoint place = before;
    collectRim(vertex);
    double best = starSharpness(place, flat);
    double squaredReach = 0;
    for (const auto& side : rim_)
        for (const GridPoint other : side) squaredReach = std::max(squaredReach, dotAt(before, other, other));
    const double reach = std::sqrt(squaredReach), outwards = before.x < 0 ? -1 : 1;
    for (double step = 0.3 * reach; step > 0.02 * reach; step *= 0.6)
        for (int direction = 0; direction < 8; ++direction) {
            const double dx = outwards * std::array<double, 8>{1, 0.7, 0, -0.7, -1, -0.7, 0, 0.7}[at(direction)];
            const double dy = std::array<double, 8>{0, 0.7, 1, 0.7, 0, -0.7, -1, -0.7}[at(direction)];
            const GridPoint there{place.x + static_cast<std::int32_t>(std::lround(dx * step)),
                                  place.y + static_cast<std::int32_t>(std::lround(dy * step))};
            const double least = best < flat ? best - leastGain * (1 + best * best) : flat;
            const double sharp = starSharpness(there, least);
            if (sharp >= least) continue;
            best = sharp;
            place = there;
        }
    if (place == before) return false;
    strip_->points[at(vertex)] = place;
    moved_.emplace_back(nodeOf(vertex), place);
    for (const int t : star(vertex)) changed_.insert(changed_.end(), {3 * t, 3 * t + 1, 3 * t + 2});
    return true;
}

} // namespace toile::meshing
