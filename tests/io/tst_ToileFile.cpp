// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ToileFile.h"
#include "tests/Suite.h"

#include "tests/io/SampleDocument.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace toile;
using io::documentFromText;
using io::toileText;

class tst_ToileFile : public QObject {
    Q_OBJECT
private slots:
    void everyFieldComesBack();
    void textToValueToTextKeepsEveryByte();
    void theTextOfVersionOneStaysWhatItIs();
    void lengthsAreRoundedToAMillionthOfAMillimetre();
    void unknownKeysAreKept();
    void thereMayBeManyUnknownKeys();
    void aMistakeNamesFileLineAndPath_data();
    void aMistakeNamesFileLineAndPath();
    void aNewerVersionIsRefusedWithASentence();
    void idsOfAFileAreNeverGivenAgain();
    void savingAndReadingGivesTheDocumentAsWritten();
    void aNumberThatIsNotFiniteIsNotSaved();
    void aMissingFileIsAnError();
};

namespace {

std::string versionOneSample() {
    QFile file(qEnvironmentVariable("TOILE_SOURCE_DIR") + "/tests/io/versions/1.toile");
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    return at == std::string::npos ? std::string() : text.replace(at, what.size(), by);
}

} // namespace

void tst_ToileFile::everyFieldComesBack() {
    const document::Document document = tests::everyField();
    const auto again = documentFromText(toileText(document));
    QVERIFY2(again, again ? "" : toString(again.error()).c_str());
    QVERIFY(*again == *io::asWritten(document));
    // Angles pass through degrees and come back to a rounding error; everything else is on the file's grid.
    document::Document rounded = *again;
    pattern::Piece piece = *rounded.pattern.pieces[0];
    QVERIFY(std::abs(piece.grain - document.pattern.pieces[0]->grain) < 1e-11);
    piece.grain = document.pattern.pieces[0]->grain;
    piece.folds[0].angle = document.pattern.pieces[0]->folds[0].angle;
    rounded.pattern.pieces[0] = piece;
    rounded.pattern.seams[0].foldAngle = document.pattern.seams[0].foldAngle;
    QVERIFY(rounded == document);
}

void tst_ToileFile::textToValueToTextKeepsEveryByte() {
    const std::string text = toileText(tests::everyField());
    QCOMPARE(toileText(*documentFromText(text)), text);
}

void tst_ToileFile::theTextOfVersionOneStaysWhatItIs() {
    const std::string sample = versionOneSample();
    const auto document = documentFromText(sample);
    QVERIFY2(document, document ? "" : toString(document.error()).c_str());
    QCOMPARE(toileText(*document), sample);
    QVERIFY(*document == *io::asWritten(tests::everyField()));
}

void tst_ToileFile::lengthsAreRoundedToAMillionthOfAMillimetre() {
    document::Document document = tests::everyField();
    pattern::Piece piece = *document.pattern.pieces[0];
    piece.outline.vertices[1].position.x = 0.3000000004999; // [m]: 300.0000004999 mm
    document.pattern.pieces[0] = piece;
    const auto again = documentFromText(toileText(document));
    QCOMPARE(again->pattern.pieces[0]->outline.vertices[1].position.x, 0.3);
}

void tst_ToileFile::unknownKeysAreKept() {
    std::string text = toileText(tests::everyField());
    for (const char* place :
         {"\"format\": \"toile\"", "\"damping\": 0.7", "\"name\": \"Poplin\"", "\"name\": \"Front right\"",
          "\"name\": \"shoulder\"", "\"name\": \"centre front\"", "\"name\": \"top button\""})
        text = replaced(text, place, std::string(place) + ", \"colour\": {\"red\": 1}");
    const auto document = documentFromText(text);
    QVERIFY2(document, document ? "" : toString(document.error()).c_str());
    const std::string written = toileText(*document);
    QCOMPARE(QString::fromStdString(written).count("\"colour\": {"), 7);
    QCOMPARE(toileText(*documentFromText(written)), written);
}

void tst_ToileFile::thereMayBeManyUnknownKeys() {
    std::string keys;
    for (int i = 0; i < 100'000; ++i) keys += ", \"k" + std::to_string(i) + "\": 1"; // looked for one by one: minutes
    const std::string format = "\"format\": \"toile\"";
    const auto document = documentFromText(replaced(toileText(tests::everyField()), format, format + keys));
    QVERIFY2(document, document ? "" : toString(document.error()).c_str());
    QCOMPARE(document->unknown.asObject()->size(), std::size_t(100'000));
    QCOMPARE(QString::fromStdString(toileText(*document)).count("\n  \"k"), 100'000);
}

void tst_ToileFile::aMistakeNamesFileLineAndPath_data() {
    QTest::addColumn<QString>("was");
    QTest::addColumn<QString>("becomes");
    QTest::addColumn<int>("linesAbove"); // where the message points, seen from the mistake
    QTest::addColumn<QString>("message");
    QTest::newRow("a text for a number") << "\"x\": 300"
                                         << "\"x\": \"wide\"" << 0
                                         << "a.toile:%1: pieces[0].vertices[1].x: Expected a number, but found a text.";
    QTest::newRow("a key is missing") << "\"shape\": \"arc\""
                                      << "\"form\": \"arc\"" << 2
                                      << "a.toile:%1: pieces[0].edges[2]: The key \"shape\" is missing here.";
    QTest::newRow("a word that is not offered") << "\"kind\": \"castle\""
                                                << "\"kind\": \"fort\"" << 0
                                                << "a.toile:%1: pieces[0].notches[0].kind: Expected one of \"slit\", "
                                                   "\"v\", \"t\", \"castle\", but found \"fort\".";
    QTest::newRow("half a refinement")
        << "\"refinement\": 2"
        << "\"refinement\": 1.5" << 0
        << "a.toile:%1: pieces[0].regions[0].refinement: Expected a whole number from 0 to 16, but found 1.5.";
    QTest::newRow("a list too short")
        << "[0, 0, -1, 100]"
        << "[0, 0, -1]" << 0 << "a.toile:%1: pieces[0].placement.matrix[0]: Expected a list of 4, but found 3.";
}

void tst_ToileFile::aMistakeNamesFileLineAndPath() {
    QFETCH(QString, was);
    QFETCH(QString, becomes);
    QFETCH(int, linesAbove);
    QFETCH(QString, message);
    const std::string text = replaced(toileText(tests::everyField()), was.toStdString(), becomes.toStdString());
    QVERIFY(!text.empty());
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find(becomes.toStdString())), '\n');
    const auto document = documentFromText(text, "a.toile");
    QVERIFY(!document);
    QCOMPARE(QString::fromStdString(toString(document.error())), message.arg(line - linesAbove));
}

void tst_ToileFile::aNewerVersionIsRefusedWithASentence() {
    const auto document =
        documentFromText(replaced(toileText(tests::everyField()), "\"version\": 1", "\"version\": 2"));
    QVERIFY(!document);
    QCOMPARE(document.error().code, ErrorCode::unsupported);
    QVERIFY(document.error().text.find("newer program") != std::string::npos);
}

void tst_ToileFile::idsOfAFileAreNeverGivenAgain() {
    document::Document document = tests::everyField();
    document.nextId = 2; // the pattern uses v7 and e7
    QCOMPARE(documentFromText(toileText(document))->nextId, 8);
}

void tst_ToileFile::savingAndReadingGivesTheDocumentAsWritten() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("a.toile").toStdString();
    const document::Document document = tests::everyField();
    QVERIFY(io::writeToile(document, path));
    const auto again = io::readToile(path);
    QVERIFY2(again, again ? "" : toString(again.error()).c_str());
    QVERIFY(*again == *io::asWritten(document));
}

void tst_ToileFile::aNumberThatIsNotFiniteIsNotSaved() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("a.toile").toStdString();
    document::Document document = tests::everyField();
    document.pattern.seams[0].stiffnessFactor = std::numeric_limits<double>::quiet_NaN();
    const auto written = io::writeToile(document, path);
    QVERIFY(!written);
    QCOMPARE(written.error().place.path, std::string("seams[0].stiffnessFactor"));
    QVERIFY(!QFile::exists(QString::fromStdString(path)));
}

void tst_ToileFile::aMissingFileIsAnError() {
    const auto document = io::readToile("/nowhere/at/all.toile");
    QVERIFY(!document);
    QCOMPARE(document.error().code, ErrorCode::notFound);
}

TOILE_TEST(tst_ToileFile)
#include "tst_ToileFile.moc"
