// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternRegions.h"
#include "ui/tools/PaintRegion.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

namespace toile::ui {
namespace {

using namespace pattern;

} // namespace

Effect PaintPolygon::made(const Desk& desk, const PieceId& piece, const std::vector<Vec2>& corners) const {
    const ShapeOwner owner = shapeOwner(desk.document.pattern, piece);
    const std::string name = tr("Region %1").arg(findPiece(desk.flat, piece)->piece.regions.size() + 1).toStdString();
    Effect effect =
        effectOf(tr("Paint region"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                     return addRegion(pattern, owner.piece, owner.points(corners), name, options_.refinement, ids);
                 }));
    if (effect.edit)
        effect.selection =
            Selection{RegionRef{piece, findPiece(effect.edit->after.pattern, owner.piece)->regions.back().id}};
    return effect;
}

QString PaintPolygon::firstHint() const {
    return tr("Click the corners of the region, on a piece.");
}

} // namespace toile::ui
