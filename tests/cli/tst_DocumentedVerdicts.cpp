// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/Pages.h"

#include <QMap>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

using namespace toile;

namespace {

constexpr int minutes = 60000; // [ms]

/// A row of a study's results.jsonl.
struct Record {
    QString which, title, what, verdict; ///< which: V5, S12
    double expected = NAN, measured = NAN;
};

QString textOf(const Json& json, const char* key) {
    const Json* found = json.find(key);
    const std::string* text = found ? found->asString() : nullptr;
    return text ? QString::fromStdString(*text) : QString();
}

/// Runs a study into a folder of its own; empty where it did not end with 0 or, as one whose rows fall short, with 3.
QList<Record> study(const QStringList& arguments) {
    const QTemporaryDir folder;
    const int status = run(QStringList{"study"} + arguments + QStringList{"--out", folder.path()}, 10 * minutes).status;
    if (status != 0 && status != 3) return {};
    QList<Record> records;
    for (const QByteArray& line : contentOf(folder.filePath("results.jsonl")).split('\n')) {
        if (line.isEmpty()) continue;
        const Json json = jsonOf(line);
        const auto number = [&](const char* key) {
            const Json* found = json.find(key);
            return found && found->asNumber() ? *found->asNumber() : double(NAN);
        };
        const Record record{textOf(json, "case"),    textOf(json, "title"), textOf(json, "what"),
                            textOf(json, "verdict"), number("expected"),    number("measured")};
        if (record.verdict != "not offered") records << record;
    }
    return records;
}

/// "5 PASS, 1 PASS-WARN", or "PASS" of one row; `order` says which verdict is named first.
QString countsOf(const QList<Record>& records, const QStringList& order) {
    QStringList parts;
    for (const QString& verdict : order) {
        const auto count = std::ranges::count(records, verdict, &Record::verdict);
        if (count > 0) parts << (records.size() == 1 ? verdict : QString("%1 %2").arg(count).arg(verdict));
    }
    return parts.join(", ");
}

QMap<QString, QList<Record>> byCase(const QList<Record>& records) {
    QMap<QString, QList<Record>> cases;
    for (const Record& record : records) cases[record.which] << record;
    return cases;
}

} // namespace

/// The verdicts that docs/validation.md and docs/stability.md give are those that the studies come to.
class tst_DocumentedVerdicts : public QObject {
    Q_OBJECT
private slots:
    void casesWithKnownAnswersComeOutAsThePageSays();
    void extremeInputsComeOutAsThePageSays();
};

void tst_DocumentedVerdicts::casesWithKnownAnswersComeOutAsThePageSays() {
    const QString text = page("validation.md");
    const QList<Record> records = study({"validation"});
    const auto passed = std::ranges::count(records, QString("PASS"), &Record::verdict);
    QVERIFY2(text.contains(QString("**%1 of %2 rows pass.").arg(passed).arg(records.size())),
             qPrintable(QString("%1 of %2 rows pass").arg(passed).arg(records.size())));
    const auto rows = tableIn(text, "case | | rows");
    qsizetype told = 0;
    for (const QStringList& row : rows) {
        if (row[6] == "not offered") continue;
        told += row[2].toInt();
        // row: case, title, count, "worst row: expected", measured, tolerance, verdict
        QList<Record> own;
        for (const Record& record : records)
            if (record.which == row[0] && record.title == row[1]) own << record;
        const QByteArray name = (row[0] + " " + row[1]).toUtf8();
        QVERIFY2(own.size() == row[2].toInt(), name);
        const auto failed = std::ranges::count(own, QString("FAIL"), &Record::verdict);
        QVERIFY2(row[6] == (failed ? QString("FAIL: %1 of %2").arg(failed).arg(own.size()) : "PASS"), name);
        const qsizetype colon = row[3].lastIndexOf(": ");
        const QString what = row[3].left(colon).replace("\\|", "|"), expected = row[3].mid(colon + 2);
        const bool isBound =
            expected.startsWith("≤"); // what is bounded is often rounding, which processors do differently
        const auto worst =
            std::ranges::find_if(own, [&](const Record& record) { // rows "the same" differ in what is expected
                return record.what == what &&
                       (isBound || std::abs(record.expected - expected.toDouble()) <= 1e-5 * std::abs(record.expected));
            });
        QVERIFY2(worst != own.end(), name);
        if (isBound) continue;
        const double written = row[4].toDouble(), allowed = 0.1 * row[5].toDouble() * std::abs(expected.toDouble());
        QVERIFY2(std::abs(worst->measured - written) <= std::max(allowed, 1e-5 * std::abs(written)),
                 name + ": " + QByteArray::number(worst->measured));
    }
    QCOMPARE(told, records.size()); // no case is left out
}

void tst_DocumentedVerdicts::extremeInputsComeOutAsThePageSays() {
    const QStringList order{"PASS", "PASS-WARN", "REFUSED", "FAIL"};
    const QString text = page("stability.md");
    const QList<Record> records = study({"stability", "--quick"});
    QStringList totals;
    for (const QString& verdict : order)
        totals << QString("%1 %2").arg(std::ranges::count(records, verdict, &Record::verdict)).arg(verdict);
    QVERIFY2(text.contains("**" + totals.join(", ")), qPrintable(totals.join(", ")));
    const auto rows = tableIn(text, "case | | rows");
    auto cases = byCase(records);
    for (const QStringList& row : rows) {
        const QString found = countsOf(cases.take(row[0]), order);
        QVERIFY2(found == row[2], qPrintable(row[0] + ": " + found));
    }
    QCOMPARE(cases.keys(), QStringList()); // no case is left out
}

QTEST_GUILESS_MAIN(tst_DocumentedVerdicts)
#include "tst_DocumentedVerdicts.moc"
