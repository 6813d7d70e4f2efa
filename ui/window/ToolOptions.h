// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/ToolBox.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace toile::ui {

/// The bar above the pattern: what to do next, and the options of the tool in use.
class ToolOptions : public QWidget {
    Q_OBJECT
public:
    explicit ToolOptions(ToolBox& tools, QWidget* parent = nullptr);

    void show(const ToolBox::Entry& tool);

protected:
    void resizeEvent(QResizeEvent*) override { elide(); }

private:
    [[nodiscard]] QWidget* makePaintPart();
    [[nodiscard]] QWidget* makeDartPart();
    void elide(); ///< as much of the hint as there is room for

    ToolBox& tools_;
    QString hintText_;
    QLabel *name_, *hint_;
    QWidget *paintPart_, *dartPart_;
    QDoubleSpinBox* radius_;
};

} // namespace toile::ui
