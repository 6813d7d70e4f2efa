// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/DocumentFile.h"
#include "tests/Suite.h"

#include "core/io/ToileFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace toile;

/// Each document of samples/broken has one mistake, and one line says what and where it is.
class tst_CheckFile : public QObject {
    Q_OBJECT
private slots:
    void aBrokenDocumentGetsOneLine_data();
    void aBrokenDocumentGetsOneLine();
    void everyBrokenDocumentIsListed();
    void aFileOfAnUnknownKindIsRefused();
    void aFolderIsRefused();
    void anAvatarBesideTheDocumentIsFound();
    void aLineIsFoundByItsPath();
    void anErrorIsLocatedInItsDocument();
};

namespace {

QString brokenFolder() {
    return qEnvironmentVariable("TOILE_SOURCE_DIR") + "/samples/broken/";
}

struct Lines {
    QStringList lines;
    bool isRefused = false; ///< exit status 1
};

/// What `toile-cli check` prints, without the folder.
Lines checked(const QString& path) {
    const auto result = io::checkFile(path.toStdString());
    Lines out;
    const auto add = [&](const std::string& line) {
        out.lines += QString::fromStdString(line).remove(QFileInfo(path).path() + "/");
    };
    if (!result) add(toString(result.error()));
    else
        for (const auto& problem : result->problems) add(toString(problem));
    out.isRefused = !result || result->hasErrors();
    return out;
}

void writeText(const QString& path, const std::string& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text.data(), static_cast<qint64>(text.size()));
}

} // namespace

void tst_CheckFile::aBrokenDocumentGetsOneLine_data() {
    QTest::addColumn<bool>("isError");
    QTest::addColumn<QString>("line");
    QTest::newRow("another-format")
        << true << "another-format.toile:2: format: Expected \"toile\": this is not a Toile document.";
    QTest::newRow("clockwise") << true
                               << "clockwise.toile:32: pieces[0].vertices: piece \"Front\": The outline runs "
                                  "clockwise, but must run counter-clockwise seen from the right side of the cloth.";
    QTest::newRow("duplicate-key") << true << "duplicate-key.toile:24: the key \"spacing\" is given twice.";
    QTest::newRow("duplicate-piece")
        << true << "duplicate-piece.toile:46: pieces[1].id: piece \"Back\": The id \"front\" is given twice.";
    QTest::newRow("duplicate-point")
        << true << "duplicate-point.toile:36: pieces[0].vertices[3].id: piece \"Front\": The id \"v2\" is given twice.";
    QTest::newRow("edge-without-length") << true
                                         << "edge-without-length.toile:41: pieces[0].edges[2]: piece \"Front\": The "
                                            "edge \"waist\" has no length: its two points coincide.";
    QTest::newRow("fold-outside") << true
                                  << "fold-outside.toile:76: pieces[1].folds[0].between: piece \"Back\": The fold "
                                     "\"crease\" leaves the piece at (180.00, 400.00) mm.";
    QTest::newRow("free-along-weft")
        << true
        << "free-along-weft.toile:12: fabrics[0].shearStiffness: fabric \"Cotton\": A fabric that does not resist "
           "stretching along warp and weft cannot have a coupling of the two, nor shear stiffness if it is woven.";
    QTest::newRow("hardly-any-time-passes") << true
                                            << "hardly-any-time-passes.toile:94: scene.frameStep: Expected between "
                                               "0.0001 and 1 s, but found 1e-09.";
    QTest::newRow("hole-outside")
        << true << "hole-outside.toile:45: pieces[0].holes[0]: piece \"Front\": The hole lies outside the piece.";
    QTest::newRow("layer-too-high") << true
                                    << "layer-too-high.toile:49: pieces[1].layer: piece \"Back\": The layer is 1000, "
                                       "but must be from 0 to 100.";
    QTest::newRow("lengthening-elastic")
        << true
        << "lengthening-elastic.toile:76: seams[0].elastic.ratio: seam \"right side\": "
           "An elastic is shorter than its seam: its ratio is 1.2, but must be between "
           "0 and 1.";
    QTest::newRow("mirror-of-nothing")
        << true
        << "mirror-of-nothing.toile:76: pieces[2].mirror.source: piece \"Image\": There is no piece \"nobody\".";
    QTest::newRow("missing-avatar")
        << true << "missing-avatar.toile:94: avatar: There is no file \"nobody.glb\" beside the document.";
    QTest::newRow("missing-side") << true << "missing-side.toile:83: seams[1]: The key \"sideB\" is missing here.";
    QTest::newRow("nearly-equal-seam")
        << false
        << "nearly-equal-seam.toile:73: seams[0]: seam \"right side\": warning: Side A is 402.0 mm long and side B "
           "400.0 mm; 0.0 mm of ease are declared, 2.0 mm are left over.";
    QTest::newRow("negative-density") << true
                                      << "negative-density.toile:9: fabrics[0].arealDensity: fabric \"Cotton\": "
                                         "arealDensity is -0.15, but must be positive.";
    QTest::newRow("negative-spacing") << true
                                      << "negative-spacing.toile:49: pieces[1].spacing: piece \"Back\": The spacing is "
                                         "-20 mm, but must be a positive length.";
    QTest::newRow("newer-version") << true
                                   << "newer-version.toile:3: version: This document has version 2, but this program "
                                      "reads up to version 1: please use a newer program.";
    QTest::newRow("no-time-passes")
        << true << "no-time-passes.toile:94: scene.frameStep: Expected a number above 0, but found 0.";
    QTest::newRow("not-a-number") << true
                                  << "not-a-number.toile:34: this is not valid JSON: syntax error while parsing value "
                                     "- invalid literal; last read: '\"x\": N'.";
    QTest::newRow("not-json") << true
                              << "not-json.toile:1: this is not valid JSON: syntax error while parsing value - invalid "
                                 "literal; last read: 'A'.";
    QTest::newRow("number-for-a-list")
        << true << "number-for-a-list.toile:38: pieces[0].edges: Expected a list, but found a number.";
    QTest::newRow("number-too-large")
        << true << "number-too-large.toile:34: this is not valid JSON: number overflow parsing '3e999'.";
    QTest::newRow("out-of-measure") << true
                                    << "out-of-measure.toile:34: pieces[0].vertices[1].x: Expected a length in "
                                       "millimetres, but 3e+99 is out of all measure.";
    QTest::newRow("pinned-to-no-body")
        << false
        << "pinned-to-no-body.toile:95: pins[0].toBody: pin \"n1\": warning: The document "
           "has no avatar to which its cloth could be pinned: it stays where it lies.";
    QTest::newRow("pinned-twice") << true
                                  << "pinned-twice.toile:96: pins[1].vertex: pin \"n2\": The point \"v4\" of the piece "
                                     "\"Front\" is pinned twice.";
    QTest::newRow("region-outside") << true
                                    << "region-outside.toile:49: pieces[0].regions[0].outline: piece \"Front\": The "
                                       "region \"pocket\" lies outside the piece.";
    QTest::newRow("self-crossing") << true
                                   << "self-crossing.toile:66: pieces[1].edges[1]: piece \"Back\": The edges \"right\" "
                                      "and \"left\" cross or touch at (150.00, 200.00) mm.";
    QTest::newRow("sewn-twice") << true
                                << "sewn-twice.toile:97: seams[2].sideA[0]: seam \"again\": This stretch of the edge "
                                   "\"right\" is already sewn by the seam \"right side\".";
    QTest::newRow("softening-interfacing")
        << true
        << "softening-interfacing.toile:49: pieces[1].interfacing.bendingFactor: piece \"Back\": Interfacing makes "
           "cloth stiffer: its bendingFactor is 0.5, but must be 1 or more.";
    QTest::newRow("stretched-placement")
        << true
        << "stretched-placement.toile:26: pieces[0].placement.matrix: piece \"Front\": A placement moves and turns a "
           "piece, but does not stretch or mirror it.";
    QTest::newRow("tack-outside") << true
                                  << "tack-outside.toile:99: tacks[0].b.point: tack \"button\": A tack holds cloth: "
                                     "this point lies outside the piece \"Back\".";
    QTest::newRow("text-for-a-number")
        << true << "text-for-a-number.toile:34: pieces[0].vertices[1].x: Expected a number, but found a text.";
    QTest::newRow("truncated")
        << true
        << "truncated.toile:50: this is not valid JSON: syntax error while parsing object key - invalid string: "
           "missing closing quote; last read: '\"tablePosition'; expected string literal.";
    QTest::newRow("unequal-seam") << true
                                  << "unequal-seam.toile:73: seams[0]: seam \"right side\": Side A is 410.0 mm long "
                                     "and side B 400.0 mm; 0.0 mm of ease are declared, 10.0 mm are left over.";
    QTest::newRow("unknown-edge-in-seam") << true
                                          << "unknown-edge-in-seam.toile:80: seams[0].sideB[0].edge: seam \"right "
                                             "side\": The piece \"Back\" has no edge \"side\".";
    QTest::newRow("unknown-fabric")
        << true << "unknown-fabric.toile:48: pieces[1].fabric: piece \"Back\": There is no fabric \"silk\".";
    QTest::newRow("unknown-piece-in-seam") << true
                                           << "unknown-piece-in-seam.toile:80: seams[0].sideB[0].piece: seam \"right "
                                              "side\": There is no piece \"sleeve\".";
    QTest::newRow("walked-backwards")
        << true
        << "walked-backwards.toile:88: seams[1].sideA[1].reversed: seam \"left side\": The edge \"left\" is walked in "
           "the wrong direction: it does not lead on to the edge \"left\".";
    QTest::newRow("wrong-way-round") << false
                                     << "wrong-way-round.toile:73: seams[0]: seam \"right side\": warning: The seam "
                                        "joins the right side of one piece to the wrong side of the other: reverse it?";
}

void tst_CheckFile::aBrokenDocumentGetsOneLine() {
    QFETCH(bool, isError);
    QFETCH(QString, line);
    const Lines found = checked(brokenFolder() + QTest::currentDataTag() + ".toile");
    QCOMPARE(found.lines, QStringList{line});
    QCOMPARE(found.isRefused, isError);
}

void tst_CheckFile::everyBrokenDocumentIsListed() {
    QCOMPARE(QDir(brokenFolder()).entryList({"*.toile"}).size(), 41);
}

void tst_CheckFile::aFileOfAnUnknownKindIsRefused() {
    QTemporaryDir folder;
    writeText(folder.filePath("a.doc"), "x");
    QCOMPARE(checked(folder.filePath("a.doc")).lines,
             QStringList{
                 "a.doc: Files ending in \".doc\" cannot be read as a pattern: .toile and .json (GarmentCode) can."});
}

void tst_CheckFile::aFolderIsRefused() {
    QTemporaryDir folder;
    QVERIFY(!io::checkFile(folder.path().toStdString()));
}

void tst_CheckFile::anAvatarBesideTheDocumentIsFound() {
    QTemporaryDir folder;
    document::Document document;
    document.avatarFile = "bodies/woman.glb";
    QVERIFY(io::writeToile(document, folder.filePath("a.toile").toStdString()));
    QCOMPARE(checked(folder.filePath("a.toile")).lines.size(), 1);
    QVERIFY(QDir(folder.path()).mkdir("bodies"));
    writeText(folder.filePath("bodies/woman.glb"), "x");
    QCOMPARE(checked(folder.filePath("a.toile")).lines.size(), 0);
}

void tst_CheckFile::aLineIsFoundByItsPath() {
    const auto json = parseJson("{\n\"a\": [\n1,\n{\"b\":\n2}]}");
    QVERIFY(json);
    QCOMPARE(io::lineOf(*json, "a[0]"), 3);
    QCOMPARE(io::lineOf(*json, "a[1].b"), 5);
    QCOMPARE(io::lineOf(*json, "a[1].c"), 4); // there is no c: the object it would be in
    QCOMPARE(io::lineOf(*json, "a[7]"), 2);
    QCOMPARE(io::lineOf(*json, ""), 1);
}

void tst_CheckFile::anErrorIsLocatedInItsDocument() {
    const std::string file = (brokenFolder() + "negative-spacing.toile").toStdString();
    const auto located = [](const std::string& in, Place place) {
        return toString(io::locatedIn(in, {ErrorCode::invalidInput, "No.", std::move(place)}).place);
    };
    QCOMPARE(located(file, {.path = "pieces[1].spacing"}), file + ":49: pieces[1].spacing");
    QCOMPARE(located(file, {.object = "piece \"Back\""}), file + ": piece \"Back\"");
    QCOMPARE(located(file, {}), std::string());                                               // not about the document
    QCOMPARE(located(file, {.file = "drape.glb", .path = "a"}), std::string("drape.glb: a")); // but about another
    QCOMPARE(located("gone.toile", {.path = "a"}), std::string("gone.toile: a"));
    QTemporaryDir folder;
    const std::string foreign = folder.filePath("a.json").toStdString();
    writeText(QString::fromStdString(foreign), "{\"a\": 1}");
    QCOMPARE(located(foreign, {.path = "a"}), foreign + ": a");
}

TOILE_TEST(tst_CheckFile)
#include "tst_CheckFile.moc"
