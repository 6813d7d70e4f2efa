// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace toile::ui {

/// Fusion with our own quiet, light palette; the same on every desktop.
void applyTheme(QApplication& application);

} // namespace toile::ui
