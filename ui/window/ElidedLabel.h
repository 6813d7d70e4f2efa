// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace toile::ui {

/// One line that takes what room there is: as much of its text as fits, and all of it, in its lines, as a tool tip.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    void show(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace toile::ui
