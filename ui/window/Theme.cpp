// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace toile::ui {

void applyTheme(QApplication& application) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QPalette palette;
    const QColor window(238, 240, 242), base(252, 253, 253), text(40, 48, 58), quiet(138, 146, 155);
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, QColor(244, 246, 247));
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::PlaceholderText, quiet);
    palette.setColor(QPalette::Button, QColor(244, 245, 247));
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::ToolTipBase, QColor(255, 255, 250));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Highlight, QColor(20, 115, 200));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(20, 115, 200));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, quiet);
    application.setPalette(palette);
    application.setStyleSheet(QStringLiteral(
        "QToolBar { border: 0; border-bottom: 1px solid #d3d8dd; spacing: 2px; padding: 3px 6px; background: #f4f5f7; }"
        "QToolBar::separator { width: 1px; margin: 5px 5px; background: #d3d8dd; }"
        "QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 3px; }"
        "QToolButton[popupMode=\"1\"] { padding-right: 16px; }"
        "QToolButton::menu-button { border: 0; width: 14px; }"
        "QToolButton:hover { background: #e4e9ee; }"
        "QToolButton:pressed { background: #d4dce4; }"
        "QToolButton:checked { background: #d6e6f5; border-color: #8dbbe4; }"
        "#viewBar { padding: 0 4px; spacing: 1px; } #viewBar QToolButton { padding: 2px 1px; }"
        "QStatusBar { border-top: 1px solid #d3d8dd; }"
        "QStatusBar::item { border: 0; }"
        "QSplitter::handle { background: #d3d8dd; }"
        "QSplitter::handle:horizontal { width: 1px; } QSplitter::handle:vertical { height: 1px; }"
        "QTreeWidget { background: #fcfdfd; } QTreeView::item { padding: 1px 0; }"));
}

} // namespace toile::ui
