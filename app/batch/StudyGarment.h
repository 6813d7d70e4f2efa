// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"

namespace toile::batch {

/// Whether what is to be studied is a document, and no scene by name.
[[nodiscard]] bool namesADocument(const StudyOptions& options);
/// Error against run time of drapes of a document's garment.
[[nodiscard]] int studyGarment(const StudyOptions& options, std::stop_token stop);

} // namespace toile::batch
