// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/GarmentCodeFile.h"
#include "core/pattern/Problem.h"

#include <filesystem>
#include <string>
#include <vector>

namespace toile::io {

/// Reads a document or a foreign pattern, told by the file name's extension: .toile is ours, .json is GarmentCode.
[[nodiscard]] Result<Imported> readDocument(const std::string& path);

/// The path of a file that a document names: relative to the document's own folder.
[[nodiscard]] std::filesystem::path fileNamedBy(const std::filesystem::path& documentPath, const std::string& name);

/// The other way round: how a document names a file, relative to its own folder wherever both lie on the disk.
[[nodiscard]] std::string nameFrom(const std::filesystem::path& documentPath, const std::filesystem::path& file);

/// All that is wrong or remarkable in a document that could be read.
struct Checked {
    document::Document document;
    std::vector<pattern::Problem> problems; ///< in the order of the file; places have file and line

    [[nodiscard]] bool hasErrors() const;
};

/// Reads a file and checks everything that can be checked without meshing: ids, references, contours, regions, seam
/// lengths, settings, and whether the files it names exist. Error when it cannot be read at all.
[[nodiscard]] Result<Checked> checkFile(const std::string& path);

/// An error in a document that was read from this file: with the file's name, and, where the document is ours and the
/// error tells a path in it, the line. What names another file, or nothing of the document, stays as it is.
[[nodiscard]] Error locatedIn(const std::string& path, Error error);

/// Line of the value at a path like "pieces[2].vertices[0].x", or of the innermost part of the path that there is.
[[nodiscard]] int lineOf(const Json& root, std::string_view path);

} // namespace toile::io
