// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QWidget>

#include <functional>
#include <vector>

namespace toile::ui {

/// One row of the table of actions.
struct ActionSpec {
    QString id; ///< in settings and tests: never translated
    QString text;
    QKeySequence shortcut = {};
    QString icon = {}; ///< name of a file in resources/icons
    bool checkable = false;
    std::function<void()> slot;
    QString tip = {};
    QString shortText = {}; ///< on buttons that show text; empty = text
};

/// The text of an action without its mnemonic and dots.
[[nodiscard]] QString plainText(const QString& actionText);

/// The actions of a window by their ids. A user's own shortcuts are kept in the settings, group "shortcuts".
class Actions {
public:
    /// Makes the actions as children of the window. Each begins with what is being typed there.
    void add(QWidget& window, const std::vector<ActionSpec>& table);

    [[nodiscard]] QAction* operator[](const QString& id) const;
    [[nodiscard]] const std::vector<QAction*>& all() const { return inOrder_; }
    [[nodiscard]] QKeySequence defaultShortcut(const QString& id) const { return defaults_.value(id); }
    /// From now on, also in the next window; empty = none.
    void setShortcut(const QString& id, const QKeySequence& shortcut);

    /// Whether it can be done now: whyNot is empty, or becomes its tip.
    void allow(const QString& id, const QString& whyNot);
    /// Of the action that these keys would trigger if it could be done now: what it is, and why it can't be. Else
    /// empty.
    [[nodiscard]] QString whyNot(const QKeySequence& keys) const;

    /// The actions of these ids; "-" is a separator.
    void fill(QWidget& menuOrBar, const QStringList& ids) const;

private:
    QHash<QString, QAction*> byId_;
    QHash<QString, QKeySequence> defaults_;
    std::vector<QAction*> inOrder_;
};

} // namespace toile::ui
