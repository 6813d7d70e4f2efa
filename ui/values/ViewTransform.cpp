// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/ViewTransform.h"

#include <algorithm>

namespace toile::ui {
namespace {

constexpr double smallestScale = 10, largestScale = 1e6; // [pixel/m]

} // namespace

QPointF ViewTransform::toScreen(Vec2 point) const {
    return {size.width() / 2 + (point.x - centre.x) * scale, size.height() / 2 - (point.y - centre.y) * scale};
}

Vec2 ViewTransform::toPattern(QPointF pixel) const {
    return {centre.x + (pixel.x() - size.width() / 2) / scale, centre.y - (pixel.y() - size.height() / 2) / scale};
}

QTransform ViewTransform::matrix() const {
    const QPointF origin = toScreen({0, 0});
    return {scale, 0, 0, -scale, origin.x(), origin.y()};
}

ViewTransform panned(const ViewTransform& view, QPointF pixels) {
    ViewTransform result = view;
    result.centre += {-pixels.x() / view.scale, pixels.y() / view.scale};
    return result;
}

ViewTransform zoomed(const ViewTransform& view, double factor, QPointF pixel) {
    ViewTransform result = view;
    result.scale = std::clamp(view.scale * factor, smallestScale, largestScale);
    result.centre += view.toPattern(pixel) - result.toPattern(pixel);
    return result;
}

ViewTransform fitted(const ViewTransform& view, const geometry::Box2& box, double margin) {
    ViewTransform result = view;
    result.centre = lerp(box.low, box.high, 0.5);
    const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    if (width <= 0 && height <= 0) {
        result.scale = std::clamp(view.size.height(), smallestScale, largestScale);
        return result;
    }
    const double roomX = std::max(view.size.width() - 2 * margin, 10.0);
    const double roomY = std::max(view.size.height() - 2 * margin, 10.0);
    const double fit = std::min(roomX / std::max(width, 1e-4), roomY / std::max(height, 1e-4));
    result.scale = std::clamp(fit, smallestScale, largestScale);
    return result;
}

} // namespace toile::ui
