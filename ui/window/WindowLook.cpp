// SPDX-License-Identifier: GPL-3.0-or-later
// What the next window finds as the last one left it: sizes, the panel below the views, what is shown in the views.
#include "ui/window/MainWindow.h"

#include <QSettings>
#include <QSplitter>

namespace toile::ui {
namespace {

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

/// Of a splitter or an action, by its name.
QString keyOf(const QObject& part) {
    return QStringLiteral("window/") + part.objectName();
}

QList<QSplitter*> splittersOf(const MainWindow& window) {
    QList<QSplitter*> named = window.findChildren<QSplitter*>();
    named.removeIf([](const QSplitter* splitter) { return splitter->objectName().isEmpty(); });
    return named;
}

/// Whether something is shown in one of the views.
bool isLook(const QAction& action) {
    return action.objectName().startsWith(QLatin1String("look"));
}

} // namespace

void MainWindow::keepLook() const {
    QSettings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(stateKey, saveState());
    for (const QSplitter* splitter : splittersOf(*this)) settings.setValue(keyOf(*splitter), splitter->saveState());
    for (const QAction* action : actions_.all())
        if (isLook(*action)) settings.setValue(keyOf(*action), action->isChecked());
}

void MainWindow::restoreLook() {
    const QSettings settings;
    resize(1500, 920); // of the very first
    restoreGeometry(settings.value(geometryKey).toByteArray());
    restoreState(settings.value(stateKey).toByteArray());
    for (QSplitter* splitter : splittersOf(*this))
        splitter->restoreState(settings.value(keyOf(*splitter)).toByteArray());
    for (QAction* action : actions_.all())
        if (isLook(*action) && settings.value(keyOf(*action), action->isChecked()).toBool() != action->isChecked())
            action->trigger();
}

} // namespace toile::ui
