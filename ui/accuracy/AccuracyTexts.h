// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/GarmentAccuracy.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace toile::ui {

/// How a study of a garment is told to its user: functions from values to texts.

/// A line of the table of runs.
struct AccuracyRow {
    const study::GarmentRun* run = nullptr; ///< of the study; null = the setup was not run to its end
    bool onFront = false;                   ///< no other is both cheaper and nearer
    QStringList cells;                      ///< as the columns
};

[[nodiscard]] QStringList accuracyColumns();
/// By rising CPU time; those without one last.
[[nodiscard]] std::vector<AccuracyRow> accuracyRowsOf(const study::GarmentAccuracy& study);

[[nodiscard]] QString methodText(const std::optional<dynamics::Method>& method, bool finished);
[[nodiscard]] QString layoutText(const study::GarmentSetup& setup);
[[nodiscard]] QString meshText(const study::GarmentRun& run); ///< "20 mm as drawn"
/// "XPBD, finished, 20 mm as drawn"
[[nodiscard]] QString settingText(const study::GarmentRun& run);
[[nodiscard]] QString remarkOn(const study::GarmentRun& run);

[[nodiscard]] QStringList quantityColumns();
/// Reference, floor and, of a run, its error, of every quantity that the garment has.
[[nodiscard]] std::vector<QStringList> quantityRowsOf(const study::GarmentAccuracy& study,
                                                      const study::GarmentRun* run);

/// Whether the window drapes by it: there cloth moves.
[[nodiscard]] bool isOfTheWindow(const study::GarmentRun& run);

/// What is suggested to who wants every length right within so much [m].
struct Suggestion {
    QString text;
    const study::GarmentRun* run = nullptr; ///< to be used; null = none
};
[[nodiscard]] Suggestion suggestionFor(const study::GarmentAccuracy& study, double within);

/// What a study under way is doing, in its own words.
[[nodiscard]] QString doingText(const std::string& doing);

/// What the study cannot tell.
[[nodiscard]] QString unknownsOf(const study::GarmentAccuracy& study);

} // namespace toile::ui
