// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Contracts.h"
#include "core/meshing/GridPoint.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

/// A general constrained Delaunay triangulation, point by point in a box round everything: slow and obvious, the
/// referee of the strip's own.
namespace toile::meshing::referee {

/// An edge that the triangulation must contain, from → to.
struct Constraint {
    int from = 0, to = 0;
    bool fillLeft = false; ///< the wanted region lies to its left
};

constexpr int none = -1;
constexpr int next(int i) {
    return i == 2 ? 0 : i + 1;
}
constexpr int previous(int i) {
    return i == 0 ? 2 : i - 1;
}

/// Corner i lies opposite side i; `neighbour[i]` is the triangle beyond it, `fixed[i]` = the side is a
/// constraint.
struct Face {
    std::array<int, 3> corner{none, none, none};
    std::array<int, 3> neighbour{none, none, none};
    std::array<bool, 3> fixed{};
};

struct Side {
    int face = none, index = 0;
};

class Triangulation {
public:
    explicit Triangulation(std::span<const GridPoint> points);
    void insertAll();
    void insertConstraint(int from, int to);
    [[nodiscard]] std::vector<std::array<int, 3>> filled(std::span<const Constraint> constraints) const;

private:
    [[nodiscard]] GridPoint at(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
    [[nodiscard]] Face& face(int f) { return faces_[static_cast<std::size_t>(f)]; }
    [[nodiscard]] const Face& face(int f) const { return faces_[static_cast<std::size_t>(f)]; }
    int addFace(int a, int b, int c);
    void link(int f, int i, int g, bool fixed);
    void insert(int vertex);
    void splitFace(int f, int vertex);
    void splitSide(int f, int i, int vertex);
    void legalise(int vertex);
    void flip(int f, int i);
    [[nodiscard]] int indexOf(const Face& triangle, int vertex) const;
    [[nodiscard]] Side sideBetween(int from, int to) const;
    [[nodiscard]] int mirrorIndex(int f, int i) const;
    [[nodiscard]] bool locallyDelaunay(int f, int i) const;
    [[nodiscard]] bool flippable(int f, int i) const;
    [[nodiscard]] int firstVertexAlong(int from, int to, std::deque<std::pair<int, int>>& crossed) const;
    void flipAway(int from, int to, std::deque<std::pair<int, int>>& crossed);
    void fix(int from, int to);

    std::vector<GridPoint> points_; ///< the caller's, then the four corners of a box round everything
    int callersPoints_ = 0;
    std::vector<Face> faces_;
    std::vector<int> incident_; ///< a face at each vertex
    std::vector<Side> pending_;
    int last_ = 0;
};

inline Triangulation::Triangulation(std::span<const GridPoint> points) : points_(points.begin(), points.end()) {
    callersPoints_ = static_cast<int>(points.size());
    constexpr std::int32_t far = gridLimit - 1;
    for (const GridPoint corner : {GridPoint{-far, -far}, {far, -far}, {far, far}, {-far, far}})
        points_.push_back(corner);
    incident_.assign(points_.size(), none);
    faces_.reserve(2 * points_.size());
    const int b = callersPoints_;
    const int lower = addFace(b, b + 1, b + 2), upper = addFace(b, b + 2, b + 3);
    link(lower, 1, upper, false);
}

inline int Triangulation::addFace(int a, int b, int c) {
    const int f = static_cast<int>(faces_.size());
    faces_.push_back({{a, b, c}, {none, none, none}, {}});
    for (const int v : {a, b, c}) incident_[static_cast<std::size_t>(v)] = f;
    return f;
}

/// Joins side i of face f with face g, which must hold the same two corners.
inline void Triangulation::link(int f, int i, int g, bool fixed) {
    face(f).neighbour[static_cast<std::size_t>(i)] = g;
    face(f).fixed[static_cast<std::size_t>(i)] = fixed;
    if (g == none) return;
    const int from = face(f).corner[static_cast<std::size_t>(next(i))];
    const int j = next(indexOf(face(g), from)); // in g the side runs to → from, so `to` precedes `from`
    face(g).neighbour[static_cast<std::size_t>(j)] = f;
    face(g).fixed[static_cast<std::size_t>(j)] = fixed;
}

inline int Triangulation::indexOf(const Face& triangle, int vertex) const {
    for (int i = 0; i < 3; ++i)
        if (triangle.corner[static_cast<std::size_t>(i)] == vertex) return i;
    expects(false, "a vertex belongs to its face");
    return 0;
}

inline void Triangulation::insertAll() {
    std::vector<int> order(static_cast<std::size_t>(callersPoints_));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return mortonCode(at(a)) < mortonCode(at(b)); });
    for (const int vertex : order) insert(vertex);
}

inline void Triangulation::insert(int vertex) {
    const GridPoint p = at(vertex);
    int f = last_, from = none;
    for (;;) { // walk towards the point; ends because the triangulation is Delaunay
        int onSide = none, beyond = none;
        for (int i = 0; i < 3; ++i) {
            const auto s = static_cast<std::size_t>(i);
            const std::int64_t side = orientation(at(face(f).corner[static_cast<std::size_t>(next(i))]),
                                                  at(face(f).corner[static_cast<std::size_t>(previous(i))]), p);
            if (side == 0) onSide = i;
            if (side < 0 && face(f).neighbour[s] != from) beyond = face(f).neighbour[s];
        }
        if (beyond != none) {
            from = f;
            f = beyond;
            continue;
        }
        if (onSide != none) splitSide(f, onSide, vertex);
        else splitFace(f, vertex);
        legalise(vertex);
        last_ = incident_[static_cast<std::size_t>(vertex)];
        return;
    }
}

inline void Triangulation::splitFace(int f, int vertex) {
    const Face old = face(f);
    const auto [a, b, c] = old.corner;
    const int g = addFace(b, c, vertex), h = addFace(c, a, vertex);
    face(f) = {{a, b, vertex}, {none, none, none}, {}};
    incident_[static_cast<std::size_t>(a)] = incident_[static_cast<std::size_t>(b)] = f;
    incident_[static_cast<std::size_t>(vertex)] = f;
    link(f, 2, old.neighbour[2], old.fixed[2]);
    link(g, 2, old.neighbour[0], old.fixed[0]);
    link(h, 2, old.neighbour[1], old.fixed[1]);
    link(f, 0, g, false);
    link(g, 0, h, false);
    link(h, 0, f, false);
    for (const int t : {f, g, h}) pending_.push_back({t, 2});
}

/// The vertex lies on side i of face f: both faces at it are halved.
inline void Triangulation::splitSide(int f, int i, int vertex) {
    const Face old = face(f);
    const int g = old.neighbour[static_cast<std::size_t>(i)];
    const int j = mirrorIndex(f, i);
    const Face oldOther = face(g);
    const auto pick = [](const Face& t, int k) { return t.corner[static_cast<std::size_t>(k)]; };
    const int a = pick(old, i), b = pick(old, next(i)), c = pick(old, previous(i)), d = pick(oldOther, j);
    const bool fixed = old.fixed[static_cast<std::size_t>(i)];
    const auto outer = [](const Face& t, int k) {
        return std::pair(t.neighbour[static_cast<std::size_t>(k)], bool{t.fixed[static_cast<std::size_t>(k)]});
    };
    const auto ab = outer(old, previous(i)), ca = outer(old, next(i));
    const auto bd = outer(oldOther, next(j)), dc = outer(oldOther, previous(j));
    face(f) = {{a, b, vertex}, {none, none, none}, {}};
    face(g) = {{d, c, vertex}, {none, none, none}, {}};
    const int h = addFace(c, a, vertex), k = addFace(b, d, vertex);
    for (const int v : {a, b, vertex}) incident_[static_cast<std::size_t>(v)] = f;
    for (const int v : {c, d}) incident_[static_cast<std::size_t>(v)] = g;
    link(f, 2, ab.first, ab.second);
    link(h, 2, ca.first, ca.second);
    link(g, 2, dc.first, dc.second);
    link(k, 2, bd.first, bd.second);
    link(f, 0, k, fixed); // b – vertex
    link(h, 1, g, fixed); // vertex – c
    link(f, 1, h, false); // vertex – a
    link(k, 0, g, false); // d – vertex
    for (const int t : {f, g, h, k}) pending_.push_back({t, 2});
}

inline void Triangulation::legalise(int vertex) {
    while (!pending_.empty()) {
        const Side side = pending_.back();
        pending_.pop_back();
        const int i = indexOf(face(side.face), vertex);
        if (locallyDelaunay(side.face, i)) continue;
        const int other = face(side.face).neighbour[static_cast<std::size_t>(i)];
        flip(side.face, i);
        pending_.push_back({side.face, 0});
        pending_.push_back({other, 0});
    }
}

inline int Triangulation::mirrorIndex(int f, int i) const {
    const Face& t = face(f);
    const Face& other = face(t.neighbour[static_cast<std::size_t>(i)]);
    return next(indexOf(other, t.corner[static_cast<std::size_t>(next(i))]));
}

/// Of four points on one circle that nearest to the middle has the diagonal.
inline bool Triangulation::locallyDelaunay(int f, int i) const {
    const Face& t = face(f);
    const auto s = static_cast<std::size_t>(i);
    if (t.neighbour[s] == none || t.fixed[s]) return true;
    const int apex = face(t.neighbour[s]).corner[static_cast<std::size_t>(mirrorIndex(f, i))];
    const int side = circleSide(at(t.corner[0]), at(t.corner[1]), at(t.corner[2]), at(apex));
    if (side != 0) return side < 0;
    const auto corner = [&](int k) { return at(t.corner[static_cast<std::size_t>(k)]); };
    return nearerMiddle(std::min(corner(next(i)), corner(previous(i)), nearerMiddle),
                        std::min(corner(i), at(apex), nearerMiddle));
}

/// Turns the diagonal of the two faces at side i of f. Afterwards corner 0 of both is what was corner i of f.
inline void Triangulation::flip(int f, int i) {
    const Face t = face(f);
    const int g = t.neighbour[static_cast<std::size_t>(i)];
    const int j = mirrorIndex(f, i);
    const Face u = face(g);
    const auto corner = [](const Face& x, int k) { return x.corner[static_cast<std::size_t>(k)]; };
    const int a = corner(t, i), b = corner(t, next(i)), c = corner(t, previous(i)), d = corner(u, j);
    const auto neighbour = [](const Face& x, int k) { return x.neighbour[static_cast<std::size_t>(k)]; };
    const auto fixed = [](const Face& x, int k) { return bool{x.fixed[static_cast<std::size_t>(k)]}; };
    face(f) = {{a, b, d}, {none, none, none}, {}};
    face(g) = {{a, d, c}, {none, none, none}, {}};
    link(f, 2, neighbour(t, previous(i)), fixed(t, previous(i)));
    link(g, 1, neighbour(t, next(i)), fixed(t, next(i)));
    link(f, 0, neighbour(u, next(j)), fixed(u, next(j)));
    link(g, 0, neighbour(u, previous(j)), fixed(u, previous(j)));
    link(f, 1, g, false);
    for (const int v : {a, b, d}) incident_[static_cast<std::size_t>(v)] = f;
    incident_[static_cast<std::size_t>(c)] = g;
}

/// The side of a face that runs from → to counter-clockwise; face = none if the edge does not exist.
inline Side Triangulation::sideBetween(int from, int to) const {
    const int first = incident_[static_cast<std::size_t>(from)];
    const auto sideOf = [&](int f, int k) {
        return face(f).corner[static_cast<std::size_t>(next(k))] == to ? Side{f, previous(k)} : Side{};
    };
    for (int f = first; f != none;) { // counter-clockwise round `from`
        const int k = indexOf(face(f), from);
        if (const Side side = sideOf(f, k); side.face != none) return side;
        f = face(f).neighbour[static_cast<std::size_t>(next(k))];
        if (f == first) return {};
    }
    for (int f = first; f != none;) { // the box's corners have no full ring: the other way
        const int k = indexOf(face(f), from);
        if (const Side side = sideOf(f, k); side.face != none) return side;
        f = face(f).neighbour[static_cast<std::size_t>(previous(k))];
    }
    return {};
}

inline void Triangulation::insertConstraint(int from, int to) {
    while (from != to) {
        if (sideBetween(from, to).face != none) {
            fix(from, to);
            return;
        }
        std::deque<std::pair<int, int>> crossed;
        const int stop = firstVertexAlong(from, to, crossed);
        flipAway(from, stop, crossed);
        fix(from, stop);
        from = stop;
    }
}

/// Walks from → to; collects the edges crossed up to the first vertex on the way, which it returns.
inline int Triangulation::firstVertexAlong(int from, int to, std::deque<std::pair<int, int>>& crossed) const {
    int f = incident_[static_cast<std::size_t>(from)];
    int right = none, left = none;
    for (;;) { // counter-clockwise round `from` to the face that the way enters
        const int k = indexOf(face(f), from);
        right = face(f).corner[static_cast<std::size_t>(next(k))];
        left = face(f).corner[static_cast<std::size_t>(previous(k))];
        const std::int64_t sideRight = orientation(at(from), at(to), at(right));
        const std::int64_t sideLeft = orientation(at(from), at(to), at(left));
        const auto ahead = [&](int v) {
            return (std::int64_t{at(v).x} - at(from).x) * (std::int64_t{at(to).x} - at(from).x) +
                       (std::int64_t{at(v).y} - at(from).y) * (std::int64_t{at(to).y} - at(from).y) >
                   0;
        };
        if (sideRight == 0 && ahead(right)) return right;
        if (sideRight < 0 && sideLeft > 0) break;
        f = face(f).neighbour[static_cast<std::size_t>(next(k))];
    }
    while (true) {
        crossed.emplace_back(right, left);
        const Side side = sideBetween(left, right); // the face beyond runs through the edge the other way
        const int apex = face(side.face).corner[static_cast<std::size_t>(side.index)];
        const std::int64_t where = orientation(at(from), at(to), at(apex));
        if (apex == to || where == 0) return apex;
        (where < 0 ? right : left) = apex;
    }
}

inline bool Triangulation::flippable(int f, int i) const {
    const Face& t = face(f);
    const Face& u = face(t.neighbour[static_cast<std::size_t>(i)]);
    const GridPoint a = at(t.corner[static_cast<std::size_t>(i)]);
    const GridPoint b = at(t.corner[static_cast<std::size_t>(next(i))]);
    const GridPoint c = at(t.corner[static_cast<std::size_t>(previous(i))]);
    const GridPoint d = at(u.corner[static_cast<std::size_t>(mirrorIndex(f, i))]);
    return orientation(a, b, d) > 0 && orientation(a, d, c) > 0;
}

/// Flips edges until none crosses from → to (Sloan 1993), then restores the Delaunay property round it.
inline void Triangulation::flipAway(int from, int to, std::deque<std::pair<int, int>>& crossed) {
    std::vector<std::pair<int, int>> created;
    while (!crossed.empty()) {
        const auto [right, left] = crossed.front();
        crossed.pop_front();
        const Side side = sideBetween(left, right);
        expects(!face(side.face).fixed[static_cast<std::size_t>(side.index)], "constraints do not cross");
        if (!flippable(side.face, side.index)) {
            crossed.emplace_back(right, left);
            continue;
        }
        const int near = face(side.face).corner[static_cast<std::size_t>(side.index)];
        const int other = face(side.face).neighbour[static_cast<std::size_t>(side.index)];
        const int far = face(other).corner[static_cast<std::size_t>(mirrorIndex(side.face, side.index))];
        flip(side.face, side.index);
        const std::int64_t nearSide = orientation(at(from), at(to), at(near));
        const std::int64_t farSide = orientation(at(from), at(to), at(far));
        if (nearSide < 0 && farSide > 0) crossed.emplace_back(near, far);
        else if (nearSide > 0 && farSide < 0) crossed.emplace_back(far, near);
        else created.emplace_back(near, far);
    }
    fix(from, to);
    for (bool changed = true; changed;) {
        changed = false;
        for (auto& edge : created) {
            const Side side = sideBetween(edge.first, edge.second);
            if (side.face == none || locallyDelaunay(side.face, side.index)) continue;
            const Face t = face(side.face);
            const int apex = t.corner[static_cast<std::size_t>(side.index)];
            const int other = t.neighbour[static_cast<std::size_t>(side.index)];
            const int far = face(other).corner[static_cast<std::size_t>(mirrorIndex(side.face, side.index))];
            flip(side.face, side.index);
            edge = {apex, far};
            changed = true;
        }
    }
}

inline void Triangulation::fix(int from, int to) {
    const Side side = sideBetween(from, to);
    expects(side.face != none, "a constraint is an edge");
    link(side.face, side.index, face(side.face).neighbour[static_cast<std::size_t>(side.index)], true);
}

inline std::vector<std::array<int, 3>> Triangulation::filled(std::span<const Constraint> constraints) const {
    std::vector<char> wanted(faces_.size(), 0);
    std::vector<int> open;
    const auto visit = [&](int f) {
        if (f == none || wanted[static_cast<std::size_t>(f)]) return;
        wanted[static_cast<std::size_t>(f)] = 1;
        open.push_back(f);
    };
    for (const Constraint& constraint : constraints)
        if (constraint.fillLeft) visit(sideBetween(constraint.from, constraint.to).face);
    while (!open.empty()) {
        const Face& t = face(open.back());
        open.pop_back();
        for (std::size_t i = 0; i < 3; ++i)
            if (!t.fixed[i]) visit(t.neighbour[i]);
    }
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t f = 0; f < faces_.size(); ++f)
        if (wanted[f]) triangles.push_back(faces_[f].corner);
    return triangles;
}

/// The constrained Delaunay triangulation of the regions to the left of those constraints that ask for it, up
/// to the next constraint. Points are distinct; constraints meet at common end points only. Triangles are
/// counter-clockwise. All decisions are exact, and the result depends on the set of points alone, not on its
/// order.
inline std::vector<std::array<int, 3>> constrainedDelaunay(std::span<const GridPoint> points,
                                                           std::span<const Constraint> constraints) {
    if (points.empty()) return {};
    Triangulation triangulation(points);
    triangulation.insertAll();
    std::vector<Constraint> ordered(constraints.begin(), constraints.end());
    std::sort(ordered.begin(), ordered.end(), [&](const Constraint& a, const Constraint& b) {
        const auto key = [&](const Constraint& c) {
            const GridPoint p = points[static_cast<std::size_t>(c.from)], q = points[static_cast<std::size_t>(c.to)];
            return std::pair(std::min(p, q), std::max(p, q));
        };
        return key(a) < key(b);
    });
    for (const Constraint& constraint : ordered) triangulation.insertConstraint(constraint.from, constraint.to);
    return triangulation.filled(constraints);
}

} // namespace toile::meshing::referee
