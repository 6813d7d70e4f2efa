// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::batch {

/// A report in Markdown as a page for the browser that needs nothing beside it but the report's pictures: titled by
/// its first heading.
[[nodiscard]] std::string htmlReport(const std::string& markdown);

} // namespace toile::batch
