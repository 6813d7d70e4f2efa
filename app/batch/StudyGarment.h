// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"
#include "core/study/GarmentReport.h"

namespace toile::batch {

/// Whether what is to be studied is a document, and no scene by name.
[[nodiscard]] bool namesADocument(const StudyOptions& options);
/// Error against run time of drapes of a document's garment.
[[nodiscard]] int studyGarment(const StudyOptions& options, std::stop_token stop);

/// report.md, results.jsonl and, where a run counts, accuracy.gp, drawn: false where there is no gnuplot to draw it.
[[nodiscard]] Result<bool> writeGarmentReport(const std::string& folder, const study::GarmentAccuracy& study,
                                              const std::optional<double>& within,
                                              const study::Circumstances& circumstances);

} // namespace toile::batch
