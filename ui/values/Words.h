// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace toile::ui {

/// A text in the language of the window, where no class has a tr() of its own. Tables know no contexts (Translation.h).
inline QString tr(const char* text) {
    return QCoreApplication::translate("toile", text);
}

} // namespace toile::ui
