// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/DrawPiece.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternPieces.h"
#include "ui/tools/DeleteSelection.h"
#include "ui/values/Units.h"
#include "ui/values/Words.h"

#include <cmath>
#include <numbers>

namespace toile::ui {
namespace {

using namespace pattern;

/// The new piece: its origin in the middle of what was drawn, so that it curls and turns about itself.
Result<Pattern> withPiece(const Pattern& pattern, std::vector<Vec2> points, std::span<const EdgeShape> shapes,
                          IdSource& ids) {
    const geometry::Box2 box = geometry::boundsOf(points);
    const Vec2 origin = lerp(box.low, box.high, 0.5);
    for (Vec2& point : points) point -= origin;
    std::vector<EdgeShape> local(shapes.begin(), shapes.end());
    for (EdgeShape& shape : local)
        if (auto* cubic = std::get_if<geometry::CubicShape>(&shape)) {
            cubic->control1 -= origin;
            cubic->control2 -= origin;
        }
    auto outline = contourThrough(points, local, ids);
    if (!outline) return tl::unexpected(outline.error());
    Piece piece;
    piece.id = ids.take<PieceId>();
    if (!pattern.fabrics.empty()) piece.fabric = pattern.fabrics.front()->id;
    piece.name = tr("Piece %1").arg(pattern.pieces.size() + 1).toStdString();
    piece.outline = std::move(*outline);
    piece.tablePosition = origin;
    piece.placement = startingPlace();
    return addPiece(pattern, std::move(piece));
}

} // namespace

Placement startingPlace() {
    Placement place;
    place.transform.origin = {0, 1.1, 0.3};
    return place;
}

Vec2 alignedTo45(Vec2 from, Vec2 point) {
    const Vec2 way = point - from;
    const double step = std::numbers::pi / 4;
    const double angle = std::round(std::atan2(way.y, way.x) / step) * step;
    const Vec2 direction{std::cos(angle), std::sin(angle)};
    return from + direction * dot(way, direction);
}

Effect DrawPiece::press(const Desk& desk, const PointerEvent& event) {
    tolerance_ = event.tolerance;
    if (event.button != Button::left) return {};
    if (closes(event)) return finish(desk);
    points_.push_back({next(event), std::nullopt});
    pointer_ = points_.back().at;
    pulling_ = true;
    return {};
}

Effect DrawPiece::move(const Desk&, const PointerEvent& event) {
    tolerance_ = event.tolerance;
    pointer_ = event.position;
    if (pulling_ && !points_.empty()) {
        const Vec2 way = event.position - points_.back().at;
        if (length(way) > event.tolerance) points_.back().handle = way;
        else points_.back().handle.reset();
    } else {
        pointer_ = next(event);
    }
    return {};
}

Effect DrawPiece::release(const Desk&, const PointerEvent&) {
    pulling_ = false;
    return {};
}

Effect DrawPiece::doubleClick(const Desk& desk, const PointerEvent&) {
    return finish(desk);
}

Effect DrawPiece::key(const Desk& desk, ToolKey key) {
    switch (key) {
    case ToolKey::enter: return finish(desk);
    case ToolKey::backspace:
        if (!points_.empty()) points_.pop_back();
        pulling_ = false;
        return {};
    case ToolKey::escape: cancel(); return {};
    case ToolKey::erase: return points_.empty() ? deleteSelection(desk) : Effect{};
    }
    return {};
}

void DrawPiece::cancel() {
    points_.clear();
    pulling_ = false;
}

Vec2 DrawPiece::next(const PointerEvent& event) const {
    if (event.modifiers.shift && !points_.empty()) return alignedTo45(points_.back().at, event.position);
    return event.position;
}

bool DrawPiece::closes(const PointerEvent& event) const {
    return points_.size() >= 3 && distance(points_.front().at, event.position) <= event.tolerance;
}

geometry::EdgeShape DrawPiece::shapeBetween(const Point& from, const Point& to) {
    if (!from.handle && !to.handle) return geometry::LineShape{};
    const Vec2 third = (to.at - from.at) / 3;
    return geometry::CubicShape{from.at + from.handle.value_or(third), to.at - to.handle.value_or(third)};
}

Effect DrawPiece::finish(const Desk& desk) {
    if (points_.empty()) return {};
    std::vector<Vec2> points;
    std::vector<geometry::EdgeShape> shapes;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points.push_back(points_[i].at);
        shapes.push_back(shapeBetween(points_[i], points_[(i + 1) % points_.size()]));
    }
    Effect effect =
        effectOf(tr("Draw piece"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                     return withPiece(pattern, points, shapes, ids);
                 }));
    if (!effect.edit) return effect; // the outline stays, to be mended
    effect.selection = Selection{effect.edit->after.pattern.pieces.back()->id};
    cancel();
    return effect;
}

Overlay DrawPiece::overlay(const Desk&) const {
    Overlay overlay;
    if (points_.empty()) return overlay;
    std::vector<Vec2> path;
    const auto append = [&](const Point& from, const Point& to) {
        const auto points = geometry::flattened({from.at, to.at, shapeBetween(from, to)}, 0.1e-3);
        path.insert(path.end(), points.begin(), points.end());
    };
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) append(points_[i], points_[i + 1]);
    if (!path.empty()) overlay.lines.push_back({path, Overlay::Role::draft});
    const Point& last = points_.back();
    if (pulling_ && last.handle) {
        overlay.lines.push_back(
            {{last.at - *last.handle, last.at + *last.handle}, Overlay::Role::hover, false, false, 1});
        overlay.marks.push_back({last.at + *last.handle, Overlay::Role::hover});
        overlay.marks.push_back({last.at - *last.handle, Overlay::Role::hover});
    } else if (!pulling_) {
        const bool closing = points_.size() >= 3 && distance(points_.front().at, pointer_) <= tolerance_;
        const Point end{closing ? points_.front().at : pointer_, closing ? points_.front().handle : std::nullopt};
        path.clear();
        append(last, end);
        overlay.lines.push_back({path, Overlay::Role::draft, true});
        overlay.labels.push_back({end.at, closing ? tr("Close") : textOf(Quantity::length, lengthOf(path))});
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
        overlay.marks.push_back({points_[i].at, i == 0 ? Overlay::Role::accent : Overlay::Role::draft, false});
    return overlay;
}

QString DrawPiece::hint() const {
    if (points_.empty()) return tr("Click to set points, drag to pull a curve out of a point.");
    return tr("Click the first point or press Enter to close; Backspace takes the last point back, Esc gives up.");
}

} // namespace toile::ui
