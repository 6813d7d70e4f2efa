// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QRegularExpression>
#include <QString>
#include <QStringList>

/// What the pages of the documentation say in their tables.
namespace toile {

/// Empty when there is no such file.
inline QByteArray contentOf(const QString& file) {
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

/// A page of docs/.
inline QString page(const QString& name) {
    return QString::fromUtf8(contentOf(qEnvironmentVariable("TOILE_SOURCE_DIR") + "/docs/" + name));
}

inline QStringList cellsOf(const QString& line) {
    static const QRegularExpression wall(R"((?<!\\)\|)"); // "\|" stands for itself
    QStringList cells = line.split(wall);
    cells.removeFirst();
    cells.removeLast();
    for (QString& cell : cells) cell = cell.trimmed();
    return cells;
}

/// The rows below the heading row that begins with this cell or these cells; none where there is no such table.
inline QList<QStringList> tableIn(const QString& text, const QString& heading) {
    const QStringList lines = text.split('\n');
    QList<QStringList> rows;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (!lines[i].startsWith("| " + heading + " |")) continue;
        for (i += 2; i < lines.size() && lines[i].startsWith('|'); ++i) rows << cellsOf(lines[i]);
        break;
    }
    return rows;
}

} // namespace toile
