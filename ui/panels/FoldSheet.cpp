// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFolds.h"
#include "core/pattern/PatternMeasures.h"
#include "ui/panels/SheetEdits.h"

#include <numbers>

namespace toile::ui {
namespace {

using namespace pattern;

} // namespace

PropertySheet foldSheet(const document::Document& document, const FoldRef& ref) {
    PropertySheet sheet{tr("Fold"), {}};
    const Piece* touched = findPiece(document.pattern, ref.piece);
    const Piece* piece = touched ? shapeOf(document.pattern, *touched) : nullptr;
    const Fold* fold = piece ? findFold(*piece, ref.fold) : nullptr;
    if (!fold) return sheet;
    const auto change = [owner = piece->id, id = fold->id](auto edit) {
        return setting([owner, id, edit](const Pattern& p, auto... value) { return edit(p, owner, id, value...); });
    };
    sheet.rows.push_back({QStringLiteral("name"), tr("Name"),
                          TextRow{QString::fromStdString(fold->name), change([](const Pattern& p, const PieceId& owner,
                                                                                const FoldId& id, const QString& name) {
                                      return renameFold(p, owner, id, name.toStdString());
                                  })}});
    double length = 0;
    const std::vector<Vec2> line = pointsOf(*piece, *fold);
    for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
    sheet.rows.push_back({QStringLiteral("length"), tr("Length"), FactRow{textOf(Quantity::length, length)}});
    sheet.rows.push_back(
        {QStringLiteral("foldAngle"), tr("Fold angle"),
         NumberRow{Quantity::foldAngle, fold->angle, -std::numbers::pi, std::numbers::pi, 5, change(pressFold)},
         tr("180° is flat; 0° lies right side to right side, 360° wrong side to wrong side.")});
    sheet.rows.push_back({QStringLiteral("stiffness"), tr("Stiffness"),
                          NumberRow{Quantity::factor, fold->stiffnessFactor, 0.01, 1000, 0.5, change(setFoldStiffness)},
                          tr("Bending along the fold, as a factor.")});
    sheet.rows.push_back({QStringLiteral("remove"), tr("Delete fold"), ActionRow{change(removeFold)}});
    return sheet;
}

} // namespace toile::ui
