// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ToolOptions.h"

#include "ui/values/Units.h"
#include "ui/window/ElidedLabel.h"

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
    hint_ = new ElidedLabel;
    hint_->setObjectName(QStringLiteral("toolHint"));
    hint_->setForegroundRole(QPalette::PlaceholderText);
    paintPart_ = makePaintPart();
    brushPart_ = inARow({new QLabel(tr("Brush")), radius_});
    dartPart_ = makeDartPart();
    auto* options = new QHBoxLayout;
    options->setSpacing(10);
    options->addWidget(name_);
    options->addStretch(1);
    for (QWidget* part : {paintPart_, brushPart_, dartPart_}) options->addWidget(part);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 3, 10, 3);
    layout->setSpacing(1);
    layout->addLayout(options);
    layout->addWidget(hint_);
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
    return inARow({new QLabel(tr("Spacing")), refinement});
}

QWidget* ToolOptions::makeDartPart() {
    QDoubleSpinBox* width = lengthBox("dartWidth", 1, 300, tools_.dart.width);
    width->setToolTip(tr("Width of the dart's mouth, along the edge"));
    return inARow({new QLabel(tr("Width")), width});
}

void ToolOptions::show(const ToolBox::Entry& tool) {
    name_->setText(tool.text);
    hint_->show(tool.tool->hint());
    paintPart_->setVisible(tool.uses == ToolBox::Uses::spacing || tool.uses == ToolBox::Uses::brush);
    brushPart_->setVisible(tool.uses == ToolBox::Uses::brush);
    dartPart_->setVisible(tool.uses == ToolBox::Uses::dart);
    const QSignalBlocker quiet(radius_);
    radius_->setValue(shown(Quantity::length, tools_.paint.radius));
}

} // namespace toile::ui
