// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFabrics.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternPieces.h"
#include "core/pattern/PatternPlacement.h"
#include "ui/panels/SheetEdits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::ui {
namespace {

using namespace pattern;
using document::Document;

Placement placementOf(const Piece& piece) {
    return piece.placement.value_or(Placement{});
}

/// Direction of the right side round the vertical, 0 = towards +z.
double turnOf(const Transform& transform) {
    return std::atan2(transform.axisZ.x, transform.axisZ.z);
}

/// A setter that changes the placement the piece has, or the one at the origin that it gets now.
auto placing(const PieceId& id, auto change) {
    return setting(id, [change](const Pattern& p, const PieceId& piece, auto value) {
        const Piece* now = findPiece(p, piece);
        Placement placement = now ? placementOf(*now) : Placement{};
        change(placement, value);
        return setPlacement(p, piece, placement);
    });
}

/// Turned about the vertical through the piece's origin.
Transform turned(const Transform& transform, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](const Vec3& v) { return Vec3{c * v.x + s * v.z, v.y, c * v.z - s * v.x}; };
    return {turn(transform.axisX), turn(transform.axisY), turn(transform.axisZ), transform.origin};
}

/// A linked image beside the piece on the table, opposite to it in space.
DocumentResult withImage(const Document& document, const PieceId& id) {
    constexpr double apart = 0.05; // on the table [m]
    return document::edited(document, [&](const Pattern& pattern, IdSource& ids) -> Result<Pattern> {
        const Piece* piece = findPiece(pattern, id);
        if (!piece) return pattern;
        auto next = addMirrorPiece(pattern, id, {0, 0}, {0, 1},
                                   tr("%1 mirrored").arg(QString::fromStdString(piece->name)).toStdString(), ids);
        if (!next) return next;
        const PieceId image = next->pieces.back()->id;
        const double half = geometry::boundsOf(flattened(piece->outline, 1e-3)).high.x;
        next = movePiece(*next, image, piece->tablePosition + Vec2{2 * half + apart, 0});
        if (next && piece->placement) next = setPlacement(*next, image, mirrored(*piece->placement));
        return next;
    });
}

/// A copy beside the piece on the table, and before it in space: two layers do not start in one place.
DocumentResult withCopy(const Document& document, const PieceId& id) {
    constexpr double apart = 0.05; // [m]
    return document::edited(document, [&](const Pattern& pattern, IdSource& ids) -> Result<Pattern> {
        const Piece* piece = findPiece(pattern, id);
        if (!piece) return pattern;
        auto next =
            duplicatePiece(pattern, id, tr("%1 copy").arg(QString::fromStdString(piece->name)).toStdString(), ids);
        if (!next) return next;
        const PieceId copy = next->pieces.back()->id;
        const geometry::Box2 box = geometry::boundsOf(flattened(resolved(pattern, *piece).outline, 1e-3));
        next = movePiece(*next, copy, piece->tablePosition + Vec2{box.high.x - box.low.x + apart, 0});
        if (!next || !piece->placement) return next;
        Placement before = *piece->placement;
        before.transform.origin += before.transform.axisZ * apart;
        return setPlacement(*next, copy, before);
    });
}

PropertyRow originRow(const Piece& piece, int axis, const QString& label) {
    return {QStringLiteral("placement%1").arg(axis), label,
            NumberRow{Quantity::length, placementOf(piece).transform.origin[axis], -10, 10, 10,
                      placing(piece.id, [axis](Placement& p, double value) { p.transform.origin[axis] = value; })}};
}

void addPlacementRows(PropertySheet& sheet, const Piece& piece) {
    const Placement placement = placementOf(piece);
    sheet.rows.push_back({QStringLiteral("placementHeading"), tr("Placement round the body"), HeadingRow{}});
    sheet.rows.push_back(originRow(piece, 0, tr("To the left (x)")));
    sheet.rows.push_back(originRow(piece, 1, tr("Height (y)")));
    sheet.rows.push_back(originRow(piece, 2, tr("To the front (z)")));
    sheet.rows.push_back(
        {QStringLiteral("placementTurn"), tr("Turned"),
         NumberRow{
             Quantity::angle, turnOf(placement.transform), -std::numbers::pi, std::numbers::pi, 5,
             placing(piece.id, [](Placement& p,
                                  double angle) { p.transform = turned(p.transform, angle - turnOf(p.transform)); })},
         tr("About the vertical; 0 faces the front, 180 the back.")});
    sheet.rows.push_back({QStringLiteral("curled"), tr("Curled"),
                          FlagRow{placement.curl.has_value(),
                                  placing(piece.id,
                                          [](Placement& p, bool on) {
                                              p.curl = on ? std::optional<Curl>({{0, 1}, 0.15}) : std::nullopt;
                                          })},
                          tr("Rolled round an upright line before it is placed.")});
    if (!placement.curl) return;
    sheet.rows.push_back({QStringLiteral("curlRadius"), tr("Curl radius"),
                          NumberRow{Quantity::length, placement.curl->radius, -5, 5, 5,
                                    placing(piece.id,
                                            [](Placement& p, double radius) {
                                                if (p.curl) p.curl->radius = radius;
                                            })},
                          tr("Negative: the right side faces inward.")});
}

void addInterfacingRows(PropertySheet& sheet, const Piece& piece) {
    const auto& now = piece.interfacing;
    sheet.rows.push_back({QStringLiteral("interfaced"), tr("Interfacing"),
                          FlagRow{now.has_value(), setting(piece.id,
                                                           [](const Pattern& p, const PieceId& id, bool on) {
                                                               return setInterfacing(p, id,
                                                                                     on ? std::optional(Interfacing{})
                                                                                        : std::nullopt);
                                                           })},
                          tr("Interlining fused to the wrong side: collars, cuffs, plackets.")});
    if (!now) return;
    const auto number = [&](const char* name, const QString& label, Quantity quantity, double Interfacing::*field,
                            double low, double high, double step) {
        sheet.rows.push_back(
            {QString::fromLatin1(name), label,
             NumberRow{quantity, *now.*field, low, high, step,
                       setting(piece.id, [was = *now, field](const Pattern& p, const PieceId& id, double value) {
                           Interfacing next = was;
                           next.*field = value;
                           return setInterfacing(p, id, next);
                       })}});
    };
    number("interfacingBending", tr("Interfacing: bending"), Quantity::factor, &Interfacing::bendingFactor, 1, 100, 1);
    number("interfacingDensity", tr("Interfacing: weight"), Quantity::arealDensity, &Interfacing::arealDensity, 0, 1,
           5);
}

/// The rows are there before the mesh is: the sheet keeps its shape when it comes.
void addMeshFacts(PropertySheet& sheet, const Document& document, const Piece& piece, const meshing::MeshReport& mesh) {
    const auto& pieces = document.pattern.pieces;
    const auto at = std::ranges::find_if(pieces, [&](const auto& p) { return p->id == piece.id; }) - pieces.begin();
    const bool isMeshed = static_cast<std::size_t>(at) < mesh.pieces.size();
    const meshing::PieceReport report = isMeshed ? mesh.pieces[at] : meshing::PieceReport{};
    const auto fact = [&](const char* name, const QString& label, const QString& text) {
        sheet.rows.push_back({QLatin1String(name), label, FactRow{isMeshed ? text : QStringLiteral("–")}});
    };
    sheet.rows.push_back({QStringLiteral("meshHeading"), tr("Mesh"), HeadingRow{}});
    fact("meshNodes", tr("Nodes"), QString::number(report.nodes));
    fact("meshQuads", tr("Quads, triangles"), tr("%1, %2").arg(report.quads).arg(report.triangles));
    fact("meshAngle", tr("Smallest angle"), textOf(Quantity::angle, report.minimumAngle));
}

} // namespace

PropertySheet pieceSheet(const Document& document, const Piece& piece, const meshing::MeshReport& mesh) {
    PropertySheet sheet{tr("Piece"), {}};
    const auto text = [](const std::string& s) { return QString::fromStdString(s); };
    sheet.rows.push_back(
        {QStringLiteral("name"), tr("Name"),
         TextRow{text(piece.name), setting(piece.id, [](const Pattern& p, const PieceId& id, const QString& name) {
                     return renamePiece(p, id, name.toStdString());
                 })}});
    if (piece.mirror) {
        const Piece* source = findPiece(document.pattern, piece.mirror->source);
        sheet.rows.push_back({QStringLiteral("mirror"), tr("Mirror image of"),
                              FactRow{source ? text(source->name) : tr("a missing piece"), !source}});
    }
    ChoiceRow fabric;
    for (const auto& item : document.pattern.fabrics) {
        if (item->id == piece.fabric) fabric.current = static_cast<int>(fabric.choices.size());
        fabric.choices << text(item->name);
    }
    std::vector<FabricId> fabrics;
    for (const auto& item : document.pattern.fabrics) fabrics.push_back(item->id);
    if (!findFabric(document.pattern, piece.fabric)) fabric.current = -1;
    fabric.set = setting(piece.id, [fabrics](const Pattern& p, const PieceId& id, int index) -> Result<Pattern> {
        if (index < 0 || index >= static_cast<int>(fabrics.size())) return p;
        return setPieceFabric(p, id, fabrics[index]);
    });
    sheet.rows.push_back({QStringLiteral("fabric"), tr("Fabric"), fabric});
    addInterfacingRows(sheet, piece);
    sheet.rows.push_back({QStringLiteral("plies"), tr("Plies"),
                          NumberRow{Quantity::count, double(piece.plies), 1, mostPlies, 1,
                                    setting(piece.id,
                                            [](const Pattern& p, const PieceId& id, double plies) {
                                                return setPlies(p, id, static_cast<int>(std::lround(plies)));
                                            })},
                          tr("Layers of the fabric on one another, joined at their edges: a double yoke has two.")});
    sheet.rows.push_back({QStringLiteral("layer"), tr("Layer"),
                          NumberRow{Quantity::count, double(piece.layer), 0, outermostLayer, 1,
                                    setting(piece.id,
                                            [](const Pattern& p, const PieceId& id, double layer) {
                                                return setLayer(p, id, static_cast<int>(std::lround(layer)));
                                            })},
                          tr("Where pieces overlap, the higher layer lies outside.")});
    sheet.rows.push_back(
        {QStringLiteral("pressure"), tr("Pressure"),
         NumberRow{Quantity::pressure, piece.pressure, -mostPressure, mostPressure, 1, setting(piece.id, setPressure)},
         tr("Of air behind the piece: above 0 it blows the cloth out to its right side.")});
    sheet.rows.push_back({QStringLiteral("frozen"), tr("Frozen"), FlagRow{piece.frozen, setting(piece.id, setFrozen)},
                          tr("The piece stays where it lies while the others go on.")});
    sheet.rows.push_back({QStringLiteral("strengthened"), tr("Strengthened"),
                          FlagRow{piece.strengthened, setting(piece.id, setStrengthened)},
                          tr("Stiffer to bend, so that the piece does not crumple while it is arranged and sewn.")});
    sheet.rows.push_back({QStringLiteral("spacing"), tr("Particle distance"),
                          NumberRow{Quantity::length, piece.spacing, 0.001, 0.2, 1, setting(piece.id, setSpacing)},
                          tr("ε_m, the spacing of the main region: smaller is finer and slower.")});
    if (const auto cloth = clothOf(document.pattern, piece); cloth && !piece.strengthened) {
        const double proposed = material::proposedSpacing(*cloth);
        sheet.rows.push_back(
            {QStringLiteral("proposedSpacing"), tr("Use %1 for this fabric").arg(textOf(Quantity::length, proposed)),
             ActionRow{[id = piece.id, proposed](const Document& d) { return setting(id, setSpacing)(d, proposed); }},
             tr("Half the bending length: coarser, its folds are not seen.")});
    }
    if (!piece.mirror)
        sheet.rows.push_back({QStringLiteral("grain"), tr("Grain"),
                              NumberRow{Quantity::angle, piece.grain, -std::numbers::pi, std::numbers::pi, 5,
                                        setting(piece.id, setGrain)},
                              tr("Direction of warp from upright, counter-clockwise.")});
    sheet.rows.push_back({QStringLiteral("rule"), tr("Scan lines"),
                          ChoiceRow{{tr("Regular grid"), tr("Through features"), tr("Through every point (Liu 2002)")},
                                    static_cast<int>(piece.rule),
                                    setting(piece.id, [](const Pattern& p, const PieceId& id, int index) {
                                        return setLineRule(p, id, static_cast<LineRule>(index));
                                    })}});
    sheet.rows.push_back({QStringLiteral("border"), tr("Region borders"),
                          ChoiceRow{{tr("Snap to main cells"), tr("Exact")},
                                    static_cast<int>(piece.border),
                                    setting(piece.id, [](const Pattern& p, const PieceId& id, int index) {
                                        return setRegionBorder(p, id, static_cast<RegionBorder>(index));
                                    })}});
    sheet.rows.push_back(
        {QStringLiteral("seamAllowance"), tr("Seam allowance"),
         NumberRow{Quantity::length, piece.seamAllowance, 0, 0.1, 1, setting(piece.id, setSeamAllowance)}});
    if (!piece.mirror)
        sheet.rows.push_back({QStringLiteral("addMirror"), tr("Add mirror image"),
                              ActionRow{[id = piece.id](const Document& d) { return withImage(d, id); }},
                              tr("It follows every change of this piece.")});
    sheet.rows.push_back({QStringLiteral("duplicate"), tr("Duplicate piece"),
                          ActionRow{[id = piece.id](const Document& d) { return withCopy(d, id); }},
                          tr("A copy that goes its own way, without seams.")});
    addPlacementRows(sheet, piece);
    addMeshFacts(sheet, document, piece, mesh);
    return sheet;
}

} // namespace toile::ui
