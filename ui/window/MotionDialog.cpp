// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/MotionDialog.h"

#include "core/io/BodyPoses.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

namespace toile::ui {
namespace {

const QString folderKey = QStringLiteral("motion/folder");
const QString rateKey = QStringLiteral("motion/posesPerSecond");

QString nameOf(const std::filesystem::path& file) {
    return QString::fromStdString(file.filename().string());
}

} // namespace

MotionDialog::MotionDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("motionDialog"));
    setWindowTitle(tr("Move the avatar through poses"));
    auto* what =
        new QLabel(tr("A folder with a model of the avatar for each pose. They are taken in the order of their "
                      "names; the first is the avatar as it stands."));
    what->setWordWrap(true);
    folder_ = new QLineEdit(QSettings().value(folderKey).toString());
    folder_->setObjectName(QStringLiteral("motionFolder"));
    auto* choose = new QPushButton(tr("&Choose…"));
    choose->setObjectName(QStringLiteral("motionChoose"));
    choose->setAutoDefault(false);
    rate_ = new QDoubleSpinBox;
    rate_->setObjectName(QStringLiteral("motionRate"));
    rate_->setRange(0.1, 1000);
    rate_->setDecimals(1);
    rate_->setValue(QSettings().value(rateKey, 30).toDouble());
    found_ = new QLabel;
    found_->setObjectName(QStringLiteral("motionFound"));
    found_->setWordWrap(true);
    found_->setMinimumHeight(2 * found_->fontMetrics().height());
    buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Move"));
    auto* chosen = new QHBoxLayout;
    chosen->addWidget(folder_, 1);
    chosen->addWidget(choose);
    auto* form = new QFormLayout(this);
    form->addRow(what);
    form->addRow(tr("&Folder"), chosen);
    qobject_cast<QLabel*>(form->labelForField(chosen))->setBuddy(folder_);
    form->addRow(tr("&Poses a second"), rate_);
    form->addRow(found_);
    form->addRow(buttons_);
    connect(choose, &QPushButton::clicked, this, &MotionDialog::choose);
    connect(folder_, &QLineEdit::textChanged, this, &MotionDialog::showFolder);
    connect(rate_, &QDoubleSpinBox::valueChanged, this, &MotionDialog::showFolder);
    connect(buttons_, &QDialogButtonBox::accepted, this, &MotionDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &MotionDialog::reject);
    showFolder();
    resize(520, sizeHint().height());
}

QString MotionDialog::folder() const {
    return folder_->text();
}

double MotionDialog::step() const {
    return 1 / rate_->value();
}

void MotionDialog::accept() {
    QSettings settings;
    settings.setValue(folderKey, folder());
    settings.setValue(rateKey, rate_->value());
    QDialog::accept();
}

void MotionDialog::choose() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of poses"), this->folder());
    if (!folder.isEmpty()) folder_->setText(folder);
}

/// What is in it, or why there is no motion in it.
void MotionDialog::showFolder() {
    const auto poses = io::posesIn(folder().toStdString());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(poses.has_value());
    const bool isWrong = !poses && !folder().isEmpty();
    found_->setStyleSheet(isWrong ? QStringLiteral("color: #b02a2a;") : QString());
    if (poses)
        found_->setText(tr("%1 poses in %2 s: %3 … %4")
                            .arg(poses->size())
                            .arg(step() * static_cast<double>(poses->size() - 1), 0, 'f', 2)
                            .arg(nameOf(poses->front()), nameOf(poses->back())));
    else found_->setText(isWrong ? QString::fromStdString(poses.error().text) : QString());
}

} // namespace toile::ui
