// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/Workbench.h"

#include <QTreeWidget>

#include <vector>

namespace toile::ui {

/// One line of the object list.
struct ObjectLine {
    Item item;
    QString text, icon;
    int level = 0; ///< 0 = below a group, 1 = below the line before (regions of a piece)
    friend bool operator==(const ObjectLine&, const ObjectLine&) = default;
};
struct ObjectGroup {
    QString title;
    std::vector<ObjectLine> lines;
    friend bool operator==(const ObjectGroup&, const ObjectGroup&) = default;
};

/// Everything in a document that has a name, in groups.
[[nodiscard]] std::vector<ObjectGroup> objectsOf(const document::Document& document);

/// Pieces with their regions, seams, fabrics, avatar and scene; selects what is clicked.
class ObjectList : public QTreeWidget {
    Q_OBJECT
public:
    explicit ObjectList(Workbench& workbench, QWidget* parent = nullptr);

private:
    void refresh();
    void showSelection();
    void takeSelection();

    Workbench& workbench_;
    std::vector<ObjectGroup> groups_;
    std::vector<std::pair<QTreeWidgetItem*, Item>> lines_;
    bool showing_ = false;
};

} // namespace toile::ui
