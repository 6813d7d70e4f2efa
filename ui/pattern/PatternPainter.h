// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pattern/MeshLines.h"
#include "ui/tools/Overlay.h"
#include "ui/values/FlatPattern.h"
#include "ui/values/Selection.h"
#include "ui/values/ViewTransform.h"

#include <QPainter>

#include <optional>

namespace toile::ui {

/// What of the pattern is drawn.
struct PatternLook {
    bool grid = true, mesh = true, regions = true, seams = true, names = true, cutLines = true;
    bool vertices = false; ///< and Bézier handles: while points are edited
};

/// Everything a picture of the pattern shows.
struct PatternPicture {
    const pattern::Pattern& pattern;
    const FlatPattern& flat;
    const MeshLines& mesh; ///< may be empty, or older than the pattern
    const Selection& selection;
    std::optional<Item> hovered;
    const Overlay& overlay;
    PatternLook look;
};

/// The whole picture, from the paper to the tool's overlay.
void paint(QPainter& painter, const ViewTransform& view, const PatternPicture& picture);

void paintGrid(QPainter& painter, const ViewTransform& view);
void paintRulers(QPainter& painter, const ViewTransform& view);
void paintPieces(QPainter& painter, const ViewTransform& view, const PatternPicture& picture);
/// Dash-dot lines, as the trade draws them; with rings at the ends of those that are selected.
void paintFolds(QPainter& painter, const ViewTransform& view, const FlatPiece& piece, const PatternPicture& picture);
void paintSeams(QPainter& painter, const ViewTransform& view, const PatternPicture& picture);
void paintPoints(QPainter& painter, const ViewTransform& view, const PatternPicture& picture);
/// Both ends of every tack, with the thread between them; buttons with their holes.
void paintTacks(QPainter& painter, const ViewTransform& view, const PatternPicture& picture);
/// Rings round the points that are held.
void paintPins(QPainter& painter, const ViewTransform& view, const PatternPicture& picture);
void paintOverlay(QPainter& painter, const ViewTransform& view, const Overlay& overlay);

/// The distance of grid lines [m] that are at least `pixels` apart: 1, 2 or 5 times a power of ten.
[[nodiscard]] double gridStep(const ViewTransform& view, double pixels);
/// A small filled arrow head, its tip ahead of `at`; screen coordinates.
void paintArrowHead(QPainter& painter, QPointF at, QPointF direction, double size, const QColor& colour);

} // namespace toile::ui
