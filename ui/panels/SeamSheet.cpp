// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternSeams.h"
#include "ui/panels/SheetEdits.h"

#include <cmath>
#include <numbers>

namespace toile::ui {
namespace {

using namespace pattern;
using document::Document;

/// Difference of lengths that is neither declared as ease nor as gathering: worth a look from this on [m].
constexpr double notableMismatch = 0.5e-3;

void addLengthRows(PropertySheet& sheet, const Desk& desk, const Seam& seam) {
    const auto sections = sectionsOf(desk.document.pattern, seam);
    if (!sections) {
        sheet.rows.push_back(
            {QStringLiteral("lengthA"), tr("Lengths"), FactRow{tr("a side or its notches do not fit"), true}});
        sheet.rows.push_back(
            {QStringLiteral("easeAway"), tr("Take the difference as ease"), ActionRow{setting(seam.id, easeAway)}});
        return;
    }
    double a = 0, b = 0, wanted = 0, mismatch = 0;
    for (const SectionLengths& section : *sections) {
        a += section.a;
        b += section.b;
        wanted += section.wantedEase;
        mismatch = std::max(mismatch, std::abs(section.mismatch()));
    }
    sheet.rows.push_back({QStringLiteral("lengthA"), tr("Length of side A"), FactRow{textOf(Quantity::length, a)}});
    sheet.rows.push_back({QStringLiteral("lengthB"), tr("Length of side B"), FactRow{textOf(Quantity::length, b)}});
    sheet.rows.push_back({QStringLiteral("difference"), tr("Difference"),
                          FactRow{differenceTextOf(Quantity::length, a - b), mismatch > notableMismatch},
                          tr("Red where it is more than is declared as ease.")});
    const bool gathered = isGathered(seam);
    if (gathered || std::abs(a - b) > notableMismatch)
        sheet.rows.push_back(
            {QStringLiteral("gathered"), tr("Gathered"),
             FlagRow{gathered, setting(seam.id, [](const Pattern& p, const SeamId& id,
                                                   bool on) { return on ? gatherAway(p, id) : easeAway(p, id); })},
             tr("A thread draws up the longer side, and the shorter one keeps its length. Ease is drawn up in the "
                "same way, unless the shorter side is of knit: that stretches.")});
    if (gathered && sections->size() == 1)
        sheet.rows.push_back({QStringLiteral("gatherRatio"), tr("Gather ratio (A / B)"),
                              NumberRow{Quantity::factor, seam.sections[0].gatherRatio.value_or(1), 0.01, 100, 0.1,
                                        setting(seam.id, [](const Pattern& p, const SeamId& id,
                                                            double ratio) { return setGatherRatio(p, id, 0, ratio); })},
                              tr("How many times as long side A is wanted.")});
    else if (sections->size() == 1)
        sheet.rows.push_back({QStringLiteral("ease"), tr("Ease (A − B)"),
                              NumberRow{Quantity::length, wanted, -1, 1, 1,
                                        setting(seam.id, [](const Pattern& p, const SeamId& id,
                                                            double ease) { return setSeamEase(p, id, 0, ease); })},
                              tr("How much longer side A is wanted.")});
    else
        sheet.rows.push_back({QStringLiteral("ease"), tr("Ease in %1 sections").arg(sections->size()),
                              FactRow{differenceTextOf(Quantity::length, wanted)}});
    if (mismatch > notableMismatch)
        sheet.rows.push_back(
            {QStringLiteral("easeAway"), tr("Take the difference as ease"), ActionRow{setting(seam.id, easeAway)}});
}

void addElasticRows(PropertySheet& sheet, const Seam& seam) {
    const auto& now = seam.elastic;
    sheet.rows.push_back({QStringLiteral("elastic"), tr("Elastic"),
                          FlagRow{now.has_value(), setting(seam.id,
                                                           [](const Pattern& p, const SeamId& id, bool on) {
                                                               return setElastic(
                                                                   p, id, on ? std::optional(Elastic{}) : std::nullopt);
                                                           })},
                          tr("A band that is sewn in along the seam and draws it up.")});
    if (!now) return;
    const auto number = [&](const char* name, const QString& label, Quantity quantity, double Elastic::*field,
                            double low, double high, double step, const QString& tip) {
        sheet.rows.push_back({QString::fromLatin1(name), label,
                              NumberRow{quantity, *now.*field, low, high, step,
                                        setting(seam.id,
                                                [was = *now, field](const Pattern& p, const SeamId& id, double value) {
                                                    Elastic next = was;
                                                    next.*field = value;
                                                    return setElastic(p, id, next);
                                                })},
                              tip});
    };
    number("elasticRatio", tr("Elastic: length"), Quantity::factor, &Elastic::ratio, 0.05, 0.99, 0.05,
           tr("At rest, as a share of the sewn length."));
    number("elasticStiffness", tr("Elastic: stiffness"), Quantity::force, &Elastic::stiffness, 0.1, 10'000, 5,
           tr("The pull at which the band is twice as long as at rest."));
}

} // namespace

PropertySheet seamSheet(const Desk& desk, const Seam& seam) {
    PropertySheet sheet{tr("Seam"), {}};
    sheet.rows.push_back({QStringLiteral("name"), tr("Name"),
                          TextRow{QString::fromStdString(seam.name),
                                  setting(seam.id, [](const Pattern& p, const SeamId& id, const QString& name) {
                                      return renameSeam(p, id, name.toStdString());
                                  })}});
    addLengthRows(sheet, desk, seam);
    sheet.rows.push_back({QStringLiteral("foldAngle"), tr("Fold angle"),
                          NumberRow{Quantity::foldAngle, seam.foldAngle, -std::numbers::pi, std::numbers::pi, 5,
                                    setting(seam.id, setFoldAngle)},
                          tr("180° is flat.")});
    sheet.rows.push_back(
        {QStringLiteral("stiffness"), tr("Stiffness"),
         NumberRow{Quantity::factor, seam.stiffnessFactor, 0, 1000, 0.5, setting(seam.id, setSeamStiffness)},
         tr("Bending along the seam, as a factor.")});
    addElasticRows(sheet, seam);
    sheet.rows.push_back({QStringLiteral("order"), tr("Order"),
                          NumberRow{Quantity::count, double(seam.order), -1000, 1000, 1,
                                    setting(seam.id,
                                            [](const Pattern& p, const SeamId& id, double order) {
                                                return setSeamOrder(p, id, static_cast<int>(std::lround(order)));
                                            })},
                          tr("Smaller is sewn first.")});
    sheet.rows.push_back({QStringLiteral("reverse"), tr("Reverse"), ActionRow{setting(seam.id, reverseSeam)},
                          tr("Side B is sewn from its other end.")});
    sheet.rows.push_back({QStringLiteral("remove"), tr("Delete seam"), ActionRow{setting(seam.id, removeSeam)}});
    return sheet;
}

} // namespace toile::ui
