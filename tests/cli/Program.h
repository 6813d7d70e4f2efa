// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "tests/base/Pages.h"

#include <QDir>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTest>

namespace toile {

/// What a run of toile-cli left behind.
struct Finished {
    int status = -1; ///< −1: it did not end by itself
    QString out, err;

    [[nodiscard]] QStringList errorLines() const { return err.split('\n', Qt::SkipEmptyParts); }
};

inline QString program() {
    return qEnvironmentVariable("TOILE_BINARY_DIR") + "/bin/toile-cli";
}
inline QString sample(const QString& name) {
    return qEnvironmentVariable("TOILE_SOURCE_DIR") + "/samples/" + name;
}

inline constexpr int minutes = 60000; // [ms]

inline Finished run(const QStringList& arguments, int patience = 120000 /* [ms] */) {
    QProcess process;
    process.start(program(), arguments);
    if (!process.waitForFinished(patience)) return {-1, {}, process.errorString()};
    const bool ended = process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

/// The lines of a page's code blocks that run this command, without the program's name.
inline QList<QStringList> commandsIn(const QString& text, const QString& command) {
    QList<QStringList> found;
    for (const QString& line : text.split('\n'))
        if (line.startsWith("toile-cli " + command)) found << QProcess::splitCommand(line).mid(1);
    return found;
}

/// Null when it is no JSON.
inline Json jsonOf(const QByteArray& text) {
    auto json = parseJson(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
    return json ? std::move(*json) : Json();
}

/// The keys of `names` that an object lacks, for messages; empty when it has all.
inline QString missingKeys(const Json& object, const QStringList& names) {
    QStringList missing;
    for (const QString& name : names)
        if (!object.find(name.toStdString())) missing << name;
    return missing.join(", ");
}

} // namespace toile
