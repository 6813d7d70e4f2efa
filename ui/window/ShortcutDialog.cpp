// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ShortcutDialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace toile::ui {

ShortcutDialog::ShortcutDialog(Actions& actions, QWidget* parent) : QDialog(parent), actions_(actions) {
    setObjectName(QStringLiteral("shortcutDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    resize(460, 560);
    list_ = new QTreeWidget;
    list_->setObjectName(QStringLiteral("shortcutList"));
    list_->setRootIsDecorated(false);
    list_->setHeaderLabels({tr("Command"), tr("Keys")});
    for (const QAction* action : actions.all()) {
        auto* line = new QTreeWidgetItem(list_, {plainText(action->text())});
        line->setIcon(0, action->icon());
        line->setData(0, Qt::UserRole, action->objectName());
        chosen_.insert(action->objectName(), action->shortcut());
    }
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setStretchLastSection(false);
    list_->setColumnWidth(1, 140);
    fillKeys();
    keys_ = new QKeySequenceEdit;
    keys_->setObjectName(QStringLiteral("shortcutKeys"));
    auto* none = new QPushButton(tr("None"));
    auto* standard = new QPushButton(tr("Default"));
    remark_ = new QLabel;
    remark_->setObjectName(QStringLiteral("shortcutRemark"));
    remark_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(keys_, 1);
    row->addWidget(none);
    row->addWidget(standard);
    auto* buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list_, 1);
    layout->addLayout(row);
    layout->addWidget(remark_);
    layout->addWidget(buttons);
    connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutDialog::showSelected);
    connect(keys_, &QKeySequenceEdit::editingFinished, this, [this] { choose(keys_->keySequence()); });
    connect(none, &QPushButton::clicked, this, [this] { choose({}); });
    connect(standard, &QPushButton::clicked, this, [this] { choose(actions_.defaultShortcut(selectedId())); });
    connect(buttons, &QDialogButtonBox::accepted, this, &ShortcutDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ShortcutDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            &ShortcutDialog::restoreDefaults);
    list_->setCurrentItem(list_->topLevelItem(0));
}

void ShortcutDialog::accept() {
    for (const QAction* action : actions_.all())
        if (const QKeySequence keys = chosen_.value(action->objectName()); keys != action->shortcut())
            actions_.setShortcut(action->objectName(), keys);
    QDialog::accept();
}

QString ShortcutDialog::selectedId() const {
    return list_->currentItem() ? list_->currentItem()->data(0, Qt::UserRole).toString() : QString();
}

QString ShortcutDialog::userOf(const QKeySequence& keys, const QString& butNot) const {
    for (auto each = chosen_.begin(); each != chosen_.end(); ++each)
        if (!keys.isEmpty() && each.value() == keys && each.key() != butNot) return each.key();
    return {};
}

void ShortcutDialog::showSelected() {
    keys_->setKeySequence(chosen_.value(selectedId()));
    remark_->clear();
}

void ShortcutDialog::choose(const QKeySequence& keys) {
    const QString id = selectedId();
    if (id.isEmpty() || chosen_.value(id) == keys) return;
    const QString former = userOf(keys, id);
    if (!former.isEmpty()) chosen_[former] = {};
    chosen_[id] = keys;
    fillKeys();
    showSelected();
    if (!former.isEmpty())
        remark_->setText(tr("%1 was “%2”, which has no keys now.")
                             .arg(keys.toString(QKeySequence::NativeText), plainText(actions_[former]->text())));
}

void ShortcutDialog::restoreDefaults() {
    for (auto each = chosen_.begin(); each != chosen_.end(); ++each)
        each.value() = actions_.defaultShortcut(each.key());
    fillKeys();
    showSelected();
}

void ShortcutDialog::fillKeys() {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* line = list_->topLevelItem(i);
        line->setText(1, chosen_.value(line->data(0, Qt::UserRole).toString()).toString(QKeySequence::NativeText));
    }
}

} // namespace toile::ui
