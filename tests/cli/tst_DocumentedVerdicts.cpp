// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/cli/Program.h"

#include <QMap>
#include <QTemporaryDir>
#include <algorithm>

using namespace toile;

namespace {

/// A row of the study's results.jsonl.
struct Record {
    QString which, verdict; ///< which: S12
};

QString textOf(const Json& json, const char* key) {
    const Json* found = json.find(key);
    const std::string* text = found ? found->asString() : nullptr;
    return text ? QString::fromStdString(*text) : QString();
}

/// Runs the quick study; empty where it did not end with 0 or, as one whose rows fall short, with 3.
QList<Record> study() {
    const QTemporaryDir folder;
    const int status = run({"study", "stability", "--quick", "--out", folder.path()}, 10 * minutes).status;
    if (status != 0 && status != 3) return {};
    QList<Record> records;
    for (const QByteArray& line : contentOf(folder.filePath("results.jsonl")).split('\n')) {
        if (line.isEmpty()) continue;
        const Json json = jsonOf(line);
        records << Record{textOf(json, "case"), textOf(json, "verdict")};
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

/// The verdicts that docs/stability.md gives are those that the study comes to.
class tst_DocumentedVerdicts : public QObject {
    Q_OBJECT
private slots:
    void extremeInputsComeOutAsThePageSays();
};

void tst_DocumentedVerdicts::extremeInputsComeOutAsThePageSays() {
    const QStringList order{"PASS", "PASS-WARN", "REFUSED", "FAIL"};
    const QString text = page("stability.md");
    const QList<Record> records = study();
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

TOILE_TEST(tst_DocumentedVerdicts, QCoreApplication)
#include "tst_DocumentedVerdicts.moc"
