// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/AccuracyTexts.h"

#include "core/study/Advice.h"
#include "core/study/GarmentReport.h"
#include "ui/values/Words.h"

#include <QRegularExpression>

#include <algorithm>

namespace toile::ui {
namespace {

using dynamics::Method;
using study::GarmentAccuracy;
using study::GarmentRun;

/// Words of the core that the table of texts has.
QString translated(std::string_view text) {
    return tr(std::string(text).c_str());
}

QString number(double value, int digits) {
    return QString::number(value, 'g', digits);
}

QString millimetres(double metres, int digits = 2) {
    return number(1e3 * metres, digits);
}

QString seconds(double value) {
    return number(value, 3);
}

QStringList cellsOf(const GarmentRun& run) {
    return {methodText(run.setup.method, run.finished),
            layoutText(run.setup),
            millimetres(run.spacing, 3),
            seconds(run.time.least),
            number(run.score, 2),
            millimetres(run.lengthError),
            QString::number(run.drape.particles),
            remarkOn(run)};
}

QString shownOf(const study::Quantity& quantity, double value, bool withSign = false) {
    const double shown = study::shown(quantity.measure, value);
    const QString text = QString::number(shown, 'f', quantity.measure == study::Measure::strain ? 2 : 1);
    return withSign && shown > 0 ? QLatin1Char('+') + text : text;
}

QString toldOf(const study::Advice& advice, const GarmentAccuracy& study, double within) {
    const QString wanted = millimetres(within, 3);
    switch (advice.counsel) {
    case study::Counsel::meets:
        return tr("Cheapest with every length within %1 mm of the reference: %2 – %3 CPU s, within %4 mm.")
            .arg(wanted, settingText(*advice.run), seconds(advice.run->time.least),
                 millimetres(advice.run->lengthError));
    case study::Counsel::noneMeets:
        return tr("Nothing that was tried has every length within %1 mm. The nearest: %2 – within %3 mm, %4 CPU s.")
            .arg(wanted, settingText(*advice.run), millimetres(advice.run->lengthError),
                 seconds(advice.run->time.least));
    case study::Counsel::belowFloor:
        return tr("Within %1 mm nothing can be told: “%2” differs by %3 mm from one drape of this garment to the next.")
            .arg(wanted, translated(study.reference.mean[advice.quantity].name),
                 millimetres(study.reference.floor[advice.quantity]));
    case study::Counsel::noLengths:
        return tr("This garment has no lengths that could be compared: no hem, girth, neck or shoulder on a body.");
    case study::Counsel::tooNoisy:
        return tr("Nothing is suggested: of %1 of %2 runs the times differ by more than a third, the machine was too "
                  "busy. Pause the simulation and measure again while the computer does nothing else.")
            .arg(study::noisyRuns(study))
            .arg(study::countedRuns(study).size());
    case study::Counsel::noRun: break;
    }
    return tr("Nothing is suggested: no run came to rest as it should.");
}

} // namespace

QStringList accuracyColumns() {
    return {tr("Method"),     tr("Mesh"),     tr("mm"),        tr("CPU s"),
            tr("Floors off"), tr("Worst mm"), tr("Particles"), tr("Remark")};
}

QString methodText(const std::optional<Method>& method, bool finished) {
    if (!method) return tr("Statics alone");
    const QString name = *method == Method::xpbd     ? QStringLiteral("XPBD")
                         : *method == Method::trBdf2 ? QStringLiteral("TR-BDF2")
                                                     : QString::fromUtf8(dynamics::nameOf(*method).data());
    return (finished ? tr("%1, finished") : tr("%1, at rest")).arg(name);
}

QString layoutText(const study::GarmentSetup& setup) {
    return setup.regions ? tr("as drawn") : tr("uniform");
}

QString meshText(const GarmentRun& run) {
    return tr("%1 mm %2").arg(millimetres(run.spacing, 3), layoutText(run.setup));
}

QString settingText(const GarmentRun& run) {
    return tr("%1, %2").arg(methodText(run.setup.method, run.finished), meshText(run));
}

QString remarkOn(const GarmentRun& run) {
    if (!run.drape.status.empty()) return tr("does not count: %1").arg(translated(run.drape.status));
    if (run.time.noisy) return tr("noisy");
    return run.repetitions == 1 ? tr("timed once") : QString();
}

std::vector<AccuracyRow> accuracyRowsOf(const GarmentAccuracy& study) {
    const auto front = study::frontOf(study);
    std::vector<AccuracyRow> rows;
    for (const GarmentRun& run : study.runs) {
        AccuracyRow row{&run, std::ranges::find(front, &run) != front.end(), cellsOf(run)};
        if (row.onFront)
            row.cells.back() = QStringList{tr("on the front"), remarkOn(run)}
                                   .filter(QRegularExpression(QStringLiteral(".")))
                                   .join(QStringLiteral(", "));
        rows.push_back(std::move(row));
    }
    std::ranges::stable_sort(rows, {}, [](const AccuracyRow& row) { return row.run->time.least; });
    for (const study::NotRunSetup& setup : study.notRun)
        rows.push_back({nullptr,
                        false,
                        {methodText(setup.setup.method, true),
                         layoutText(setup.setup),
                         millimetres(setup.setup.factor * study.mainSpacing, 3),
                         {},
                         {},
                         {},
                         {},
                         tr("given up: %1").arg(translated(setup.why))}});
    return rows;
}

QStringList quantityColumns() {
    return {tr("Quantity"), tr("Unit"), tr("Reference"), tr("Floor"), tr("Error")};
}

std::vector<QStringList> quantityRowsOf(const GarmentAccuracy& study, const GarmentRun* run) {
    std::vector<QStringList> rows;
    for (std::size_t q = 0; q < study.reference.mean.size(); ++q) {
        const study::Quantity& quantity = study.reference.mean[q];
        if (!quantity.value) continue;
        const bool known = run && q < run->errors.size() && run->errors[q];
        rows.push_back({translated(quantity.name), translated(study::unitOf(quantity.measure)),
                        shownOf(quantity, *quantity.value), shownOf(quantity, study.reference.floor[q]),
                        known ? shownOf(quantity, *run->errors[q], true) : QString()});
    }
    return rows;
}

bool isOfTheWindow(const GarmentRun& run) {
    return run.setup.method.has_value();
}

Suggestion suggestionFor(const GarmentAccuracy& study, double within) {
    const study::Advice all = study::adviceOn(study, within);
    Suggestion suggestion{toldOf(all, study, within), all.run};
    if (!all.run || isOfTheWindow(*all.run)) return suggestion;
    suggestion.text += QLatin1Char(' ') + tr("That method is on the command line only.");
    const study::Advice here = study::adviceOn(study, within, isOfTheWindow);
    if (!here.run) return suggestion;
    suggestion.text += QLatin1Char(' ') + tr("In the window: %1 – within %2 mm, %3 CPU s.")
                                              .arg(settingText(*here.run), millimetres(here.run->lengthError),
                                                   seconds(here.run->time.least));
    suggestion.run = here.run;
    return suggestion;
}

/// "reference 2 of 5", "as drawn × 1.4, xpbd"
QString doingText(const std::string& doing) {
    static const QRegularExpression reference(QStringLiteral("^reference (\\d+) of (\\d+)$"));
    static const QRegularExpression setup(QStringLiteral("^(.+) × ([\\d.]+), (\\S+)$"));
    const QString text = QString::fromStdString(doing);
    if (const auto match = reference.match(text); match.hasMatch())
        return tr("Reference drape %1 of %2").arg(match.captured(1), match.captured(2));
    if (const auto match = setup.match(text); match.hasMatch())
        return tr("%1 at %2 × the spacing, %3")
            .arg(match.captured(3), match.captured(2), tr(match.captured(1).toUtf8().constData()));
    return text.isEmpty() ? tr("Beginning") : text;
}

QString unknownsOf(const GarmentAccuracy& study) {
    const study::GarmentReference& reference = study.reference;
    QStringList sentences{
        tr("Reference: the mean of %1 drapes at %2 mm, uniform; what is finer than that is not known.")
            .arg(reference.runs)
            .arg(millimetres(reference.spacing, 3)),
        tr("Its drapes are up to %1 floors off each other: nothing below that is told apart.")
            .arg(number(reference.band, 2))};
    if (const std::size_t noisy = study::noisyRuns(study); noisy > 0)
        sentences << tr("Noisy runs: %1; of cost nothing is concluded.").arg(noisy);
    if (!study.notRun.empty()) sentences << tr("Setups given up: %1.").arg(study.notRun.size());
    sentences << tr("The error is numerical; how far the fabric's constants are from the cloth is not known.");
    return sentences.join(QLatin1Char(' '));
}

} // namespace toile::ui
