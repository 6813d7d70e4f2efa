// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace toile::ui {

/// Asks for a folder of poses and how fast the avatar goes through them; says what is in it. Both are kept in the
/// settings for the next time.
class MotionDialog : public QDialog {
    Q_OBJECT
public:
    explicit MotionDialog(QWidget* parent = nullptr);

    [[nodiscard]] QString folder() const;
    [[nodiscard]] double step() const; ///< from pose to pose [s]

    void accept() override;

private:
    void choose();
    void showFolder();

    QLineEdit* folder_;
    QDoubleSpinBox* rate_;
    QLabel* found_;
    QDialogButtonBox* buttons_;
};

} // namespace toile::ui
