// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/Program.h"

#include <QRegularExpression>

/// What the pages of the documentation say: tables, and the commands that make them.
namespace toile {

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

/// The lines of the page's code blocks that run this command, without the program's name.
inline QList<QStringList> commandsIn(const QString& text, const QString& command) {
    QList<QStringList> found;
    for (const QString& line : text.split('\n'))
        if (line.startsWith("toile-cli " + command)) found << QProcess::splitCommand(line).mid(1);
    return found;
}

} // namespace toile
