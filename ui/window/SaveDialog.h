// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace toile::ui {

/// Asks for the name of a file to write, and before one is replaced; empty when the user gives it up.
///
/// The name ends as one of the kinds does ("Wavefront OBJ (*.obj);;PLY (*.ply)"): one that ends otherwise, be it with
/// a dot or without, gets the ending of the kind that is chosen. `proposal` is a folder, or a file in it.
[[nodiscard]] QString fileToWrite(QWidget& window, const QString& title, const QString& proposal, const QString& kinds);

} // namespace toile::ui
