// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Actions.h"

#include "core/base/Contracts.h"

#include <QIcon>
#include <QSettings>

namespace toile::ui {

void Actions::add(QWidget& window, const std::vector<ActionSpec>& table) {
    QSettings settings;
    settings.beginGroup(QStringLiteral("shortcuts"));
    for (const ActionSpec& spec : table) {
        auto* action = new QAction(spec.text, &window);
        action->setObjectName(spec.id);
        const QKeySequence shortcut(settings.value(spec.id, spec.shortcut.toString()).toString());
        action->setShortcut(shortcut);
        QString tip = spec.tip.isEmpty() ? QString(spec.text).remove(QLatin1Char('&')) : spec.tip;
        if (!shortcut.isEmpty()) tip += QStringLiteral(" (%1)").arg(shortcut.toString(QKeySequence::NativeText));
        action->setToolTip(tip);
        if (!spec.icon.isEmpty()) action->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(spec.icon)));
        action->setCheckable(spec.checkable);
        if (spec.slot) QObject::connect(action, &QAction::triggered, &window, [slot = spec.slot] { slot(); });
        window.addAction(action);
        byId_.insert(spec.id, action);
        inOrder_.push_back(action);
    }
}

QAction* Actions::operator[](const QString& id) const {
    QAction* action = byId_.value(id);
    expects(action, "an action of this id");
    return action;
}

void Actions::fill(QWidget& menuOrBar, const QStringList& ids) const {
    for (const QString& id : ids) {
        if (id != QLatin1String("-")) {
            menuOrBar.addAction((*this)[id]);
            continue;
        }
        auto* separator = new QAction(&menuOrBar);
        separator->setSeparator(true);
        menuOrBar.addAction(separator);
    }
}

} // namespace toile::ui
