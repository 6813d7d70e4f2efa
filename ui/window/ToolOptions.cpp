// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ToolOptions.h"

#include "ui/values/Units.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>

namespace toile::ui {

ToolOptions::ToolOptions(PaintOptions& paint, QWidget* parent) : QWidget(parent), paint_(paint) {
    setObjectName(QStringLiteral("toolOptions"));
    name_ = new QLabel;
    QFont bold = name_->font();
    bold.setBold(true);
    name_->setFont(bold);
    hint_ = new QLabel;
    hint_->setObjectName(QStringLiteral("toolHint"));
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    hint_->setForegroundRole(QPalette::PlaceholderText);

    refinement_ = new QComboBox;
    refinement_->setObjectName(QStringLiteral("paintRefinement"));
    for (int m = 0; m <= 5; ++m) refinement_->addItem(m == 0 ? tr("main spacing") : tr("1/%1 of main").arg(1 << m), m);
    refinement_->setCurrentIndex(paint.refinement);
    refinement_->setToolTip(tr("Spacing of the region: ε_m/2^m"));
    connect(refinement_, &QComboBox::activated, this, [this](int m) { paint_.refinement = m; });

    radius_ = new QDoubleSpinBox;
    radius_->setObjectName(QStringLiteral("brushRadius"));
    radius_->setRange(2, 300);
    radius_->setDecimals(0);
    radius_->setSuffix(formatOf(Quantity::length).suffix);
    radius_->setToolTip(tr("Radius of the brush; Ctrl and the wheel change it as well"));
    connect(radius_, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { paint_.radius = fromShown(Quantity::length, value); });

    paintPart_ = new QWidget;
    auto* row = new QHBoxLayout(paintPart_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(tr("Spacing")));
    row->addWidget(refinement_);
    row->addWidget(new QLabel(tr("Brush")));
    row->addWidget(radius_);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 10, 4);
    layout->setSpacing(10);
    layout->addWidget(name_);
    layout->addWidget(hint_, 1);
    layout->addWidget(paintPart_);
    setMinimumHeight(34);
}

void ToolOptions::show(const QString& name, const QString& hint, bool paints) {
    name_->setText(name);
    hintText_ = hint;
    hint_->setToolTip(hint);
    paintPart_->setVisible(paints);
    layout()->activate();
    elide();
    const QSignalBlocker quiet(radius_);
    radius_->setValue(shown(Quantity::length, paint_.radius));
}

void ToolOptions::elide() {
    hint_->setText(hint_->fontMetrics().elidedText(hintText_, Qt::ElideRight, hint_->width()));
}

} // namespace toile::ui
