// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

#include <string>
#include <string_view>

namespace toile::io {

/// The version of the format that is written: a file of a higher one is refused (docs/formats/toile.md).
inline constexpr int toileVersion = 1;

/// Reads a .toile document. An error names the file, the line, the path in the document, and what was expected.
/// Whether the pieces and seams make sense is for pattern::checkPattern to say.
[[nodiscard]] Result<document::Document> readToile(const std::string& path);
/// The same from a text; `file` is named in errors.
[[nodiscard]] Result<document::Document> documentFromText(std::string_view text, const std::string& file = {});

/// The document as a file holds it: lengths in millimetres rounded to 1e-6 mm, angles in degrees, keys in a fixed
/// order, one value a line. Reading the text and writing it again gives the same bytes.
[[nodiscard]] std::string toileText(const document::Document& document);
/// Error when a number is not finite, or the file cannot be written; then the old file is untouched.
[[nodiscard]] Result<void> writeToile(const document::Document& document, const std::string& path);

/// The document with its numbers rounded as a file rounds them: what reading the saved file gives. Error when a number
/// is not finite.
[[nodiscard]] Result<document::Document> asWritten(const document::Document& document);

} // namespace toile::io
