// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternTacks.h"
#include "ui/panels/SheetEdits.h"

#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;
using document::Document;

constexpr double shirtButton = 0.011; ///< diameter of a man's shirt's buttons, 18 lignes [m]

/// Where an end lies, in the plane of its piece.
void addEndRows(PropertySheet& sheet, const Document& document, const Tack& tack, std::size_t end) {
    const Piece* piece = findPiece(document.pattern, tack.ends[end].piece);
    const QString name = end == 0 ? QStringLiteral("a") : QStringLiteral("b");
    sheet.rows.push_back({name + QStringLiteral("Piece"), end == 0 ? tr("Sewn to") : tr("Held to"),
                          FactRow{piece ? QString::fromStdString(piece->name) : QString(), !piece}});
    const auto row = [&](const QString& axis, const QString& label, bool isX) {
        const Vec2 at = tack.ends[end].point;
        sheet.rows.push_back(
            {name + axis, label,
             NumberRow{Quantity::length, isX ? at.x : at.y, -10, 10, 1,
                       setting(tack.id, [end, at, isX](const Pattern& p, const TackId& id, double value) {
                           return moveTackEnd(p, id, end, isX ? Vec2{value, at.y} : Vec2{at.x, value});
                       })}});
    };
    row(QStringLiteral("X"), tr("Across (x)"), true);
    row(QStringLiteral("Y"), tr("Up (y)"), false);
}

} // namespace

PropertySheet tackSheet(const Document& document, const Tack& tack) {
    PropertySheet sheet{tr("Tack"), {}};
    sheet.rows.push_back({QStringLiteral("name"), tr("Name"),
                          TextRow{QString::fromStdString(tack.name),
                                  setting(tack.id, [](const Pattern& p, const TackId& id, const QString& name) {
                                      return renameTack(p, id, name.toStdString());
                                  })}});
    sheet.rows.push_back({QStringLiteral("button"), tr("Button"),
                          FlagRow{tack.buttonDiameter.has_value(),
                                  setting(tack.id,
                                          [](const Pattern& p, const TackId& id, bool on) {
                                              return setButtonDiameter(p, id,
                                                                       on ? std::optional(shirtButton) : std::nullopt);
                                          })},
                          tr("Else it is a tack of thread alone; both hold alike.")});
    if (tack.buttonDiameter)
        sheet.rows.push_back(
            {QStringLiteral("diameter"), tr("Diameter"),
             NumberRow{Quantity::length, *tack.buttonDiameter, 0.002, 0.1, 1, setting(tack.id, setButtonDiameter)}});
    addEndRows(sheet, document, tack, 0);
    addEndRows(sheet, document, tack, 1);
    sheet.rows.push_back({QStringLiteral("order"), tr("Order"),
                          NumberRow{Quantity::count, double(tack.order), -1000, 1000, 1,
                                    setting(tack.id,
                                            [](const Pattern& p, const TackId& id, double order) {
                                                return setTackOrder(p, id, static_cast<int>(std::lround(order)));
                                            })},
                          tr("Smaller is sewn first.")});
    sheet.rows.push_back({QStringLiteral("remove"), tr("Delete tack"), ActionRow{setting(tack.id, removeTack)}});
    return sheet;
}

} // namespace toile::ui
