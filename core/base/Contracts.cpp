// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Contracts.h"

#include <cstdio>
#include <cstdlib>

namespace toile::detail {

void contractBroken(const char* what, const std::source_location& where) {
    std::fprintf(stderr, "broken contract at %s:%u in %s: %s\n", where.file_name(), where.line(), where.function_name(),
                 what);
    std::fflush(stderr);
    std::abort();
}

} // namespace toile::detail
