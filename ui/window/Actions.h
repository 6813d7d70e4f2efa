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
};

/// The actions of a window by their ids. A user's own shortcuts come from the settings, group "shortcuts".
class Actions {
public:
    /// Makes the actions as children of the window.
    void add(QWidget& window, const std::vector<ActionSpec>& table);

    [[nodiscard]] QAction* operator[](const QString& id) const;
    [[nodiscard]] const std::vector<QAction*>& all() const { return inOrder_; }
    /// The actions of these ids; "-" is a separator.
    void fill(QWidget& menuOrBar, const QStringList& ids) const;

private:
    QHash<QString, QAction*> byId_;
    std::vector<QAction*> inOrder_;
};

} // namespace toile::ui
