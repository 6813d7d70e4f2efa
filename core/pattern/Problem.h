// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <string>

namespace toile::pattern {

/// Something in a document that does not fit together.
struct Problem {
    Place place; ///< path in the document, e.g. "seams[3].sideA[0].edge", and the user's words
    std::string text;
    bool isError = true; ///< else a warning: it can be meshed and sewn
    friend bool operator==(const Problem&, const Problem&) = default;
};

/// "FILE:LINE: path: object: sentence" on one line; a warning says so before the sentence.
[[nodiscard]] std::string toString(const Problem& problem);

} // namespace toile::pattern
