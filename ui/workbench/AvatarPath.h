// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace toile::ui {

/// Where the avatar lies that a document's file names: relative to the file, where it has one.
///
/// While a document is open it names its avatar by this absolute path, in every step of its history: wherever it is
/// saved, undo finds the same body.
[[nodiscard]] QString avatarPath(const std::string& avatar, const QString& documentPath);

/// How a document's file names an avatar: relative to itself. Empty stays empty.
[[nodiscard]] std::string avatarName(const std::string& avatar, const QString& documentPath);

} // namespace toile::ui
