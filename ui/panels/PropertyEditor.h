// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/PropertySheet.h"
#include "ui/workbench/Workbench.h"

#include <QScrollArea>

class QFormLayout;
class QLabel;

namespace toile::ui {

/// Shows the sheet of what is selected. Each change is one step of the document; widgets hold nothing themselves and
/// are made anew when the sheet's shape changes; a sheet of the same kind stays scrolled, with the focus where it was.
class PropertyEditor : public QScrollArea {
    Q_OBJECT
public:
    explicit PropertyEditor(Workbench& workbench, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A mesh changes facts only, and comes while something may be being typed into a field.
    enum class Rows { all, facts };

    void refresh(Rows rows = Rows::all);
    void rebuild();
    void fillIn(Rows rows);
    [[nodiscard]] QString focusedRow() const;
    [[nodiscard]] QWidget* widgetFor(std::size_t row);
    void leaveTheWheel(QWidget& field);
    void apply(std::size_t row, const DocumentResult& result);
    void take(const Effect& effect);

    Workbench& workbench_;
    PropertySheet sheet_;
    std::vector<QWidget*> widgets_; ///< by row of the sheet
    bool filling_ = false;
};

} // namespace toile::ui
