// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/SeamDraft.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternSeams.h"
#include "ui/values/Units.h"

#include <QCoreApplication>

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

QString tr(const char* text) { return QCoreApplication::translate("Sewing", text); }

std::string nameOf(const Pattern& pattern, const PieceId& id) {
    const Piece* piece = findPiece(pattern, id);
    return piece ? piece->name : std::string();
}

} // namespace

EdgePick wholeEdge(const EdgeHit& picked) { return {picked.edge.piece, picked.edge.edge, 0, 1}; }

EdgePick stretch(const EdgeHit& first, const EdgeHit& then) {
    const auto [from, to] = std::minmax(first.fraction, then.fraction);
    return {first.edge.piece, first.edge.edge, from, to};
}

Result<document::Document> withSeam(const document::Document& document, const EdgePick& a, const EdgePick& b,
                                    Meeting meeting) {
    return document::edited(document, [&](const Pattern& pattern, IdSource& ids) -> Result<Pattern> {
        const std::string name = nameOf(pattern, a.piece) + " – " + nameOf(pattern, b.piece);
        auto result = addSeam(pattern, std::span(&a, 1), std::span(&b, 1), name, ids);
        if (!result || meeting == Meeting::best) return result;
        const Seam& seam = result->seams.back();
        const bool alike = seam.sides[0].front().reversed == seam.sides[1].front().reversed;
        if (alike == (meeting == Meeting::alike)) return result;
        return reverseSeam(*result, seam.id);
    });
}

Effect sewn(const Desk& desk, const EdgePick& a, const EdgePick& b, Meeting meeting) {
    Effect effect = effectOf(tr("Sew"), withSeam(desk.document, a, b, meeting));
    if (!effect.edit) return effect;
    const Seam& seam = effect.edit->after.pattern.seams.back();
    effect.selection = Selection{seam.id};
    effect.message = lengthsText(desk.flat, seam.sides[0].front(), seam.sides[1].front());
    return effect;
}

void addSide(Overlay& overlay, const FlatPattern& flat, const SeamPart& part, Overlay::Role role) {
    const std::vector<Vec2> path = pathOf(flat, part);
    if (path.size() < 2) return;
    overlay.lines.push_back({path, role, false, false, 4});
    overlay.marks.push_back({path.front(), role});
    for (const double fraction : {0.25, 0.5, 0.75}) {
        const PathPoint point = pointAlong(path, fraction);
        overlay.arrows.push_back({point.position, point.direction, role});
    }
}

void addLinks(Overlay& overlay, const FlatPattern& flat, const SeamPart& a, const SeamPart& b) {
    const std::vector<Vec2> pathA = pathOf(flat, a), pathB = pathOf(flat, b);
    if (pathA.size() < 2 || pathB.size() < 2) return;
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0})
        overlay.lines.push_back({{pointAlong(pathA, fraction).position, pointAlong(pathB, fraction).position},
                                 Overlay::Role::accent, true, false, 1});
}

void addSeam(Overlay& overlay, const FlatPattern& flat, const Seam& seam, Vec2 labelAt) {
    const SeamPart &a = seam.sides[0].front(), &b = seam.sides[1].front();
    addSide(overlay, flat, a, Overlay::Role::sideA);
    addSide(overlay, flat, b, Overlay::Role::sideB);
    addLinks(overlay, flat, a, b);
    overlay.labels.push_back({labelAt, lengthsText(flat, a, b), Overlay::Role::sideB});
}

QString lengthsText(const FlatPattern& flat, const SeamPart& a, const SeamPart& b) {
    const double lengthA = lengthOf(pathOf(flat, a)), lengthB = lengthOf(pathOf(flat, b));
    return tr("%1 to %2, difference %3")
        .arg(textOf(Quantity::length, lengthA), textOf(Quantity::length, lengthB),
             differenceTextOf(Quantity::length, lengthA - lengthB));
}

} // namespace toile::ui
