// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/TakeTyped.h"

#include <QApplication>
#include <QPointer>
#include <QWidget>

namespace toile::ui {

void takeTyped(QWidget& window) {
    const QPointer<QWidget> field = QApplication::focusWidget();
    if (!field || !window.isAncestorOf(field) || !field->testAttribute(Qt::WA_InputMethodEnabled)) return;
    field->clearFocus();
    if (field && field->isVisible()) field->setFocus(); // the sheet may have been made anew
}

} // namespace toile::ui
