// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/CutHole.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

} // namespace

Effect CutHole::made(const Desk& desk, const PieceId& piece, const std::vector<Vec2>& corners) const {
    const FlatPiece& flat = *findPiece(desk.flat, piece);
    if (!std::ranges::all_of(corners, [&](Vec2 corner) { return covers(flat, corner); }))
        return refusal(tr("A hole lies inside its piece, with all its corners."));
    const ShapeOwner owner = shapeOwner(desk.document.pattern, piece);
    return effectOf(tr("Cut hole"), document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                        return addHole(pattern, owner.piece, owner.points(corners), ids);
                    }));
}

QString CutHole::firstHint() const {
    return tr("Click the corners of the hole, inside a piece.");
}

} // namespace toile::ui
