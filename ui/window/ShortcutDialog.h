// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/Actions.h"

#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QTreeWidget;

namespace toile::ui {

/// Lets the user choose the keys of every action. Keys that another action has are taken from it, after a
/// word of warning; nothing changes before OK.
class ShortcutDialog : public QDialog {
    Q_OBJECT
public:
    explicit ShortcutDialog(Actions& actions, QWidget* parent = nullptr);

    void accept() override;

private:
    [[nodiscard]] QString selectedId() const;
    [[nodiscard]] QString userOf(const QKeySequence& keys, const QString& butNot) const;
    void showSelected();
    void choose(const QKeySequence& keys);
    void restoreDefaults();
    void fillKeys();

    Actions& actions_;
    QHash<QString, QKeySequence> chosen_; ///< by the action's id
    QTreeWidget* list_;
    QKeySequenceEdit* keys_;
    QLabel* remark_;
};

} // namespace toile::ui
