// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Polygon.h"

#include <QPointF>
#include <QSizeF>
#include <QTransform>

namespace toile::ui {

/// Where the plane of the pattern lies on the screen. The pattern's y points up, the screen's down.
struct ViewTransform {
    Vec2 centre;           ///< the point of the pattern in the middle of the view [m]
    double scale = 1000;   ///< [pixel/m]
    QSizeF size{100, 100}; ///< of the view [pixel]

    [[nodiscard]] QPointF toScreen(Vec2 point) const;
    [[nodiscard]] Vec2 toPattern(QPointF pixel) const;
    /// The same map for a painter.
    [[nodiscard]] QTransform matrix() const;
    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;
};

/// What lay under a pixel follows it by `pixels`.
[[nodiscard]] ViewTransform panned(const ViewTransform& view, QPointF pixels);
/// Larger by `factor`; what lies under `pixel` stays there. The scale is kept between 1 pixel per 100 mm and
/// 1000 pixels per mm.
[[nodiscard]] ViewTransform zoomed(const ViewTransform& view, double factor, QPointF pixel);
/// Shows the whole box with a margin [pixel]; an empty box gets a view of about a metre.
[[nodiscard]] ViewTransform fitted(const ViewTransform& view, const geometry::Box2& box, double margin);

} // namespace toile::ui
