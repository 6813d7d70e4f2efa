// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h" // first: moc 6.4 stumbles over <compare> as the first header

#include "core/io/BodyImport.h"
#include "core/io/GarmentCodeFile.h"
#include "core/io/ToileFile.h"
#include "core/simulation/Arrange.h"
#include "samples/MadeToMeasure.h"

using namespace toile;
using namespace toile::simulation;

namespace {

/// A file of the test data; empty when there are none.
std::string dataFile(const std::string& path) {
    const QString folder = qEnvironmentVariable("TOILE_TEST_DATA");
    return folder.isEmpty() ? std::string() : folder.toStdString() + "/" + path;
}

/// A woman whose arms hang obliquely, bent at the elbow, shorter than the mannequin's.
body::Body woman() {
    auto body = io::readBody(dataFile("bodies/mh_female_bust98.glb"), {}, nullptr);
    if (!body) qFatal("%s", toString(body.error()).c_str());
    return std::move(*body);
}

SewReport sewnOn(const body::Body& body, pattern::Pattern arranged, double seconds) {
    return sewnFor(seconds, {std::move(arranged), Shared<body::Body>(body), {}});
}

pattern::Pattern imported(const std::string& name) {
    auto read = io::readGarmentCode(dataFile("patterns/freesewing/" + name + "_sewable_specification.json"));
    if (!read) qFatal("%s", toString(read.error()).c_str());
    return std::move(read->document.pattern);
}

const std::vector<std::string> ofAShirt{"left arm", "neck", "right arm", "torso"};

} // namespace

/// Garments on a body that is not ours, and patterns that are not ours on it.
class tst_RealBodies : public QObject {
    Q_OBJECT
private slots:
    void init();
    void theBlouseOfTheMannequinIsSewnOnAnotherBody();
    void theBlouseMadeToMeasureIsWorn();
    void importedPatternsAreSewn_data();
    void importedPatternsAreSewn();
};

void tst_RealBodies::init() {
    if (!dataFile("").empty()) return;
    std::puts("NOT RUN: needs TOILE_TEST_DATA (a folder with bodies/*.glb and patterns/freesewing/*.json)");
    QSKIP("NOT RUN: needs TOILE_TEST_DATA");
}

void tst_RealBodies::theBlouseOfTheMannequinIsSewnOnAnotherBody() {
    const body::Body body = woman();
    const SewReport report = sewnOn(body, arrangedOn(blouseAt(0.020), mannequin().body, body), 7);
    for (const SeamResult& seam : report.seams) QVERIFY2(seam.state.merged, seam.state.name.c_str());
    QCOMPARE(openingsOf(report), ofAShirt);
    QCOMPARE(report.worn->turnedLength, 0.0);
    QVERIFY(report.worn->rightSideOut >= 0.99);
    QVERIFY(report.contact.bodyPenetrationMaximum == 0);
}

/// As the two commands do it: drafted into a file, and sewn from there.
void tst_RealBodies::theBlouseMadeToMeasureIsWorn() {
    const body::Body body = woman();
    const auto drafted = samples::blouseMadeToMeasure(body);
    QVERIFY2(drafted, drafted ? "" : toString(drafted.error()).c_str());
    const QTemporaryDir folder;
    const std::string file = folder.filePath("blouse.toile").toStdString();
    QVERIFY(io::writeToile(*drafted, file));
    const auto document = io::readToile(file);
    QVERIFY(document);
    auto simulation = Simulation::create({document->pattern, Shared<body::Body>(body), document->scene});
    QVERIFY(simulation);
    const auto report = sew(*simulation, {});
    QVERIFY(report);
    for (const SeamResult& seam : report->seams) {
        QVERIFY2(seam.state.merged, seam.state.name.c_str());
        QVERIFY(seam.state.gapAtMerge <= 0.5e-3);
    }
    QVERIFY(report->atRest && *report->residual <= 1e-3);
    QVERIFY(report->contact.outsideBody);
    QCOMPARE(openingsOf(*report), ofAShirt);
    QVERIFY2(report->worn->worn, reasonsOf(*report).c_str());
}

void tst_RealBodies::importedPatternsAreSewn_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("seams");
    QTest::newRow("a T-shirt") << "teagan_tshirt" << 20;
    QTest::newRow("trousers") << "titan_trousers" << 10;
    QTest::newRow("a shirt with yoke, collar stand and cuffs") << "simone_shirt" << 59;
}

void tst_RealBodies::importedPatternsAreSewn() {
    QFETCH(QString, name);
    QFETCH(int, seams);
    const body::Body body = woman();
    const SewReport report = sewnOn(body, startingClearOf(imported(name.toStdString()), body), 7);
    QCOMPARE(static_cast<int>(report.seams.size()), seams);
    for (const SeamResult& seam : report.seams) QVERIFY2(seam.state.merged, seam.state.name.c_str());
    QCOMPARE(report.worn->turnedLength, 0.0);
}

QTEST_APPLESS_MAIN(tst_RealBodies)
#include "tst_RealBodies.moc"
