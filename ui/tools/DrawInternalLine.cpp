// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/DrawInternalLine.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/Editing.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

namespace toile::ui {
namespace {

using namespace pattern;

} // namespace

Effect DrawInternalLine::made(const Desk& desk, const PieceId& piece, const std::vector<Vec2>& points) const {
    const ShapeOwner owner = shapeOwner(desk.document.pattern, piece);
    const std::size_t lines = findPiece(desk.flat, piece)->piece.internalLines.size();
    const std::string name = tr("Line %1").arg(lines + 1).toStdString();
    return effectOf(tr("Draw internal line"), document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                        return changedShape(pattern, owner.piece, [&](Piece& changed) -> Result<void> {
                            changed.internalLines.push_back({name, owner.points(points)});
                            return {};
                        });
                    }));
}

QString DrawInternalLine::firstHint() const {
    return tr("Click the points of the line, on a piece.");
}

} // namespace toile::ui
