// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFolds.h"
#include "ui/pattern/Colours.h"
#include "ui/pattern/PatternPainter.h"

namespace toile::ui {

void paintFolds(QPainter& painter, const ViewTransform& view, const FlatPiece& piece, const PatternPicture& picture) {
    painter.setBrush(Qt::NoBrush);
    for (const pattern::Fold& fold : piece.piece.folds) {
        const Item item = FoldRef{piece.piece.id, fold.id};
        const bool selected = contains(picture.selection, item);
        const bool hovered = picture.hovered == item;
        QPolygonF line;
        for (const Vec2 point : pattern::pointsOf(piece.piece, fold)) line << view.toScreen(point);
        painter.setPen(QPen(selected  ? colours::accent
                            : hovered ? colours::hover
                                      : colours::outline,
                            selected || hovered ? 2 : 1.2, Qt::DashDotLine, Qt::FlatCap));
        painter.drawPolyline(line);
        if (!selected) continue;
        for (const QPointF end : {line.value(0), line.value(line.size() - 1)}) painter.drawEllipse(end, 4, 4);
    }
}

} // namespace toile::ui
