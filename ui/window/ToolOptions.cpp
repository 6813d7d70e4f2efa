// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ToolOptions.h"

#include "ui/values/Units.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>

namespace toile::ui {
namespace {

/// Shows a length and changes it.
QDoubleSpinBox* lengthBox(const char* name, double low, double high, double& length) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(low, high);
    box->setDecimals(0);
    box->setSuffix(formatOf(Quantity::length).suffix);
    box->setValue(shown(Quantity::length, length));
    QObject::connect(box, &QDoubleSpinBox::valueChanged, box,
                     [&length](double value) { length = fromShown(Quantity::length, value); });
    return box;
}

QWidget* inARow(std::initializer_list<QWidget*> widgets) {
    auto* part = new QWidget;
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : widgets) row->addWidget(widget);
    return part;
}

} // namespace

ToolOptions::ToolOptions(ToolBox& tools, QWidget* parent) : QWidget(parent), tools_(tools) {
    setObjectName(QStringLiteral("toolOptions"));
    name_ = new QLabel;
    QFont bold = name_->font();
    bold.setBold(true);
    name_->setFont(bold);
    hint_ = new QLabel;
    hint_->setObjectName(QStringLiteral("toolHint"));
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    paintPart_ = makePaintPart();
    dartPart_ = makeDartPart();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 10, 4);
    layout->setSpacing(10);
    layout->addWidget(name_);
    layout->addWidget(hint_, 1);
    layout->addWidget(paintPart_);
    layout->addWidget(dartPart_);
}

QWidget* ToolOptions::makePaintPart() {
    auto* refinement = new QComboBox;
    refinement->setObjectName(QStringLiteral("paintRefinement"));
    for (int m = 0; m <= 5; ++m) refinement->addItem(m == 0 ? tr("main spacing") : tr("1/%1 of main").arg(1 << m), m);
    refinement->setCurrentIndex(tools_.paint.refinement);
    refinement->setToolTip(tr("Spacing of the region: ε_m/2^m"));
    connect(refinement, &QComboBox::activated, this, [this](int m) { tools_.paint.refinement = m; });
    radius_ = lengthBox("brushRadius", 2, 300, tools_.paint.radius);
    radius_->setToolTip(tr("Radius of the brush; Ctrl and the wheel change it as well"));
    return inARow({new QLabel(tr("Spacing")), refinement, new QLabel(tr("Brush")), radius_});
}

QWidget* ToolOptions::makeDartPart() {
    QDoubleSpinBox* width = lengthBox("dartWidth", 1, 300, tools_.dart.width);
    width->setToolTip(tr("Width of the dart's mouth, along the edge"));
    return inARow({new QLabel(tr("Width")), width});
}

void ToolOptions::show(const ToolBox::Entry& tool) {
    name_->setText(tool.text);
    hintText_ = tool.tool->hint();
    hint_->setToolTip(hintText_);
    paintPart_->setVisible(tool.uses == ToolBox::Uses::paintOptions);
    dartPart_->setVisible(tool.uses == ToolBox::Uses::dartOptions);
    layout()->activate();
    elide();
    const QSignalBlocker quiet(radius_);
    radius_->setValue(shown(Quantity::length, tools_.paint.radius));
}

void ToolOptions::elide() {
    hint_->setText(hint_->fontMetrics().elidedText(hintText_, Qt::ElideRight, hint_->width()));
}

} // namespace toile::ui
