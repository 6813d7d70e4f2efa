// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/ToolBox.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace toile::ui {

class ElidedLabel;

/// The bar above the pattern: what to do next, and the options of the tool in use.
class ToolOptions : public QWidget {
    Q_OBJECT
public:
    explicit ToolOptions(ToolBox& tools, QWidget* parent = nullptr);

    void show(const ToolBox::Entry& tool);

private:
    [[nodiscard]] QWidget* makePaintPart();
    [[nodiscard]] QWidget* makeDartPart();

    ToolBox& tools_;
    QLabel* name_;
    ElidedLabel* hint_;
    QWidget *paintPart_, *brushPart_, *dartPart_;
    QDoubleSpinBox* radius_;
};

} // namespace toile::ui
