// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFabrics.h"
#include "ui/panels/SheetEdits.h"

namespace toile::ui {
namespace {

using namespace pattern;
using document::Document;

/// A setter of a constant of the fabric; the result is checked.
auto constant(const FabricId& fabric, auto change) {
    return setting(fabric, [change](const Pattern& pattern, const FabricId& id, auto value) -> Result<Pattern> {
        const Fabric* now = findFabric(pattern, id);
        if (!now) return pattern;
        Fabric next = *now;
        change(next, value);
        return replaceFabric(pattern, std::move(next));
    });
}

} // namespace

PropertySheet fabricSheet(const Document&, const Fabric& fabric) {
    PropertySheet sheet{tr("Fabric"), {}};
    const auto number = [&](const char* name, const QString& label, Quantity quantity, double Fabric::*field,
                            double low, double high, double step, const QString& tip = {}) {
        sheet.rows.push_back({QString::fromLatin1(name), label,
                              NumberRow{quantity, fabric.*field, low, high, step,
                                        constant(fabric.id, [field](Fabric& f, double value) { f.*field = value; })},
                              tip});
    };
    sheet.rows.push_back(
        {QStringLiteral("name"), tr("Name"),
         TextRow{QString::fromStdString(fabric.name),
                 constant(fabric.id, [](Fabric& f, const QString& name) { f.name = name.toStdString(); })}});
    sheet.rows.push_back({QStringLiteral("kind"), tr("Kind"),
                          ChoiceRow{{tr("Woven"), tr("Knit")},
                                    static_cast<int>(fabric.kind),
                                    constant(fabric.id, [](Fabric& f, int index) {
                                        f.kind = static_cast<material::FabricKind>(index);
                                    })}});
    number("arealDensity", tr("Weight"), Quantity::arealDensity, &Fabric::arealDensity, 0.005, 5, 5);
    number("thickness", tr("Thickness"), Quantity::length, &Fabric::thickness, 0.00002, 0.02, 0.1);
    number("friction", tr("Friction"), Quantity::factor, &Fabric::friction, 0, 2, 0.05);
    sheet.rows.push_back({QStringLiteral("stretchHeading"), tr("Stretch"), HeadingRow{}});
    number("warpStiffness", tr("Warp"), Quantity::tension, &Fabric::warpStiffness, 0.1, 1e6, 10);
    number("weftStiffness", tr("Weft"), Quantity::tension, &Fabric::weftStiffness, 0.1, 1e6, 10);
    number("shearStiffness", tr("Shear"), Quantity::tension, &Fabric::shearStiffness, 0, 1e6, 1);
    number("coupling", tr("Coupling"), Quantity::tension, &Fabric::coupling, 0, 1e6, 1,
           tr("C12 of the membrane cell: how much a pull along warp narrows the weft."));
    sheet.rows.push_back({QStringLiteral("bendingHeading"), tr("Bending"), HeadingRow{}});
    number("warpBending", tr("Warp"), Quantity::bending, &Fabric::warpBending, 0, 0.1, 1);
    number("weftBending", tr("Weft"), Quantity::bending, &Fabric::weftBending, 0, 0.1, 1);
    number("biasBending", tr("Bias"), Quantity::bending, &Fabric::biasBending, 0, 0.1, 1);
    if (!fabric.source.empty()) {
        sheet.rows.push_back({QStringLiteral("sourceHeading"), tr("Where the numbers come from"), HeadingRow{}});
        sheet.rows.push_back({QStringLiteral("source"), {}, FactRow{QString::fromStdString(fabric.source)}});
    }
    sheet.rows.push_back(
        {QStringLiteral("duplicate"), tr("Duplicate fabric"), ActionRow{[fabric](const Document& document) {
             return document::edited(document, [&](const Pattern& pattern, IdSource& ids) {
                 Fabric copy = fabric;
                 copy.id = ids.take<FabricId>();
                 copy.name = tr("%1, copy").arg(QString::fromStdString(fabric.name)).toStdString();
                 return addFabric(pattern, std::move(copy));
             });
         }}});
    sheet.rows.push_back({QStringLiteral("remove"), tr("Delete fabric"), ActionRow{setting(fabric.id, removeFabric)}});
    return sheet;
}

} // namespace toile::ui
