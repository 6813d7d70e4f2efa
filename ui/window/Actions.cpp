// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Actions.h"

#include "core/base/Contracts.h"
#include "ui/window/TakeTyped.h"

#include <QIcon>
#include <QRegularExpression>
#include <QSettings>

namespace toile::ui {
namespace {

const QString settingsGroup = QStringLiteral("shortcuts/");

/// What a button says when the pointer rests on it.
void showTip(QAction& action) {
    const QKeySequence shortcut = action.shortcut();
    const QString text = action.data().toString();
    action.setToolTip(
        shortcut.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, shortcut.toString(QKeySequence::NativeText)));
}

} // namespace

QString plainText(const QString& actionText) {
    static const QRegularExpression mnemonic(
        QStringLiteral("\\(&.\\)|&|…")); // Chinese has it in brackets, behind the word
    return QString(actionText).remove(mnemonic);
}

void Actions::add(QWidget& window, const std::vector<ActionSpec>& table) {
    const QSettings settings;
    for (const ActionSpec& spec : table) {
        auto* action = new QAction(spec.text, &window);
        action->setObjectName(spec.id);
        defaults_.insert(spec.id, spec.shortcut);
        action->setShortcut(QKeySequence(settings.value(settingsGroup + spec.id, spec.shortcut.toString()).toString()));
        action->setData(spec.tip.isEmpty() ? plainText(spec.text) : spec.tip);
        showTip(*action);
        if (!spec.shortText.isEmpty()) action->setIconText(spec.shortText);
        if (!spec.icon.isEmpty()) action->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(spec.icon)));
        action->setCheckable(spec.checkable);
        if (spec.slot)
            QObject::connect(action, &QAction::triggered, &window, [&window, slot = spec.slot] {
                takeTyped(window);
                slot();
            });
        window.addAction(action);
        byId_.insert(spec.id, action);
        inOrder_.push_back(action);
    }
}

void Actions::setShortcut(const QString& id, const QKeySequence& shortcut) {
    QAction& action = *(*this)[id];
    action.setShortcut(shortcut);
    if (action.isEnabled()) showTip(action);
    QSettings settings;
    if (shortcut == defaultShortcut(id)) settings.remove(settingsGroup + id);
    else settings.setValue(settingsGroup + id, shortcut.toString());
}

void Actions::allow(const QString& id, const QString& whyNot) {
    QAction& action = *(*this)[id];
    if (action.isEnabled() == whyNot.isEmpty() && (whyNot.isEmpty() || action.toolTip() == whyNot)) return;
    action.setEnabled(whyNot.isEmpty());
    if (whyNot.isEmpty()) showTip(action);
    else action.setToolTip(whyNot);
}

QString Actions::whyNot(const QKeySequence& keys) const {
    for (const QAction* action : inOrder_)
        if (!action->isEnabled() && action->shortcut() == keys)
            return QStringLiteral("%1: %2").arg(plainText(action->text()), action->toolTip());
    return {};
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
