// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/StripSweep.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <utility>

namespace toile::meshing {
namespace {

constexpr int none = -1;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// The sweep moves askew to the grain: along it, a whole row of nodes would see but one point of the next.
constexpr std::int64_t sweepX = 739, sweepY = 443;

/// What owns a link of a chain: a side of a triangle, nothing because it is a wall, or nothing yet because both ways
/// along one segment are links; then they name each other.
constexpr int wallOwner = -1;
constexpr int awaiting(int node) {
    return -2 - node;
}
constexpr bool isAwaiting(int owner) {
    return owner <= -2;
}
constexpr int partnerOf(int owner) {
    return -2 - owner;
}

} // namespace

void StripSweep::run(std::span<const GridPoint> points, std::span<const Wall> walls, TriangleSides& sides) {
    points_ = points;
    sides_ = &sides;
    sides.start.clear();
    sides.twin.clear();
    crossed_.clear();
    nodes_.clear();
    unusedNodes_.clear();
    sortPoints();
    listWalls(walls);
    for (const auto& [along, vertex] : order_) visit(vertex);
    expects(crossed_.empty(), "walls are closed");
}

void StripSweep::sortPoints() {
    constexpr std::int64_t least = -(sweepX + sweepY) * std::int64_t{gridLimit};
    order_.clear();
    for (int v = 0; v < static_cast<int>(points_.size()); ++v)
        order_.emplace_back(static_cast<std::uint64_t>(sweepX * at(v).x + sweepY * at(v).y - least), v);
    sortByKey(order_, orderBuffer_);
    forEachDraw(order_, [&](std::span<KeyedNode> draw) {
        std::sort(draw.begin(), draw.end(),
                  [&](const KeyedNode& a, const KeyedNode& b) { return at(a.second).x < at(b.second).x; });
    });
    rank_.resize(points_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) rank_[index(order_[i].second)] = static_cast<int>(i);
}

void StripSweep::listWalls(std::span<const Wall> walls) {
    walls_.clear();
    firstWall_.assign(points_.size(), none);
    after_.clear();
    for (const Wall& wall : walls) {
        const bool rising = rank_[index(wall.from)] < rank_[index(wall.to)];
        const int left = rising ? wall.from : wall.to;
        after_.push_back(firstWall_[index(left)]);
        firstWall_[index(left)] = static_cast<int>(walls_.size());
        walls_.push_back({left, rising ? wall.to : wall.from, rising, none});
    }
}

/// The walls that start at a point, from the lowest to the highest.
void StripSweep::collectStarts(int vertex) {
    starts_.clear();
    for (int wall = firstWall_[index(vertex)]; wall != none; wall = after_[index(wall)])
        starts_.push_back(walls_[index(wall)]);
    if (starts_.size() > 1)
        std::sort(starts_.begin(), starts_.end(), [&](const Crossed& a, const Crossed& b) {
            const std::int64_t turn = orientation(at(vertex), at(a.right), at(b.right));
            return turn != 0 ? turn > 0 : a.insideAbove < b.insideAbove; // of a fold's, first that of the strip below
        });
}

/// Joins a point to the chains it sees, closes those whose walls end at it and begins those of walls that start.
void StripSweep::visit(int vertex) {
    const auto first = std::partition_point(crossed_.begin(), crossed_.end(), [&](const Crossed& wall) {
        return orientation(at(wall.left), at(wall.right), at(vertex)) > 0;
    });
    auto last = first;
    while (last != crossed_.end() && last->right == vertex) ++last;
    const bool insideBelow = first != crossed_.begin() && std::prev(first)->insideAbove;
    int below = none, above = none; // the point in the chains of the intervals below and above it
    if (insideBelow) below = join(std::prev(first)->newest, vertex);
    if (first != last) {
        if (insideBelow) closeUpper(below);
        for (auto wall = first; wall != last; ++wall) {
            if (!wall->insideAbove) continue;
            above = join(wall->newest, vertex);
            closeLower(above);
            if (wall + 1 == last) break;
            closeUpper(above);
            dropNode(above);
            above = none;
        }
    }
    collectStarts(vertex);
    if (starts_.empty()) {
        if (above != none) { // two intervals become one
            expects(below != none, "walls have the strip on one side");
            moveLink(above, below);
            chain(below).next = chain(above).next;
            if (chain(below).next != none) chain(chain(below).next).previous = below;
            dropNode(above);
        }
        if (below != none) std::prev(first)->newest = below;
        crossed_.erase(first, last);
        return;
    }
    if (first == last && insideBelow) above = splitAt(below);
    if (insideBelow) std::prev(first)->newest = below;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
        if (!starts_[i].insideAbove) continue;
        starts_[i].newest = i + 1 < starts_.size() ? newNode(vertex) : above;
        expects(starts_[i].newest != none, "walls have the strip on one side");
    }
    const auto reused = std::min(last - first, static_cast<std::ptrdiff_t>(starts_.size()));
    std::copy_n(starts_.begin(), reused, first);
    if (first + reused != last) crossed_.erase(first + reused, last);
    else crossed_.insert(first + reused, starts_.begin() + reused, starts_.end());
}

int StripSweep::newNode(int vertex) {
    if (unusedNodes_.empty()) {
        nodes_.push_back({vertex, none, none, wallOwner});
        return static_cast<int>(nodes_.size()) - 1;
    }
    const int node = unusedNodes_.back();
    unusedNodes_.pop_back();
    chain(node) = {vertex, none, none, wallOwner};
    return node;
}

void StripSweep::dropNode(int node) {
    unusedNodes_.push_back(node);
}

void StripSweep::moveLink(int from, int to) {
    const int owner = std::exchange(chain(from).owner, wallOwner);
    chain(to).owner = owner;
    if (isAwaiting(owner)) chain(partnerOf(owner)).owner = awaiting(to);
}

/// The side lies to the right of the link that leaves a node.
void StripSweep::glue(int side, int node) {
    const int owner = chain(node).owner;
    if (isAwaiting(owner)) {
        chain(partnerOf(owner)).owner = side;
    } else if (owner != wallOwner) {
        sides_->twin[index(side)] = owner;
        sides_->twin[index(owner)] = side;
    }
}

int StripSweep::addTriangle(int a, int b, int c) {
    const int side = static_cast<int>(sides_->start.size());
    sides_->start.insert(sides_->start.end(), {a, b, c});
    sides_->twin.insert(sides_->twin.end(), {none, none, none});
    return side;
}

/// Joins a point to the newest of a chain, then to all it sees on both sides of that. Returns its node.
int StripSweep::join(int newest, int vertex) {
    const GridPoint place = at(vertex);
    const int node = newNode(vertex), upper = newNode(chain(newest).vertex);
    moveLink(newest, upper);
    chain(upper).next = chain(newest).next;
    if (chain(upper).next != none) chain(chain(upper).next).previous = upper;
    chain(upper).previous = chain(newest).next = node;
    chain(node).previous = newest;
    chain(node).next = upper;
    chain(newest).owner = awaiting(node);
    chain(node).owner = awaiting(newest);
    for (int here = newest, before = chain(here).previous; before != none;
         here = before, before = chain(here).previous) {
        if (orientation(placeOf(before), place, placeOf(here)) <= 0) break;
        const int side = addTriangle(chain(before).vertex, vertex, chain(here).vertex);
        glue(side + 1, here);
        glue(side + 2, before);
        chain(before).owner = side;
        chain(before).next = node;
        chain(node).previous = before;
        dropNode(here);
    }
    for (int here = upper, after = chain(here).next; after != none; here = after, after = chain(here).next) {
        if (orientation(placeOf(here), place, placeOf(after)) <= 0) break;
        const int side = addTriangle(chain(here).vertex, vertex, chain(after).vertex);
        glue(side, node);
        glue(side + 2, here);
        chain(node).owner = side + 1;
        chain(node).next = after;
        chain(after).previous = node;
        dropNode(here);
    }
    return node;
}

/// The link is a wall.
void StripSweep::endLink(int node) {
    const int owner = std::exchange(chain(node).owner, wallOwner);
    if (isAwaiting(owner)) chain(partnerOf(owner)).owner = wallOwner;
}

/// The point ends the lower wall of its chain, all of which below it is triangulated.
void StripSweep::closeLower(int node) {
    const int lowest = chain(node).previous;
    expects(lowest != none && chain(lowest).previous == none, "a chain's lower wall is reached");
    endLink(lowest);
    dropNode(lowest);
    chain(node).previous = none;
}

void StripSweep::closeUpper(int node) {
    const int highest = chain(node).next;
    expects(highest != none && chain(highest).next == none, "a chain's upper wall is reached");
    endLink(node);
    dropNode(highest);
    chain(node).next = none;
}

/// Divides a chain at a node; returns the node that the upper one begins with.
int StripSweep::splitAt(int node) {
    const int upper = newNode(chain(node).vertex);
    moveLink(node, upper);
    chain(upper).next = chain(node).next;
    if (chain(upper).next != none) chain(chain(upper).next).previous = upper;
    chain(node).next = none;
    return upper;
}

} // namespace toile::meshing
