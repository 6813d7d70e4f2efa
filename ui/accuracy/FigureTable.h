// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

namespace toile::ui {

/// A table to be read, of texts and numbers; one line can be chosen.
class FigureTable : public QTableWidget {
    Q_OBJECT
public:
    /// Columns from firstNumber to before endOfNumbers stand at the right.
    FigureTable(const char* name, const QStringList& columns, int firstNumber, int endOfNumbers);

    void setLine(int row, const QStringList& cells, bool bold = false);

private:
    [[nodiscard]] Qt::Alignment alignmentOf(int column) const;

    int firstNumber_, endOfNumbers_;
};

} // namespace toile::ui
