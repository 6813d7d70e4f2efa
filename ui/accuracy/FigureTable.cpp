// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/FigureTable.h"

#include <QHeaderView>

namespace toile::ui {

FigureTable::FigureTable(const char* name, const QStringList& columns, int firstNumber, int endOfNumbers)
    : QTableWidget(0, static_cast<int>(columns.size())), firstNumber_(firstNumber), endOfNumbers_(endOfNumbers) {
    setObjectName(QLatin1String(name));
    setHorizontalHeaderLabels(columns);
    QFont small = font();
    small.setPointSizeF(0.9 * small.pointSizeF());
    setFont(small);
    horizontalHeader()->setFont(small);
    horizontalHeader()->setStretchLastSection(endOfNumbers_ < columnCount());
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(20);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setMinimumSize(200, 80);
    for (int column = 0; column < columnCount(); ++column)
        horizontalHeaderItem(column)->setTextAlignment(alignmentOf(column));
}

Qt::Alignment FigureTable::alignmentOf(int column) const {
    const bool isNumber = column >= firstNumber_ && column < endOfNumbers_;
    return (isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
}

void FigureTable::setLine(int row, const QStringList& cells, bool bold) {
    for (int column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setTextAlignment(alignmentOf(column));
        QFont font = item->font();
        font.setBold(bold);
        item->setFont(font);
        item->setToolTip(cells[column]);
        setItem(row, column, item);
    }
}

} // namespace toile::ui
