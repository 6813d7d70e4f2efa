// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternPieces.h"
#include "core/pattern/PatternRegions.h"
#include "ui/panels/SheetEdits.h"
#include "ui/values/Picking.h"
#include "ui/values/Remarks.h"

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

using namespace pattern;
using document::Document;

QString nameOf(const Desk& desk, const PieceId& id) {
    const Piece* piece = findPiece(desk.document.pattern, id);
    return piece ? QString::fromStdString(piece->name) : QString();
}

/// Rows for each notch of an edge that the owner has: where it lies from the edge's start, what it looks like.
void addNotchRows(PropertySheet& sheet, const Piece& owner, const EdgeId& edge) {
    const PieceId piece = owner.id;
    const double length = edgeLength(owner, edge);
    const auto change = [piece](std::size_t index, auto edit) {
        return setting([piece, index, edit](const Pattern& p, auto value) -> Result<Pattern> {
            const Piece* now = findPiece(p, piece);
            if (!now || index >= now->notches.size()) return p;
            Notch notch = now->notches[index];
            edit(notch, value);
            return changeNotch(p, piece, index, notch);
        });
    };
    int number = 0;
    for (std::size_t i = 0; i < owner.notches.size(); ++i) {
        const Notch& notch = owner.notches[i];
        if (notch.edge != edge) continue;
        const QString name = QStringLiteral("notch%1").arg(++number);
        sheet.rows.push_back({name + QStringLiteral("Heading"), tr("Notch %1").arg(number), HeadingRow{}});
        sheet.rows.push_back({name + QStringLiteral("Position"), tr("From the start"),
                              NumberRow{Quantity::length, notch.position * length, 0, length, 1,
                                        change(i, [length](Notch& n, double value) {
                                            n.position = std::clamp(value / length, 0.0, 1.0);
                                        })}});
        sheet.rows.push_back({name + QStringLiteral("Kind"), tr("Kind"),
                              ChoiceRow{{tr("Slit"), tr("V"), tr("T"), tr("Castle")},
                                        static_cast<int>(notch.kind),
                                        change(i, [](Notch& n, int kind) { n.kind = static_cast<NotchKind>(kind); })}});
        sheet.rows.push_back({name + QStringLiteral("Double"), tr("Double"),
                              FlagRow{notch.isDouble, change(i, [](Notch& n, bool on) { n.isDouble = on; })},
                              tr("The trade marks backs with two.")});
        sheet.rows.push_back({name + QStringLiteral("Remove"), tr("Take notch %1 out").arg(number),
                              ActionRow{setting([piece, i](const Pattern& p) { return removeNotch(p, piece, i); })}});
    }
}

/// Where an image's shape is changed.
FactRow imageOf(const Piece& owner) {
    return {tr("%1; what is done here is done there").arg(QString::fromStdString(owner.name))};
}

/// A curve that looks like the edge does now, in the wanted kind of shape.
EdgeShape shapeOfKind(const geometry::Curve& curve, int kind) {
    if (kind == 1) {
        if (std::holds_alternative<geometry::LineShape>(curve.shape)) { // a line's handles lie on it: bow it a little
            const Vec2 third = (curve.end - curve.start) / 3, bow = geometry::leftOf(third) * 0.3;
            return geometry::CubicShape{curve.start + third + bow, curve.end - third + bow};
        }
        return cubicOf(curve);
    }
    if (kind == 2) {
        const double chord = distance(curve.start, curve.end);
        const Vec2 middle = geometry::pointAt(curve, 0.5);
        const double rise = chord > 0 ? cross(curve.end - curve.start, middle - curve.start) / chord : 0;
        return geometry::ArcShape{chord > 0 ? -2 * rise / chord : 0};
    }
    return geometry::LineShape{};
}

} // namespace

PropertySheet edgeSheet(const Desk& desk, const EdgeRef& ref) {
    PropertySheet sheet{tr("Edge"), {}};
    const Piece* piece = findPiece(desk.document.pattern, ref.piece);
    const Piece* owner = piece ? shapeOf(desk.document.pattern, *piece) : nullptr;
    const auto place = owner ? findEdge(*owner, ref.edge) : std::nullopt;
    if (!place) return sheet;
    sheet.rows.push_back({QStringLiteral("piece"), tr("Piece"), FactRow{nameOf(desk, ref.piece)}});
    sheet.rows.push_back(
        {QStringLiteral("length"), tr("Length"), FactRow{textOf(Quantity::length, edgeLength(*owner, ref.edge))}});
    if (piece->mirror) sheet.rows.push_back({QStringLiteral("mirror"), tr("Mirror image of"), imageOf(*owner)});
    const geometry::Curve curve = curveOf(*owner, *place);
    const PieceId id = owner->id;
    sheet.rows.push_back({QStringLiteral("shape"), tr("Shape"),
                          ChoiceRow{{tr("Line"), tr("Curve"), tr("Arc")},
                                    static_cast<int>(curve.shape.index()),
                                    setting([id, ref, curve](const Pattern& p, int kind) {
                                        return setEdgeShape(p, id, ref.edge, shapeOfKind(curve, kind));
                                    })}});
    const auto& allowance = loopOf(*owner, place->loop).edges[place->index].seamAllowance;
    sheet.rows.push_back({QStringLiteral("ownAllowance"), tr("Own seam allowance"),
                          FlagRow{allowance.has_value(), setting([id, ref](const Pattern& p, bool on) {
                                      const Piece* now = findPiece(p, id);
                                      return setEdgeSeamAllowance(p, id, ref.edge,
                                                                  on && now ? std::optional(now->seamAllowance)
                                                                            : std::nullopt);
                                  })}});
    if (allowance)
        sheet.rows.push_back(
            {QStringLiteral("seamAllowance"), tr("Seam allowance"),
             NumberRow{Quantity::length, *allowance, 0, 0.1, 1, setting([id, ref](const Pattern& p, double value) {
                           return setEdgeSeamAllowance(p, id, ref.edge, value);
                       })}});
    addNotchRows(sheet, *owner, ref.edge);
    if (const auto hole = static_cast<std::size_t>(place->loop - 1); place->loop > 0)
        sheet.rows.push_back(
            {QStringLiteral("removeHole"), tr("Delete hole"),
             ActionRow{setting([id, hole](const Pattern& p) {
                           return deleteHole(p, id, hole).map([](Edited edited) { return std::move(edited.pattern); });
                       }),
                       [id, hole](const Document& document) {
                           const auto edited = deleteHole(document.pattern, id, hole);
                           return edited ? remarksOf(edited->warnings) : QString();
                       }}});
    return sheet;
}

PropertySheet vertexSheet(const Desk& desk, const VertexRef& ref) {
    PropertySheet sheet{tr("Point"), {}};
    const FlatPiece* piece = findPiece(desk.flat, ref.piece);
    const auto position = positionOf(desk.flat, ref);
    if (!piece || !position) return sheet;
    sheet.rows.push_back({QStringLiteral("piece"), tr("Piece"), FactRow{nameOf(desk, ref.piece)}});
    sheet.rows.push_back({QStringLiteral("angle"), tr("Corner"),
                          FactRow{textOf(Quantity::angle, cornerAngle(piece->piece, ref.vertex))}});
    const auto& pins = desk.document.pattern.pins;
    const auto pin =
        std::ranges::find_if(pins, [&](const Pin& p) { return p.piece == ref.piece && p.vertex == ref.vertex; });
    const std::optional<PinId> pinned = pin == pins.end() ? std::nullopt : std::optional(pin->id);
    sheet.rows.push_back({QStringLiteral("pinned"), tr("Pinned"),
                          FlagRow{pinned.has_value(),
                                  [ref, pinned](const Document& document, bool on) -> DocumentResult {
                                      return document::edited(document, [&](const Pattern& p, IdSource& ids) {
                                          return on       ? addPin(p, ref.piece, ref.vertex, ids)
                                                 : pinned ? removePin(p, *pinned)
                                                          : Result<Pattern>(p);
                                      });
                                  }},
                          tr("Held where it lies while time runs.")});
    if (pinned)
        sheet.rows.push_back({QStringLiteral("pinnedToBody"), tr("Pinned to the body"),
                              FlagRow{pin->toBody, setting(*pinned, setPinToBody)},
                              tr("Where the body moves it is carried along, instead of staying where it is.")});
    if (piece->piece.mirror) return sheet;
    const Vec2 at = *position - piece->piece.tablePosition;
    const auto row = [&](const char* name, const QString& label, double value, bool isX) {
        sheet.rows.push_back(
            {QString::fromLatin1(name), label,
             NumberRow{Quantity::length, value, -10, 10, 1, setting([ref, at, isX](const Pattern& p, double v) {
                           return moveVertex(p, ref.piece, ref.vertex, isX ? Vec2{v, at.y} : Vec2{at.x, v});
                       })}});
    };
    row("x", tr("Across (x)"), at.x, true);
    row("y", tr("Up (y)"), at.y, false);
    return sheet;
}

PropertySheet regionSheet(const Document& document, const RegionRef& touchedRef) {
    PropertySheet sheet{tr("Region"), {}};
    const Piece* touched = findPiece(document.pattern, touchedRef.piece);
    const Piece* piece = touched ? shapeOf(document.pattern, *touched) : nullptr;
    if (!piece) return sheet;
    const RegionRef ref{piece->id, touchedRef.region};
    const auto region = std::ranges::find(piece->regions, ref.region, &Region::id);
    if (region == piece->regions.end()) return sheet;
    sheet.rows.push_back(
        {QStringLiteral("name"), tr("Name"),
         TextRow{QString::fromStdString(region->name), setting([ref](const Pattern& p, const QString& name) {
                     return renameRegion(p, ref.piece, ref.region, name.toStdString());
                 })}});
    ChoiceRow refinement;
    for (int m = 0; m <= 5; ++m)
        refinement.choices << (m == 0 ? tr("as the main region") : tr("1/%1 of the main").arg(1 << m));
    refinement.current = region->refinement;
    refinement.set = setting([ref](const Pattern& p, int m) { return setRefinement(p, ref.piece, ref.region, m); });
    sheet.rows.push_back({QStringLiteral("refinement"), tr("Spacing"), refinement, tr("ε_m/2^m")});
    sheet.rows.push_back({QStringLiteral("spacing"), tr("Particle distance"),
                          FactRow{textOf(Quantity::length, piece->spacing / std::exp2(region->refinement))}});
    sheet.rows.push_back({QStringLiteral("area"), tr("Area"),
                          FactRow{textOf(Quantity::area, std::abs(geometry::signedArea(region->outline)))}});
    sheet.rows.push_back({QStringLiteral("stiffnessHeading"), tr("Stiffness, as a factor"), HeadingRow{}});
    const auto factor = [&](const char* name, const QString& label, double StiffnessFactors::*field) {
        const StiffnessFactors now = region->stiffness;
        sheet.rows.push_back({QString::fromLatin1(name), label,
                              NumberRow{Quantity::factor, now.*field, 0.01, 1000, 0.5,
                                        setting([ref, now, field](const Pattern& p, double value) {
                                            StiffnessFactors next = now;
                                            next.*field = value;
                                            return setStiffness(p, ref.piece, ref.region, next);
                                        })}});
    };
    factor("stretch", tr("Stretch"), &StiffnessFactors::stretch);
    factor("shear", tr("Shear"), &StiffnessFactors::shear);
    factor("bending", tr("Bending"), &StiffnessFactors::bending);
    sheet.rows.push_back({QStringLiteral("remove"), tr("Delete region"), ActionRow{setting([ref](const Pattern& p) {
                              return removeRegion(p, ref.piece, ref.region);
                          })}});
    return sheet;
}

} // namespace toile::ui
