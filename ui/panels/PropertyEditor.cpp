// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/PropertyEditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace toile::ui {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};

/// Rows of two sheets can share their widgets.
bool sameShape(const PropertySheet& a, const PropertySheet& b) {
    return a.title == b.title && std::ranges::equal(a.rows, b.rows, [](const PropertyRow& x, const PropertyRow& y) {
               return x.name == y.name && x.label == y.label && x.content.index() == y.content.index();
           });
}

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    label->setContentsMargins(0, 8, 0, 2);
    return label;
}

int decimalsFor(const NumberRow& row) {
    const int decimals = formatOf(row.quantity).decimals;
    return row.step < 1 && row.quantity == Quantity::length ? std::max(decimals, 2) : decimals;
}

} // namespace

PropertyEditor::PropertyEditor(Workbench& workbench, QWidget* parent) : QScrollArea(parent), workbench_(workbench) {
    setObjectName(QStringLiteral("propertyEditor"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(&workbench, &Workbench::documentChanged, this, [this] { refresh(); });
    connect(&workbench, &Workbench::selectionChanged, this, [this] { refresh(); });
    connect(&workbench, &Workbench::meshChanged, this, [this] { refresh(Rows::facts); });
    sheet_ = sheetOf(workbench.desk(), workbench.meshReport());
    rebuild();
}

void PropertyEditor::refresh(Rows rows) {
    PropertySheet next = sheetOf(workbench_.desk(), workbench_.meshReport());
    const bool same = sameShape(sheet_, next), ofTheSameKind = sheet_.title == next.title;
    sheet_ = std::move(next);
    if (same) return fillIn(rows);
    const int scrolledTo = ofTheSameKind ? verticalScrollBar()->value() : 0;
    const QString focused = ofTheSameKind ? focusedRow() : QString();
    rebuild();
    if (auto* field = focused.isEmpty() ? nullptr : widget()->findChild<QWidget*>(focused)) field->setFocus();
    verticalScrollBar()->setValue(scrolledTo);
}

/// The name of the row that has the focus; empty = none.
QString PropertyEditor::focusedRow() const {
    const auto focused = std::ranges::find_if(widgets_, &QWidget::hasFocus);
    return focused == widgets_.end() ? QString() : (*focused)->objectName();
}

void PropertyEditor::rebuild() {
    filling_ = true; // widgets that lose the focus now would write into rows that are no longer theirs
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(10, 8, 10, 10);
    form->setHorizontalSpacing(10);
    form->setVerticalSpacing(5);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(heading(sheet_.title));
    widgets_.clear();
    for (std::size_t row = 0; row < sheet_.rows.size(); ++row) {
        const PropertyRow& property = sheet_.rows[row];
        if (std::holds_alternative<HeadingRow>(property.content)) {
            widgets_.push_back(heading(property.label));
            form->addRow(widgets_.back());
            continue;
        }
        QWidget* widget = widgetFor(row);
        widget->setObjectName(property.name);
        widget->setToolTip(property.tip);
        widgets_.push_back(widget);
        if (property.label.isEmpty() || std::holds_alternative<ActionRow>(property.content)) form->addRow(widget);
        else form->addRow(property.label, widget);
    }
    if (QWidget* old = takeWidget()) { // it may be the sender of the signal we are in
        old->hide();
        old->deleteLater();
    }
    setWidget(page);
    fillIn(Rows::all);
}

QWidget* PropertyEditor::widgetFor(std::size_t row) {
    const auto change = [this, row](auto set) {
        return [this, row, set](auto... value) {
            if (filling_ || row >= sheet_.rows.size()) return;
            apply(row, set(sheet_.rows[row], value...));
        };
    };
    return std::visit(
        Overloaded{
            [&](const NumberRow& number) -> QWidget* {
                auto* box = new QDoubleSpinBox;
                const UnitFormat format = formatOf(number.quantity);
                const double a = shown(number.quantity, number.low), b = shown(number.quantity, number.high);
                box->setDecimals(decimalsFor(number));
                box->setRange(std::min(a, b), std::max(a, b));
                box->setSingleStep(number.step);
                box->setSuffix(format.suffix);
                box->setSpecialValueText(number.lowest);
                box->setKeyboardTracking(false);
                box->setAccelerated(true);
                leaveTheWheel(*box);
                connect(box, &QDoubleSpinBox::valueChanged, this, change([this](const PropertyRow& p, double value) {
                            const auto& content = std::get<NumberRow>(p.content);
                            return content.set(workbench_.document(), fromShown(content.quantity, value));
                        }));
                return box;
            },
            [&](const TextRow&) -> QWidget* {
                auto* edit = new QLineEdit;
                connect(edit, &QLineEdit::editingFinished, this, change([this, edit](const PropertyRow& p) {
                            return std::get<TextRow>(p.content).set(workbench_.document(), edit->text());
                        }));
                return edit;
            },
            [&](const ChoiceRow& choice) -> QWidget* {
                auto* box = new QComboBox;
                box->addItems(choice.choices);
                box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
                leaveTheWheel(*box);
                connect(box, &QComboBox::activated, this, change([this](const PropertyRow& p, int index) {
                            return std::get<ChoiceRow>(p.content).set(workbench_.document(), index);
                        }));
                return box;
            },
            [&](const FlagRow&) -> QWidget* {
                auto* box = new QCheckBox;
                connect(box, &QCheckBox::toggled, this, change([this](const PropertyRow& p, bool on) {
                            return std::get<FlagRow>(p.content).set(workbench_.document(), on);
                        }));
                return box;
            },
            [&](const FactRow&) -> QWidget* {
                auto* label = new QLabel;
                label->setTextInteractionFlags(Qt::TextSelectableByMouse);
                label->setWordWrap(true);
                return label;
            },
            [&](const ActionRow&) -> QWidget* {
                auto* button = new QPushButton(sheet_.rows[row].label);
                connect(button, &QPushButton::clicked, this, [this, row] {
                    if (row >= sheet_.rows.size()) return;
                    const PropertyRow& p = sheet_.rows[row];
                    take(effectOf(p.label, std::get<ActionRow>(p.content), workbench_.document()));
                });
                return button;
            },
            [&](const HeadingRow&) -> QWidget* { return nullptr; },
        },
        sheet_.rows[row].content);
}

/// The wheel scrolls the sheet, not the value under the pointer, unless its field was chosen.
void PropertyEditor::leaveTheWheel(QWidget& field) {
    field.setFocusPolicy(Qt::StrongFocus);
    field.installEventFilter(this);
}

bool PropertyEditor::eventFilter(QObject* watched, QEvent* event) {
    const auto field = std::ranges::find(widgets_, watched);
    if (event->type() != QEvent::Wheel || field == widgets_.end() || (*field)->hasFocus())
        return QScrollArea::eventFilter(watched, event);
    event->ignore(); // the next to get it is the sheet
    return true;
}

/// The sheet's values into the widgets, without a change of the document.
void PropertyEditor::fillIn(Rows rows) {
    filling_ = true;
    for (std::size_t row = 0; row < widgets_.size(); ++row) {
        if (rows == Rows::facts && !std::holds_alternative<FactRow>(sheet_.rows[row].content)) continue;
        QWidget* widget = widgets_[row];
        std::visit(Overloaded{
                       [&](const NumberRow& number) {
                           static_cast<QDoubleSpinBox*>(widget)->setValue(shown(number.quantity, number.value));
                       },
                       [&](const TextRow& text) {
                           auto* edit = static_cast<QLineEdit*>(widget);
                           if (edit->text() != text.text) edit->setText(text.text);
                       },
                       [&](const ChoiceRow& choice) {
                           auto* box = static_cast<QComboBox*>(widget);
                           if (box->count() != choice.choices.size()) {
                               box->clear();
                               box->addItems(choice.choices);
                           }
                           for (int i = 0; i < choice.choices.size(); ++i) box->setItemText(i, choice.choices[i]);
                           box->setCurrentIndex(choice.current);
                       },
                       [&](const FlagRow& flag) { static_cast<QCheckBox*>(widget)->setChecked(flag.on); },
                       [&](const FactRow& fact) {
                           auto* label = static_cast<QLabel*>(widget);
                           label->setText(fact.text);
                           label->setStyleSheet(fact.isProblem ? QStringLiteral("color: #b02a2a;") : QString());
                       },
                       [](const ActionRow&) {},
                       [](const HeadingRow&) {},
                   },
                   sheet_.rows[row].content);
    }
    filling_ = false;
}

void PropertyEditor::apply(std::size_t row, const DocumentResult& result) {
    const PropertyRow& property = sheet_.rows[row];
    const QString name = property.label.isEmpty() ? sheet_.title : property.label;
    take(effectOf(name, result));
}

void PropertyEditor::take(const Effect& effect) {
    if (effect.edit && effect.edit->after == workbench_.document()) return;
    workbench_.take(effect);
    if (!effect.edit) refresh(); // back to what holds
}

} // namespace toile::ui
