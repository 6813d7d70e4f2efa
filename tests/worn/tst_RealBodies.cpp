// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h" // first: moc 6.4 stumbles over <compare> as the first header
#include "tests/Suite.h"

#include "core/io/BodyImport.h"
#include "core/io/GarmentCodeFile.h"
#include "core/io/ToileFile.h"
#include "core/simulation/Arrange.h"
#include "samples/MadeToMeasure.h"

using namespace toile;
using namespace toile::simulation;

namespace {

const std::vector<std::string> ofAShirt{"left arm", "neck", "right arm", "torso"};

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

/// As after it is written into a file and read again.
document::Document throughAFile(const document::Document& document) {
    const QTemporaryDir folder;
    const std::string file = folder.filePath("document.toile").toStdString();
    if (!io::writeToile(document, file)) qFatal("the document could not be written");
    auto read = io::readToile(file);
    if (!read) qFatal("%s", toString(read.error()).c_str());
    return std::move(*read);
}

/// Until it is at rest.
SewReport sewnToRest(const body::Body& body, const pattern::Pattern& arranged, const SceneSettings& settings) {
    return sewn({arranged, Shared<body::Body>(body), settings});
}

void verifyIsWorn(const SewReport& report) {
    for (const SeamResult& seam : report.seams) {
        QVERIFY2(seam.state.merged, seam.state.name.c_str());
        QVERIFY(seam.state.gapAtMerge <= 0.5e-3);
    }
    QVERIFY(report.atRest && *report.residual <= 1e-3);
    QVERIFY(report.contact.outsideBody);
    QCOMPARE(openingsOf(report), ofAShirt);
    QVERIFY2(report.worn->worn, reasonsOf(report).c_str());
}

/// Of the nodes of a piece from the mirror images of its mirror image's, in the mean [m]. Both are meshed alike.
double meanMirrorDistance(const Simulation& simulation, const std::string& left, const std::string& right) {
    const auto& pieces = simulation.scene().pattern.pieces;
    const auto firstNodeOf = [&](const std::string& id) {
        const auto found = std::ranges::find_if(pieces, [&](const auto& piece) { return piece->id.value == id; });
        return simulation.garment().particles.firstNode[static_cast<std::size_t>(found - pieces.begin())];
    };
    const int first = firstNodeOf(left), image = firstNodeOf(right), count = image - first;
    const std::vector<Vec3> nodes = simulation.nodePositions();
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += geometry::distance({-nodes[first + i].x, nodes[first + i].y, nodes[first + i].z}, nodes[image + i]);
    return sum / count;
}

pattern::Pattern imported(const std::string& name) {
    auto read = io::readGarmentCode(dataFile("patterns/freesewing/" + name + "_sewable_specification.json"));
    if (!read) qFatal("%s", toString(read.error()).c_str());
    return std::move(read->document.pattern);
}

} // namespace

/// Garments on a body that is not ours, and patterns that are not ours on it.
class tst_RealBodies : public QObject {
    Q_OBJECT
private slots:
    void init();
    void theBlouseOfTheMannequinIsWornOnAnotherBody();
    void sleevesOnBentArmsFoldAlike();
    void theBlouseMadeToMeasureIsWorn();
    void importedPatternsAreSewn_data();
    void importedPatternsAreSewn();
    void importedTrousersAreSewnWithTheirLayersApart();
};

void tst_RealBodies::init() {
    if (!dataFile("").empty()) return;
    std::puts("NOT RUN: needs TOILE_TEST_DATA (a folder with bodies/*.glb and patterns/freesewing/*.json)");
    QSKIP("NOT RUN: needs TOILE_TEST_DATA");
}

/// toile-cli sew samples/blouse.toile --avatar mh_female_bust98.glb --until-rest
void tst_RealBodies::theBlouseOfTheMannequinIsWornOnAnotherBody() {
    const body::Body body = woman();
    const document::Document blouse =
        throughAFile(samples::blouse(blouseWearer().measurements, blouseWearer().body).value());
    verifyIsWorn(sewnToRest(body, arrangedOn(blouse.pattern, blouseWearer().body, body), blouse.scene));
}

/// In the bend of an elbow cloth must fold, and how it does must not be chance: folds that differ left and right draw
/// the whole garment askew.
void tst_RealBodies::sleevesOnBentArmsFoldAlike() {
    const body::Body body = woman();
    samples::BlouseSettings easy{.bicepsEase = 0.07};
    easy.block.bustEase = easy.block.hipEase = 0.12;
    const document::Document blouse =
        throughAFile(samples::blouse(mannequin().measurements, mannequin().body, easy).value());
    auto simulation = Simulation::create(
        {arrangedOn(blouse.pattern, mannequin().body, body), Shared<body::Body>(body), blouse.scene});
    QVERIFY(simulation);
    while (simulation->state().time < 1.5) QVERIFY(simulation->advance());
    const double apart = meanMirrorDistance(*simulation, "sleeve-left", "sleeve-right");
    QVERIFY2(apart < 0.002, qPrintable(QString("%1 mm").arg(1000 * apart)));
}

/// As the two commands do it: drafted into a file, and sewn from there.
void tst_RealBodies::theBlouseMadeToMeasureIsWorn() {
    const body::Body body = woman();
    const auto drafted = samples::blouseMadeToMeasure(body);
    QVERIFY2(drafted, drafted ? "" : toString(drafted.error()).c_str());
    const document::Document blouse = throughAFile(*drafted);
    verifyIsWorn(sewnToRest(body, blouse.pattern, blouse.scene));
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

/// Their fronts are drawn beside each other and overlap at the crotch, and so do their backs.
void tst_RealBodies::importedTrousersAreSewnWithTheirLayersApart() {
    const body::Body body = woman();
    Scene scene{startingClearOf(imported("titan_trousers"), body), Shared<body::Body>(body), {}};
    scene.settings.selfContact = true;
    const SewReport report = sewnFor(5, std::move(scene));
    for (const SeamResult& seam : report.seams) QVERIFY2(seam.state.merged, seam.state.name.c_str());
    QCOMPARE(report.contact.selfIntersections, 0);
    QCOMPARE(report.contact.bodyIntersections, 0);
}

TOILE_TEST(tst_RealBodies)
#include "tst_RealBodies.moc"
