// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PieceFrame.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

/// Grid lines lie this part of a unit beside round coordinates, so that rounding never sits on the fence and
/// a piece and its mirror image round alike.
constexpr double phase = 0.3719;

/// 1/4096 mm, or a power of two of it: finer for pieces under a quarter of a metre, coarser above a hundred.
double unitFor(double halfExtent) {
    double unit = 1e-3 / 4096;
    while (halfExtent > unit * (gridLimit / 2)) unit *= 2;
    while (halfExtent < unit * (1 << 19) && unit > 1e-12) unit /= 2;
    return unit;
}

} // namespace

GridPoint PieceFrame::gridOf(Vec2 inFrame) const {
    const auto snap = [&](double value) { // what std::lround gives, without a call of the library
        const double scaled = value / unit + phase;
        return static_cast<std::int32_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
    };
    return {snap(inFrame.x), snap(inFrame.y)};
}

Vec2 PieceFrame::placeOf(GridPoint point) const {
    return Vec2{point.x - phase, point.y - phase} * unit;
}

geometry::Box2 boxInFrame(const PieceFrame& frame, std::span<const Vec2> points) {
    if (points.empty()) return {};
    const Vec2 first = frame.frameOf(points.front());
    geometry::Box2 box{first, first};
    for (const Vec2 point : points) {
        const Vec2 p = frame.frameOf(point);
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

PieceFrame frameFor(double grain, bool mirrored, std::span<const Vec2> points, double margin) {
    PieceFrame frame{grain, std::cos(grain), std::sin(grain), mirrored ? -1.0 : 1.0, {}, 1};
    const geometry::Box2 box = boxInFrame(frame, points);
    frame.centre = (box.low + box.high) * 0.5;
    frame.unit = unitFor(0.5 * std::max(box.high.x - box.low.x, box.high.y - box.low.y) + margin);
    return frame;
}

} // namespace toile::meshing
