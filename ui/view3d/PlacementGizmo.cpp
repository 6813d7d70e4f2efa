// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/PlacementGizmo.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>

namespace toile::ui {

using picture::Camera;
using picture::Colour;
using picture::Ray;
using picture::Stroke;

namespace {

constexpr double arrowLength = 96, arrowHead = 16, ringRadius = 70, handleTouch = 8; // [px]
constexpr double moveStep = 0.01;                                                    // [m]
constexpr double turnStep = 5 * std::numbers::pi / 180;                              // [rad]
constexpr double alongTheView = 0.97; // arrows nearer to the line of sight than this cosine are not offered
constexpr double edgeOn = 0.2;        // rings whose axis is farther from it than this cosine are seen edge-on
constexpr int ringCorners = 72;
constexpr std::array handles{GizmoHandle::moveX, GizmoHandle::moveY, GizmoHandle::moveZ,
                             GizmoHandle::turnX, GizmoHandle::turnY, GizmoHandle::turnZ};
constexpr std::array drawingOrder{GizmoHandle::turnX, GizmoHandle::turnY, GizmoHandle::turnZ,
                                  GizmoHandle::moveX, GizmoHandle::moveY, GizmoHandle::moveZ}; // arrows on top

bool turns(GizmoHandle handle) {
    return handle >= GizmoHandle::turnX;
}

int axisIndex(GizmoHandle handle) {
    return (static_cast<int>(handle) - static_cast<int>(GizmoHandle::moveX)) % 3;
}

Vec3 axisOf(GizmoHandle handle) {
    Vec3 axis;
    axis[axisIndex(handle)] = 1;
    return axis;
}

/// Two unit vectors across an axis, counter-clockwise seen against it.
std::array<Vec3, 2> across(GizmoHandle handle) {
    Vec3 first, second;
    first[(axisIndex(handle) + 1) % 3] = 1;
    second[(axisIndex(handle) + 2) % 3] = 1;
    return {first, second};
}

Vec3 ringPoint(GizmoHandle handle, const Vec3& centre, double radius, double angle) {
    const auto [first, second] = across(handle);
    return centre + first * (radius * std::cos(angle)) + second * (radius * std::sin(angle));
}

/// Parameter of the point of a line nearest to a ray; the two must not be parallel.
double nearestOnLine(const Vec3& point, const Vec3& unit, const Ray& ray) {
    const double slant = dot(unit, ray.direction);
    const Vec3 between = ray.origin - point;
    return (dot(between, unit) - slant * dot(between, ray.direction)) / (1 - slant * slant);
}

Vec3 sight(const GizmoView& view, const Vec3& point) {
    return normalized(point - eyeOf(view.camera));
}

bool isOffered(GizmoHandle handle, const GizmoView& view, const Vec3& pivot) {
    return turns(handle) || std::abs(dot(axisOf(handle), sight(view, pivot))) < alongTheView;
}

/// The points of a handle's line: two of an arrow, a closed circle of a ring.
std::vector<Vec3> outlineOf(GizmoHandle handle, const GizmoView& view, const Vec3& pivot) {
    const double pixel = pixelSize(view.camera, view.viewport, pivot);
    if (!turns(handle))
        return {pivot + axisOf(handle) * (0.18 * arrowLength * pixel), pivot + axisOf(handle) * (arrowLength * pixel)};
    std::vector<Vec3> ring;
    for (int i = 0; i <= ringCorners; ++i)
        ring.push_back(ringPoint(handle, pivot, ringRadius * pixel, 2 * std::numbers::pi * i / ringCorners));
    return ring;
}

struct Touched {
    double pixels = 0; ///< from the pointer
    double depth = 0;  ///< from the eye [m]
};

/// The place of a line in space that is seen nearest to a pixel position.
std::optional<Touched> nearestOn(const std::vector<Vec3>& line, const GizmoView& view, Vec2 pixel) {
    std::optional<Touched> nearest;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto a = worldToScreen(view.camera, view.viewport, line[i - 1]);
        const auto b = worldToScreen(view.camera, view.viewport, line[i]);
        if (!a || !b) continue;
        const Vec2 along = b->pixel - a->pixel;
        const double squared = squaredLength(along);
        const double s = squared > 0 ? std::clamp(dot(pixel - a->pixel, along) / squared, 0.0, 1.0) : 0;
        const Touched here{distance(a->pixel + along * s, pixel), a->depth + (b->depth - a->depth) * s};
        const bool closer = !nearest || here.pixels < nearest->pixels - 1 ||
                            (here.pixels < nearest->pixels + 1 && here.depth < nearest->depth);
        if (closer) nearest = here;
    }
    return nearest;
}

double inSteps(double amount, double step) {
    return std::round(amount / step) * step;
}

Colour colourOf(GizmoHandle handle, bool lit) {
    constexpr std::array<Colour, 3> axes{{{0.86f, 0.24f, 0.22f}, {0.30f, 0.66f, 0.24f}, {0.20f, 0.42f, 0.88f}}};
    return lit ? Colour{1.0f, 0.78f, 0.16f} : axes[static_cast<std::size_t>(axisIndex(handle))];
}

/// Shaft and the four edges of an arrow's head.
void addArrow(std::vector<Stroke>& strokes, GizmoHandle handle, const GizmoView& view, const Vec3& pivot, Colour colour,
              double width) {
    const std::vector<Vec3> shaft = outlineOf(handle, view, pivot);
    const double head = arrowHead * pixelSize(view.camera, view.viewport, pivot);
    const auto [first, second] = across(handle);
    strokes.push_back({shaft, colour, width});
    for (const Vec3& side : {first, -first, second, -second})
        strokes.push_back({{shaft[1] - axisOf(handle) * head + side * (0.38 * head), shaft[1]}, colour, width + 1});
}

/// The half of the ring behind the pivot is fainter.
void addRing(std::vector<Stroke>& strokes, GizmoHandle handle, const GizmoView& view, const Vec3& pivot, Colour colour,
             double width) {
    const std::vector<Vec3> ring = outlineOf(handle, view, pivot);
    const Vec3 away = sight(view, pivot);
    const bool faceOn = std::abs(dot(axisOf(handle), away)) > 0.98;
    const double pixel = pixelSize(view.camera, view.viewport, pivot);
    Stroke run{{ring.front()}, colour, width};
    const auto isFront = [&](std::size_t i) {
        return faceOn || dot((ring[i - 1] + ring[i]) * 0.5 - pivot, away) < pixel;
    };
    for (std::size_t i = 1; i < ring.size(); ++i) {
        run.points.push_back(ring[i]);
        const bool front = isFront(i);
        if (i + 1 < ring.size() && isFront(i + 1) == front) continue;
        run.colour.a = front ? 1.0f : 0.25f;
        strokes.push_back(run);
        run.points = {ring[i]};
    }
}

} // namespace

Transform turnedAbout(const Vec3& point, const Vec3& unitAxis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const Vec3& v) { // Rodrigues
        return v * c + cross(unitAxis, v) * s + unitAxis * (dot(unitAxis, v) * (1 - c));
    };
    return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), point - turned(point)};
}

GizmoHandle PlacementGizmo::handleAt(const GizmoView& view, Vec2 pixel) const {
    const auto nearest = [&](bool ring) {
        GizmoHandle best = GizmoHandle::none;
        Touched bestTouch{handleTouch, 0};
        for (const GizmoHandle handle : handles) {
            if (turns(handle) != ring || !isOffered(handle, view, pivot_)) continue;
            const auto here = nearestOn(outlineOf(handle, view, pivot_), view, pixel);
            if (!here || here->pixels > handleTouch) continue;
            const bool better = best == GizmoHandle::none || here->pixels < bestTouch.pixels - 2 ||
                                (here->pixels < bestTouch.pixels + 2 && here->depth < bestTouch.depth);
            if (!better) continue;
            best = handle;
            bestTouch = *here;
        }
        return std::pair(best, bestTouch.pixels);
    };
    // A ring seen edge-on covers an arrow's shaft: there the arrow is meant.
    const auto [arrow, fromArrow] = nearest(false);
    const auto [ring, fromRing] = nearest(true);
    const bool ringIsMeant = ring != GizmoHandle::none && (arrow == GizmoHandle::none || fromRing < fromArrow - 2);
    return ringIsMeant ? ring : arrow;
}

bool PlacementGizmo::hover(const GizmoView& view, Vec2 pixel) {
    const GizmoHandle now = handleAt(view, pixel);
    return std::exchange(hovered_, now) != now;
}

bool PlacementGizmo::press(const GizmoView& view, Vec2 pixel) {
    held_ = hovered_ = handleAt(view, pixel);
    if (!isDragging()) return false;
    before_ = placement_;
    pivotBefore_ = pivot_;
    grabbedPixel_ = pixel;
    grabbedAt_ = lastTurn_ = 0;
    turnPerPixel_ = {};
    if (turns(held_) && std::abs(dot(axisOf(held_), sight(view, pivot_))) < edgeOn) {
        // The front of an edge-on ring runs across the line of sight: turn as much as that point moves along
        // its line.
        const double pixelLength = pixelSize(view.camera, view.viewport, pivot_), radius = ringRadius * pixelLength;
        const Vec3 front = pivot_ - sight(view, pivot_) * radius;
        const Vec3 forward = cross(axisOf(held_), front - pivot_) * 0.01;
        const auto from = worldToScreen(view.camera, view.viewport, front);
        const auto to = worldToScreen(view.camera, view.viewport, front + forward);
        if (from && to && from->pixel != to->pixel) {
            const Vec2 perTurn = (to->pixel - from->pixel) / 0.01; // [px/rad]
            turnPerPixel_ = perTurn / squaredLength(perTurn);
        }
    }
    grabbedAt_ = amountAt(view, pixel);
    return true;
}

double PlacementGizmo::amountAt(const GizmoView& view, Vec2 pixel) const {
    const Ray ray = pickRay(view.camera, view.viewport, pixel);
    const Vec3 axis = axisOf(held_);
    if (!turns(held_)) return nearestOnLine(pivotBefore_, axis, ray);
    if (turnPerPixel_ != Vec2{}) return dot(pixel - grabbedPixel_, turnPerPixel_);
    const double towards = dot(ray.direction, axis);
    if (std::abs(towards) < 1e-6) return grabbedAt_ + lastTurn_;
    const Vec3 hit = ray.origin + ray.direction * (dot(pivotBefore_ - ray.origin, axis) / towards) - pivotBefore_;
    const auto [first, second] = across(held_);
    return std::atan2(dot(hit, second), dot(hit, first));
}

const Transform& PlacementGizmo::drag(const GizmoView& view, Vec2 pixel, bool steps) {
    if (!isDragging()) return placement_;
    double amount = amountAt(view, pixel) - grabbedAt_;
    if (!std::isfinite(amount)) return placement_;
    if (turns(held_)) {
        if (turnPerPixel_ == Vec2{}) amount = lastTurn_ + std::remainder(amount - lastTurn_, 2 * std::numbers::pi);
        lastTurn_ = amount;
    }
    apply(steps ? inSteps(amount, turns(held_) ? turnStep : moveStep) : amount);
    return placement_;
}

void PlacementGizmo::apply(double amount) {
    const Vec3 axis = axisOf(held_);
    if (turns(held_)) {
        placement_ = composed(turnedAbout(pivotBefore_, axis, amount), before_);
    } else {
        placement_ = before_;
        placement_.origin += axis * amount;
        pivot_ = pivotBefore_ + axis * amount;
    }
}

void PlacementGizmo::release() {
    held_ = GizmoHandle::none;
}

void PlacementGizmo::cancel() {
    if (!isDragging()) return;
    placement_ = before_;
    pivot_ = pivotBefore_;
    held_ = GizmoHandle::none;
}

std::vector<Stroke> PlacementGizmo::strokes(const GizmoView& view) const {
    std::vector<Stroke> strokes;
    for (const GizmoHandle handle : drawingOrder) {
        if (isDragging() ? handle != held_ : !isOffered(handle, view, pivot_)) continue;
        const bool lit = handle == held_ || handle == hovered_;
        const auto add = turns(handle) ? addRing : addArrow;
        add(strokes, handle, view, pivot_, colourOf(handle, lit), lit ? 3.5 : 2.5);
    }
    return strokes;
}

} // namespace toile::ui
