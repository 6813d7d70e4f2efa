// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/PaintRegion.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace toile::ui {

/// The bar above the pattern: what to do next, and the options of the tool in use.
class ToolOptions : public QWidget {
    Q_OBJECT
public:
    explicit ToolOptions(PaintOptions& paint, QWidget* parent = nullptr);

    void show(const QString& name, const QString& hint, bool paints);

protected:
    void resizeEvent(QResizeEvent*) override { elide(); }

private:
    void elide(); ///< as much of the hint as there is room for

    PaintOptions& paint_;
    QString hintText_;
    QLabel *name_, *hint_;
    QWidget* paintPart_;
    QComboBox* refinement_;
    QDoubleSpinBox* radius_;
};

} // namespace toile::ui
