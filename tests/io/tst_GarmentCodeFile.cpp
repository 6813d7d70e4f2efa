// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/GarmentCodeFile.h"
#include "tests/Suite.h"

#include "core/pattern/PatternCheck.h"
#include "core/pattern/PatternMeasures.h"

#include <QDir>
#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::pattern;
using io::garmentCodeFromText;

class tst_GarmentCodeFile : public QObject {
    Q_OBJECT
private slots:
    void panelsBecomePiecesInMetres();
    void aClockwisePanelIsTurnedOverInPlace();
    void anglesAreReadAsZTimesYTimesX();
    void stitchesJoinEndToStart();
    void quadraticCurvesKeepTheirCourse();
    void circlesBulgeToTheSideTheySay();
    void unequalEdgesAreSewnWithEase();
    void aMistakeNamesItsPlace_data();
    void aMistakeNamesItsPlace();
    void extremeNumbersAreRefused_data();
    void extremeNumbersAreRefused();
    void realFilesAreRead_data();
    void realFilesAreRead();
};

namespace {

/// Two rectangles 20 × 30 cm side on side, the back one clockwise behind the front one.
QString twoPanels() {
    return R"({"pattern": {"panels": {
 "front": {"vertices": [[0,0],[20,0],[20,30],[0,30]], "translation": [-10,100,20], "rotation": [0,0,0],
  "edges": [{"endpoints":[0,1]}, {"endpoints":[1,2]}, {"endpoints":[2,3]}, {"endpoints":[3,0]}]},
 "back": {"vertices": [[0,0],[0,30],[20,30],[20,0]], "translation": [-10,100,-20], "rotation": [0,0,0],
  "edges": [{"endpoints":[0,1]}, {"endpoints":[1,2]}, {"endpoints":[2,3]}, {"endpoints":[3,0]}]}},
 "stitches": [[{"panel":"front","edge":1}, {"panel":"back","edge":2}], [{"panel":"front","edge":3}, {"panel":"back","edge":0}]]},
"properties": {"curvature_coords": "relative", "units_in_meter": 100}})";
}

io::Imported read(const QString& text) {
    auto imported = garmentCodeFromText(text.toStdString(), "a.json");
    if (!imported) qFatal("%s", toString(imported.error()).c_str());
    return *imported;
}

Vec3 placedVertex(const Piece& piece, std::size_t i) {
    return placed(*piece.placement, piece.outline.vertices[i].position);
}

/// The front panel's first edge with this curvature.
geometry::Curve curveWith(const QString& curvature) {
    const auto imported = read(
        twoPanels().replace(R"({"endpoints":[0,1]}, {"endpoints":[1,2]}, {"endpoints":[2,3]}, {"endpoints":[3,0]}]},
 "back")",
                            R"({"endpoints":[0,1], "curvature":)" + curvature +
                                R"(}, {"endpoints":[1,2]}, {"endpoints":[2,3]}, {"endpoints":[3,0]}]},
 "back")"));
    return curveOf(imported.document.pattern.pieces[0]->outline, 0);
}

} // namespace

void tst_GarmentCodeFile::panelsBecomePiecesInMetres() {
    const Pattern pattern = read(twoPanels()).document.pattern;
    QCOMPARE(pattern.pieces.size(), std::size_t(2));
    QCOMPARE(pattern.pieces[0]->name, std::string("front"));
    QVERIFY(std::abs(areaOf(*pattern.pieces[0]) - 0.06) < 1e-12);
    QVERIFY(distance(placedVertex(*pattern.pieces[0], 2), Vec3{0.1, 1.3, 0.2}) < 1e-12);
    QVERIFY(!hasErrors(checkPattern(pattern)));
    const Pattern third =
        read(twoPanels().replace("\"units_in_meter\": 100", "\"units_in_meter\": 300")).document.pattern;
    QVERIFY(std::abs(areaOf(*third.pieces[0]) - 0.06 / 9) < 1e-12);
}

void tst_GarmentCodeFile::aClockwisePanelIsTurnedOverInPlace() {
    const Piece back = *read(twoPanels()).document.pattern.pieces[1];
    QVERIFY(areaOf(back) > 0);                                                  // counter-clockwise
    QVERIFY(distance(placedVertex(back, 2), Vec3{0.1, 1.3, -0.2}) < 1e-12);     // where the file puts it
    QVERIFY(distance(back.placement->transform.axisZ, Vec3{0, 0, -1}) < 1e-12); // the right side faces backwards
}

void tst_GarmentCodeFile::anglesAreReadAsZTimesYTimesX() {
    const auto imported = read(twoPanels().replace(QString("\"translation\": [-10,100,20], \"rotation\": [0,0,0]"),
                                                   QString("\"translation\": [0,0,0], \"rotation\": [90,0,90]")));
    // x first turns y to z, then z turns x to y and leaves z.
    const Transform t = imported.document.pattern.pieces[0]->placement->transform;
    QVERIFY(distance(t.axisX, Vec3{0, 1, 0}) < 1e-12);
    QVERIFY(distance(t.axisY, Vec3{0, 0, 1}) < 1e-12);
}

void tst_GarmentCodeFile::stitchesJoinEndToStart() {
    const Pattern pattern = read(twoPanels()).document.pattern;
    QCOMPARE(pattern.seams.size(), std::size_t(2));
    const Seam& seam = pattern.seams[0];
    const auto a = partPoints(pattern, seam.sides[0][0], 1e-4), b = partPoints(pattern, seam.sides[1][0], 1e-4);
    // Front edge 1 runs upwards at x = 10 cm; the back's edge 2 lies behind it: first point meets first point.
    QVERIFY(distance(placed(*pattern.pieces[0]->placement, a.front()), Vec3{0.1, 1, 0.2}) < 1e-12);
    QVERIFY(distance(placed(*pattern.pieces[1]->placement, b.front()), Vec3{0.1, 1, -0.2}) < 1e-12);
}

void tst_GarmentCodeFile::quadraticCurvesKeepTheirCourse() {
    // Control at the middle, 0.5 to the left: the curve's middle lies 0.25 to the left, of 20 cm.
    for (const char* curvature : {"[0.5, 0.5]", R"({"type":"quadratic","params":[[0.5, 0.5]]})"})
        QVERIFY(distance(geometry::pointAt(curveWith(curvature), 0.5), Vec2{0.1, 0.05}) < 1e-12);
    const geometry::Curve cubic = curveWith(R"({"type":"cubic","params":[[0, 0.2],[1, 0.2]]})");
    QVERIFY(distance(geometry::pointAt(cubic, 0.5), Vec2{0.1, 0.03}) < 1e-12); // ¾ of 0.2 · 20 cm
}

void tst_GarmentCodeFile::circlesBulgeToTheSideTheySay() {
    // A half circle over 20 cm with radius 10 cm: right of (0,0) → (20,0) is −y.
    const geometry::Curve right = curveWith(R"({"type":"circle","params":[10, 0, 1]})");
    QVERIFY(distance(geometry::pointAt(right, 0.5), Vec2{0.1, -0.1}) < 1e-9);
    const geometry::Curve left = curveWith(R"({"type":"circle","params":[12.5, 0, 0]})");
    QVERIFY(distance(geometry::pointAt(left, 0.5), Vec2{0.1, 0.05}) < 1e-9); // sagitta 12.5 − 7.5
    const geometry::Curve large = curveWith(R"({"type":"circle","params":[12.5, 1, 0]})");
    QVERIFY(distance(geometry::pointAt(large, 0.5), Vec2{0.1, 0.2}) < 1e-9); // 12.5 + 7.5
}

void tst_GarmentCodeFile::unequalEdgesAreSewnWithEase() {
    const auto imported = read(twoPanels().replace("[0,0],[0,30],[20,30],[20,0]", "[0,0],[0,30],[20,30],[20,1]"));
    const Pattern& pattern = imported.document.pattern;
    QCOMPARE(pattern.seams[0].sections.size(), std::size_t(1));
    QVERIFY(std::abs(pattern.seams[0].sections[0].ease - 0.01) < 1e-12);
    QVERIFY(!hasErrors(checkPattern(pattern)));
    QVERIFY(std::ranges::any_of(imported.warnings,
                                [](const Warning& w) { return w.text.find("taken as ease") != std::string::npos; }));
}

void tst_GarmentCodeFile::aMistakeNamesItsPlace_data() {
    QTest::addColumn<QString>("was");
    QTest::addColumn<QString>("becomes");
    QTest::addColumn<QString>("path");
    QTest::newRow("a stitch to an unknown panel") << "{\"panel\":\"back\",\"edge\":2}"
                                                  << "{\"panel\":\"side\",\"edge\":2}"
                                                  << "pattern.stitches[0][1].panel";
    QTest::newRow("a stitch to an unknown edge") << "{\"panel\":\"back\",\"edge\":2}"
                                                 << "{\"panel\":\"back\",\"edge\":4}"
                                                 << "pattern.stitches[0][1].edge";
    QTest::newRow("an edge stitched twice") << "{\"panel\":\"back\",\"edge\":2}"
                                            << "{\"panel\":\"back\",\"edge\":0}"
                                            << "pattern.stitches[1]";
    QTest::newRow("an edge to an unknown point") << "{\"endpoints\":[0,1]}"
                                                 << "{\"endpoints\":[0,7]}"
                                                 << "pattern.panels.front.edges[0].endpoints[1]";
    QTest::newRow("edges that do not follow each other") << "{\"endpoints\":[0,1]}"
                                                         << "{\"endpoints\":[0,2]}"
                                                         << "pattern.panels.front.edges[0].endpoints";
    QTest::newRow("no panels") << "\"panels\""
                               << "\"pieces\""
                               << "pattern";
    QTest::newRow("no unit") << "\"units_in_meter\": 100"
                             << "\"units_in_meter\": 0"
                             << "properties.units_in_meter";
}

void tst_GarmentCodeFile::aMistakeNamesItsPlace() {
    QFETCH(QString, was);
    QFETCH(QString, becomes);
    QFETCH(QString, path);
    QString text = twoPanels();
    text.replace(text.indexOf(was), was.size(), becomes);
    const auto imported = garmentCodeFromText(text.toStdString(), "a.json");
    QVERIFY(!imported);
    QCOMPARE(QString::fromStdString(imported.error().place.path), path);
    QVERIFY(imported.error().place.line > 0);
}

void tst_GarmentCodeFile::extremeNumbersAreRefused_data() {
    QTest::addColumn<QString>("units");
    QTest::addColumn<QString>("corner");
    QTest::addColumn<QString>("curvature");
    QTest::addColumn<QString>("path");
    const QString curve = R"({"type":"quadratic","params":[[0.5, 0.2]]})",
                  arc = R"({"type":"circle","params":[12,0,0]})";
    const QString units = "properties.units_in_meter", edge = "pattern.panels.front.edges[0].curvature.params[0]";
    QTest::newRow("no unit, and a curve") << "0"
                                          << "20" << curve << units;
    QTest::newRow("no unit, and an arc") << "0"
                                         << "20" << arc << units;
    QTest::newRow("a negative unit") << "-100"
                                     << "20" << curve << units;
    QTest::newRow("a unit longer than the earth's orbit") << "1e-300"
                                                          << "20" << curve << units;
    QTest::newRow("a unit smaller than an atom") << "1e300"
                                                 << "20" << curve << units;
    QTest::newRow("a corner beyond the sky") << "100"
                                             << "1e308" << curve << "pattern.panels.front.vertices[1][0]";
    QTest::newRow("a control point there") << "100"
                                           << "20"
                                           << R"({"type":"quadratic","params":[[0.5, -1e308]]})" << edge + "[1]";
    QTest::newRow("a radius as large") << "100"
                                       << "20"
                                       << R"({"type":"circle","params":[1e308,1,0]})" << edge;
}

void tst_GarmentCodeFile::extremeNumbersAreRefused() {
    QFETCH(QString, units);
    QFETCH(QString, corner);
    QFETCH(QString, curvature);
    QFETCH(QString, path);
    QString text = twoPanels();
    text.replace("\"units_in_meter\": 100", "\"units_in_meter\": " + units);
    text.replace("\"vertices\": [[0,0],[20,0]", "\"vertices\": [[0,0],[" + corner + ",0]");
    const QString first = "{\"endpoints\":[0,1]}";
    text.replace(text.indexOf(first), first.size(), "{\"endpoints\":[0,1], \"curvature\": " + curvature + "}");
    const auto imported = garmentCodeFromText(text.toStdString(), "a.json");
    QVERIFY(!imported);
    QCOMPARE(imported.error().place.path, path.toStdString());
}

void tst_GarmentCodeFile::realFilesAreRead_data() {
    QTest::addColumn<int>("pieces");
    QTest::addColumn<int>("seams");
    QTest::newRow("garmentcode/shirt_mean_specification.json") << 8 << 18;
    QTest::newRow("garment-pattern-generator/dress_sleeveless.json") << 4 << 10;
    QTest::newRow("garment-pattern-generator/pants_straight_sides.json") << 4 << 6;
    QTest::newRow("garment-pattern-generator/skirt_2_panels.json") << 2 << 4;
    QTest::newRow("garment-pattern-generator/skirt_4_panels.json") << 4 << 8;
    QTest::newRow("garment-pattern-generator/tee.json") << 6 << 12;
    QTest::newRow("freesewing/simone_shirt_sewable_specification.json") << 9 << 59;
    QTest::newRow("freesewing/teagan_tshirt_sewable_specification.json") << 4 << 20;
    QTest::newRow("freesewing/titan_trousers_sewable_specification.json") << 4 << 10;
}

void tst_GarmentCodeFile::realFilesAreRead() {
    QFETCH(int, pieces);
    QFETCH(int, seams);
    const QString data = qEnvironmentVariable("TOILE_TEST_DATA");
    if (data.isEmpty()) QSKIP("NOT RUN: set TOILE_TEST_DATA to the folder with patterns/ to read real files.");
    const auto imported = io::readGarmentCode((data + "/patterns/" + QTest::currentDataTag()).toStdString());
    QVERIFY2(imported, imported ? "" : toString(imported.error()).c_str());
    const Pattern& pattern = imported->document.pattern;
    QCOMPARE(static_cast<int>(pattern.pieces.size()), pieces);
    QCOMPARE(static_cast<int>(pattern.seams.size()), seams);
    for (const Problem& problem : checkPattern(pattern))
        QVERIFY2(!problem.isError, (toString(problem.place) + ": " + problem.text).c_str());
    for (const auto& piece : pattern.pieces) {
        // Placed round a body of human size, the right side away from its middle.
        Vec3 centre;
        for (std::size_t i = 0; i < piece->outline.vertices.size(); ++i) centre += placedVertex(*piece, i);
        centre = centre / static_cast<double>(piece->outline.vertices.size());
        QVERIFY2(std::abs(centre.x) < 1 && std::abs(centre.z) < 0.5 && centre.y > -1 && centre.y < 1.8,
                 piece->name.c_str());
        const Vec3 outward = piece->placement->transform.axisZ;
        QVERIFY2(outward.x * centre.x + outward.z * centre.z > 0, piece->name.c_str());
    }
}

TOILE_TEST(tst_GarmentCodeFile)
#include "tst_GarmentCodeFile.moc"
