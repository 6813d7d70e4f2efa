// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "tests/Suite.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <set>

using namespace toile;

namespace {

using Keys = std::set<QString>;

/// The keys in the first columns of the tables of a page.
Keys documentedKeys(const QString& page) {
    const QString text =
        QString::fromUtf8(contentOf(qEnvironmentVariable("TOILE_SOURCE_DIR") + "/docs/formats/" + page));
    static const QRegularExpression firstColumn("^\\| `([^`]+)` \\|", QRegularExpression::MultilineOption);
    Keys keys;
    for (auto found = firstColumn.globalMatch(text); found.hasNext();) keys.insert(found.next().captured(1));
    return keys;
}

/// Every value of a report under the name the pages give it; objects and lists of objects are gone into.
void collect(const Json& value, const QString& name, Keys& keys) {
    if (const Json::Object* members = value.asObject()) {
        for (const auto& [key, member] : *members)
            collect(member, name.isEmpty() ? QString::fromStdString(key) : name + "." + QString::fromStdString(key),
                    keys);
    } else if (const Json::Array* items = value.asArray(); items && !items->empty() && items->front().asObject()) {
        for (const Json& item : *items) collect(item, name + "[]", keys);
    } else {
        keys.insert(name);
    }
}

QString difference(const Keys& a, const Keys& b) {
    QStringList only;
    for (const QString& key : a)
        if (!b.contains(key)) only << key;
    return only.join(", ");
}

/// Keys of pieces and of the total stand once on the page, without their owner.
Keys withoutOwner(const Keys& keys) {
    Keys bare;
    for (QString key : keys) {
        if (key.startsWith("pieces[].")) key.remove(0, 9);
        if (key.startsWith("total.")) key.remove(0, 6);
        if (key != "regions" && key != "folds") bare.insert(key); // a piece without them
    }
    return bare;
}

} // namespace

/// What the programs write is what the pages say, both ways.
class tst_ReportFormats : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }
    void sewJsonIsAsItsPageSays();
    void meshJsonIsAsItsPageSays();

private:
    [[nodiscard]] Keys keysOf(const QStringList& command) const {
        const QString file = folder_.filePath("report.json");
        run(command + QStringList{"--report", file});
        Keys keys;
        collect(jsonOf(contentOf(file)), "", keys);
        return keys;
    }
    /// The two squares, the left one folded.
    [[nodiscard]] QString folded() const {
        QByteArray text = contentOf(sample("two-squares.toile"));
        const QByteArray id = "\"id\": \"left\",";
        text.replace(text.indexOf(id), id.size(),
                     id + "\"folds\": [{\"id\": \"l1\", \"from\": {\"edge\": \"left.bottom\", \"position\": 0.5}, "
                          "\"to\": {\"edge\": \"left.top\", \"position\": 0.5}, \"foldAngleDegrees\": 90}],");
        const QString path = folder_.filePath("folded.toile");
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("cannot write");
        return path;
    }
    QTemporaryDir folder_;
};

void tst_ReportFormats::sewJsonIsAsItsPageSays() {
    const Keys documented = documentedKeys("sew.md");
    QVERIFY(documented.size() > 50);
    // Coarse and short: the garment need not be finished, but has openings, stages, things left out and warnings.
    Keys written = keysOf({"sew", sample("blouse.toile"), "--spacing", "40", "--seconds", "0.5", "--quiet"});
    written.erase("tacks"); // the blouse has none; the band has
    for (const QString& key : keysOf({"sew", sample("buttoned-band.toile"), "--seconds", "0.1", "--quiet"}))
        if (key.startsWith("tacks[]")) written.insert(key);
    written.erase("folds");
    for (const QString& key : keysOf({"sew", folded(), "--seconds", "0.1", "--quiet"}))
        if (key.startsWith("folds[]")) written.insert(key);
    written.erase("motion");
    for (const QString& key :
         keysOf({"sew", sample("sheet-two-corners.toile"), "--spacing", "100", "--limit", "0.1", "--avatar",
                 sample("bodies/mannequin-42.glb"), "--lift-arms", "20", "--lift-time", "0.1", "--quiet"}))
        if (key.startsWith("motion.")) written.insert(key);
    written.erase("frames");
    for (const QString& key : keysOf({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames",
                                      folder_.filePath("frames.pc2"), "--quiet"}))
        if (key.startsWith("frames.")) written.insert(key);
    QCOMPARE(difference(documented, written), QString());
    QCOMPARE(difference(written, documented), QString());
}

void tst_ReportFormats::meshJsonIsAsItsPageSays() {
    Keys documented = documentedKeys("mesh.md");
    QVERIFY(documented.size() > 30);
    for (const char* owner : {"pieces[]", "total"}) QCOMPARE(documented.erase(owner), std::size_t(1));
    Keys written = withoutOwner(keysOf({"mesh", sample("blouse.toile")}));
    for (const QString& key : withoutOwner(keysOf({"mesh", folded()})))
        if (key.startsWith("folds[]")) written.insert(key);
    QCOMPARE(difference(documented, written), QString());
    QCOMPARE(difference(written, documented), QString());
}

TOILE_TEST(tst_ReportFormats, QCoreApplication)
#include "tst_ReportFormats.moc"
