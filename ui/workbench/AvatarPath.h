// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace toile::ui {

/// Where the document's avatar lies: its path is relative to the document's file.
[[nodiscard]] QString avatarPath(const std::string& avatar, const QString& documentPath);

/// How the document names a file: relative to its own where it has one.
[[nodiscard]] std::string avatarName(const QString& file, const QString& documentPath);

} // namespace toile::ui
