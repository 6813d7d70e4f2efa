// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/Arrange.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternPlacement.h"
#include "ui/tools/DrawPiece.h"
#include "ui/values/Words.h"

#include <cmath>
#include <numbers>

namespace toile::ui {
namespace {

using namespace pattern;

constexpr double clearance = 0.08; // between the box round the body and the piece [m]

geometry::Box3 boxOf(const body::Body* body) {
    if (body && !body->mesh.vertices.empty()) return geometry::boundsOf(body->mesh.vertices);
    return {{-0.25, 0, -0.18}, {0.25, 1.7, 0.18}}; // an adult
}

/// Standing upright, the right side facing a direction round the vertical; 0 = +z [rad].
Transform facing(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
}

} // namespace

Placement placedBeside(const body::Body* body, BodySide side, const Placement& before) {
    const geometry::Box3 box = boxOf(body);
    const Vec3 middle = lerp(box.low, box.high, 0.5);
    Placement placement = before;
    const double quarter = std::numbers::pi / 2;
    switch (side) {
    case BodySide::front: placement.transform = facing(0); break;
    case BodySide::back: placement.transform = facing(2 * quarter); break;
    case BodySide::left: placement.transform = facing(quarter); break;
    case BodySide::right: placement.transform = facing(-quarter); break;
    }
    const Vec3 outward = placement.transform.axisZ;
    const double reach =
        (std::abs(outward.x) * (box.high.x - box.low.x) + std::abs(outward.z) * (box.high.z - box.low.z)) / 2;
    placement.transform.origin = Vec3{middle.x, before.transform.origin.y, middle.z} + outward * (reach + clearance);
    return placement;
}

Effect arranged(const Desk& desk, const body::Body* body, BodySide side) {
    const QString name = tr("Place beside the body");
    Selection pieces;
    for (const Item& item : desk.selection)
        if (!pieceOf(item).empty()) pieces.push_back(pieceOf(item));
    if (pieces.empty()) return refusal(tr("Select the pieces to place first."));
    return effectOf(name, document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                        Result<Pattern> result = pattern;
                        for (const Item& item : pieces) {
                            const Piece* piece = findPiece(pattern, pieceOf(item));
                            if (result && piece)
                                result =
                                    setPlacement(*result, piece->id,
                                                 placedBeside(body, side, piece->placement.value_or(startingPlace())));
                        }
                        return result;
                    }));
}

} // namespace toile::ui
