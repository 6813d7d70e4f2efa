// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>

#include <limits>

using namespace toile;
using namespace toile::meshing;

/// Inputs that must give a correct mesh or a sentence that names the place, never a hang or a crash.
class tst_HardInputs : public QObject {
    Q_OBJECT
private slots:
    void isMeshed_data();
    void isMeshed();
    void isMeshedWhateverTheGrain_data();
    void isMeshedWhateverTheGrain();
    void aGrainAt17DegreesHasItsOwnRectangles();
    void aGrainAt45DegreesHasItsOwnRectangles();
    void aScaledPieceHasTheSameMesh();
    void isRefused_data();
    void isRefused();
    void aNotchOnASpikeLaysNoLine();
    void aNarrowPieceHasOneRow();
    void anEdgeOnAScanLineIsFilledToIt();
    void aLargeEstimateIsRefusedBeforeMemoryIsTaken();
    void sixtyFourPartsOnOneCell();
    void aDigitisedOutlineOfManyPoints();
    void seamOfAnEdgeWithItself();
    void seamWithAnEdgeOfNoLength();
    void seamChainTurnedTheWrongWay();
    void aClosedSeamChainMustBeTurnedOneWay();
    void aDartOnABiasPieceClosesAtOneTip();
    void aSlitOfThreeUnitsIsRefusedWithItsPlace();
    void seamsThatWalkTheirPointsForEver();
};

namespace {

const double notANumber = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

BoundaryLoop clockwise(std::vector<Vec2> corners) {
    std::reverse(corners.begin(), corners.end());
    return loopThrough(corners);
}

std::vector<Vec2> boxCorners(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

PieceInput withHoles(PieceInput piece, const std::vector<std::vector<Vec2>>& holes) {
    for (const auto& hole : holes) piece.holes.push_back(clockwise(hole));
    return piece;
}

PieceInput withSpacing(PieceInput piece, double spacing) {
    piece.spacing = spacing;
    return piece;
}

/// Teeth half a spacing wide, with gaps as wide, 5 spacings long.
PieceInput comb(int teeth) {
    const double spacing = 0.01, width = 0.5 * spacing;
    std::vector<Vec2> corners{{0, 0}, {2 * width * teeth, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double x = 2 * width * i;
        corners.push_back({x + 2 * width, 0.02});
        corners.push_back({x + width, 0.02});
        corners.push_back({x + width, 0.07});
        corners.push_back({x, 0.07});
    }
    corners.erase(corners.begin() + 2); // its place is on the right side's line
    corners.insert(corners.begin() + 2, {2 * width * teeth, 0.02});
    return polygonPiece(corners, spacing, "Comb");
}

PieceInput shifted(double offset) {
    PieceInput piece = polygonPiece({{0, 0}, {0.3, 0.02}, {0.25, 0.3}, {0, 0.25}}, 0.02, "Far");
    for (BoundaryEdge& edge : piece.outline) {
        edge.curve.start += Vec2{offset, -offset};
        edge.curve.end += Vec2{offset, -offset};
    }
    return piece;
}

PieceInput digitised(int points) {
    std::vector<Vec2> corners;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points,
                     r = 0.3 + 0.05 * std::sin(5 * angle) + 1e-5 * std::sin(977 * angle);
        corners.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return polygonPiece(corners, 0.02, "Digitised");
}

SeamInput sideSeam(std::vector<SeamPartInput> a, std::vector<SeamPartInput> b) {
    return {"side seam", {std::move(a), std::move(b)}, {}};
}

void compareError(const Result<GarmentMesh>& result, const std::string& object, const std::string& words) {
    QVERIFY(!result);
    QVERIFY2(result.error().place.object.find(object) != std::string::npos, toString(result.error()).c_str());
    QVERIFY2(result.error().text.find(words) != std::string::npos, toString(result.error()).c_str());
}

} // namespace

void tst_HardInputs::isMeshed_data() {
    QTest::addColumn<PieceInput>("piece");
    const double e = 0.02;
    QTest::addRow("duplicate points") << polygonPiece({{0, 0}, {0, 0}, {0.2, 0}, {0.2, 0.2}, {0.2, 0.2}, {0, 0.2}}, e);
    QTest::addRow("collinear triples") << polygonPiece({{0, 0}, {0.1, 0}, {0.2, 0}, {0.2, 0.07}, {0.2, 0.2}, {0, 0.2}},
                                                       e);
    QTest::addRow("a spike") << polygonPiece(
        {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0.1, 0.2}, {0.1, 0.3}, {0.1, 0.2}, {0, 0.2}}, e);
    QTest::addRow("a clockwise border") << polygonPiece({{0, 0}, {0, 0.2}, {0.2, 0.21}, {0.2, 0}}, e);
    QTest::addRow("a slit of 0.01 spacings") << polygonPiece(
        {{0, 0}, {0.0999, 0}, {0.0999, 0.1}, {0.1001, 0.1}, {0.1001, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, e);
    QTest::addRow("a dart tip of one degree") << polygonPiece(
        {{0, 0}, {0.1, 0}, {0.1 + 0.0873e-2, 0.1}, {0.1 + 0.1746e-2, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, e);
    QTest::addRow("a corner of one degree") << polygonPiece({{0, 0}, {0.3, 0}, {0.3, 0.005236}}, e);
    QTest::addRow("a comb of 1000 teeth") << comb(1000);
    QTest::addRow("vertices 1e-12 apart in y")
        << polygonPiece({{0, 0}, {0.1, 1e-12}, {0.2, -1e-12}, {0.2, 0.2}, {0.1, 0.2 + 1e-12}, {0, 0.2}}, e);
    QTest::addRow("vertices on scan lines from below, above and through") << polygonPiece(
        {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0.16, 0.1}, {0.12, 0.2}, {0.08, 0.14}, {0.04, 0.2}, {0, 0.2}, {0.03, 0.1}}, e);
    QTest::addRow("100 km away") << shifted(1e5);
    QTest::addRow("1 mm") << rectanglePiece(0.001, 0.0007, 0.0001);
    QTest::addRow("100 m") << polygonPiece({{0, 0}, {100, 3}, {90, 70}, {-5, 60}}, 2);
    QTest::addRow("spacing larger than the piece") << withSpacing(polygonPiece({{0, 0}, {0.2, 0}, {0.21, 0.2}}, e), 10);
    QTest::addRow("spacing larger than a circle") << withSpacing(circlePiece(0.2, e), 10);
    QTest::addRow("a hole between two lines")
        << withHoles(rectanglePiece(0.2, 0.2, e), {boxCorners(0.101, 0.101, 0.103, 0.103)});
    QTest::addRow("holes one spacing apart") << withHoles(
        rectanglePiece(0.2, 0.2, e), {boxCorners(0.04, 0.04, 0.08, 0.16), boxCorners(0.1, 0.04, 0.14, 0.16)});
    QTest::addRow("holes a hair apart") << withHoles(
        rectanglePiece(0.2, 0.2, e), {boxCorners(0.04, 0.04, 0.1, 0.16), boxCorners(0.10001, 0.04, 0.14, 0.16)});
}

void tst_HardInputs::isMeshed() {
    QFETCH(PieceInput, piece);
    for (const LineRule rule : {LineRule::regular, LineRule::features, LineRule::paper}) {
        piece.rule = rule;
        const auto garment = meshGarment(inputOf(piece));
        QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
        QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0], static_cast<int>(piece.holes.size()))), QString());
        QCOMPARE(garment->report.total.invertedCells + garment->report.total.missingBoundaryNodes +
                     garment->report.total.nonManifoldEdges,
                 0);
    }
}

void tst_HardInputs::isMeshedWhateverTheGrain_data() {
    isMeshed_data();
    const double e = 0.02;
    QTest::addRow("a digitised outline of 1e5 points") << digitised(100000);
    QTest::addRow("a wide dart") << polygonPiece(
        {{0, 0}, {0.09, 0}, {0.1, 0.12}, {0.11, 0}, {0.2, 0}, {0.2, 0.3}, {0, 0.3}}, e);
    PieceInput ring = circlePiece(0.2, e);
    ring.holes.push_back(circleLoop({0.03, 0.02}, 0.08, true));
    QTest::addRow("a ring") << ring;
    QTest::addRow("1 mm across the grain") << rectanglePiece(0.0007, 0.001, 0.0001);
    PieceInput giant = circlePiece(50, 2);
    giant.holes.push_back(circleLoop({10, 5}, 12, true));
    QTest::addRow("a ring of 100 m") << giant;
}

void tst_HardInputs::isMeshedWhateverTheGrain() {
    QFETCH(PieceInput, piece);
    for (const double degrees : {17.0, 45.0, -163.0}) {
        piece.grain = degrees * std::numbers::pi / 180;
        const auto garment = meshGarment(inputOf(piece));
        QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
        QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0], static_cast<int>(piece.holes.size()))), QString());
        const PieceReport& report = garment->report.total;
        QCOMPARE(report.invertedCells + report.missingBoundaryNodes + report.nonManifoldEdges, 0);
    }
}

namespace {

/// The directions of all sides of all rectangles, as seen in the piece, in degrees from the grain's.
double largestTurnFromGrain(const PieceMesh& mesh, double grain) {
    double largest = 0;
    for (const Rectangle& r : mesh.rectangles) {
        const Vec2 weft =
            mesh.nodes[static_cast<std::size_t>(r.nodes[1])] - mesh.nodes[static_cast<std::size_t>(r.nodes[0])];
        const Vec2 expected = geometry::rotated({1, 0}, grain);
        largest = std::max(largest, std::abs(std::atan2(cross(expected, weft), dot(expected, weft))));
    }
    return largest * 180 / std::numbers::pi;
}

} // namespace

void tst_HardInputs::aGrainAt17DegreesHasItsOwnRectangles() {
    PieceInput piece = rectanglePiece(0.5, 0.4, 0.01);
    piece.grain = 17 * std::numbers::pi / 180;
    const auto garment = meshGarment(inputOf(piece));
    QVERIFY(garment);
    QVERIFY(largestTurnFromGrain(garment->pieces[0], piece.grain) <
            1e-4); // border nodes lie on lines to 2 units of the grid
    const PieceReport& report = garment->report.total;
    QVERIFY(report.rectangleFraction > 0.88); // a strip of one element for each of 180 border nodes, of some 2000
    QVERIFY(report.minimumAngle > 28 * std::numbers::pi / 180);
    QVERIFY(report.areaRelativeError < 1e-12); // straight edges
}

void tst_HardInputs::aGrainAt45DegreesHasItsOwnRectangles() {
    PieceInput piece = rectanglePiece(0.4, 0.4, 0.01);
    piece.grain = std::numbers::pi / 4;
    const auto garment = meshGarment(inputOf(piece));
    QVERIFY(garment);
    QVERIFY(largestTurnFromGrain(garment->pieces[0], piece.grain) < 1e-4);
    QVERIFY(garment->report.total.rectangleFraction > 0.80); // the border crosses √2 lines a node: more triangles
    QVERIFY(garment->report.total.minimumAngle > 28 * std::numbers::pi / 180);
}

void tst_HardInputs::aScaledPieceHasTheSameMesh() {
    // By powers of two, which doubles scale without rounding; 0.3 mm to 635 m.
    const auto scaledBodice = [](double factor) {
        PieceInput piece = bodicePiece(0.02 * factor);
        for (BoundaryEdge& edge : piece.outline) {
            edge.curve.start = edge.curve.start * factor;
            edge.curve.end = edge.curve.end * factor;
            if (auto* cubic = std::get_if<geometry::CubicShape>(&edge.curve.shape))
                *cubic = {cubic->control1 * factor, cubic->control2 * factor};
        }
        return piece;
    };
    const auto first = meshGarment(inputOf(scaledBodice(1)));
    QVERIFY(first);
    for (const double factor : {1.0 / 2048, 1.0 / 16, 64.0, 1024.0}) {
        const auto scaled = meshGarment(inputOf(scaledBodice(factor)));
        QVERIFY2(scaled, scaled ? "" : toString(scaled.error()).c_str());
        QCOMPARE(QString::fromStdString(defectOf(scaled->pieces[0])), QString());
        QCOMPARE(scaled->pieces[0].loops[0].size(), first->pieces[0].loops[0].size());
        QCOMPARE(scaled->report.total.rectangles, first->report.total.rectangles);
    }
}

void tst_HardInputs::isRefused_data() {
    QTest::addColumn<PieceInput>("piece");
    QTest::addColumn<QString>("words");
    const double e = 0.02;
    const PieceInput square = rectanglePiece(0.2, 0.2, e);
    QTest::addRow("zero area") << polygonPiece({{0, 0}, {0.2, 0}, {0.1, 0}}, e) << "touches itself";
    QTest::addRow("all vertices on one slanted line")
        << polygonPiece({{0, 0}, {0.1, 0.1}, {0.2, 0.2}, {0.05, 0.05}}, e) << "touches itself";
    QTest::addRow("two points") << polygonPiece({{0, 0}, {0.2, 0}}, e) << "three different points";
    QTest::addRow("one point thrice") << polygonPiece({{0.1, 0}, {0.1, 0}, {0.1, 0}}, e) << "three different points";
    QTest::addRow("a bow-tie") << polygonPiece({{0, 0}, {0.2, 0.2}, {0.2, 0}, {0, 0.2}}, e) << "(100.0, 100.0) mm";
    QTest::addRow("a border run twice") << polygonPiece({{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0}, {0.2, 0}, {0.2, 0.2}}, e)
                                        << "touches itself";
    QTest::addRow("a border that touches itself")
        << polygonPiece({{0, 0}, {0.2, 0}, {0.2, 0.2}, {0.1, 0}, {0, 0.2}}, e) << "(100.0, 0.0) mm";
    QTest::addRow("a hole touching the border")
        << withHoles(square, {boxCorners(0, 0.05, 0.1, 0.1)}) << "cross or touch";
    QTest::addRow("a hole crossing the border") << withHoles(square, {boxCorners(0.15, 0.05, 0.25, 0.1)}) << "(200.0,";
    QTest::addRow("a hole larger than the piece")
        << withHoles(square, {boxCorners(-1, -1, 1, 1)}) << "outside the piece";
    QTest::addRow("a hole outside the piece")
        << withHoles(square, {boxCorners(0.3, 0.3, 0.4, 0.4)}) << "Hole 1 lies outside";
    QTest::addRow("overlapping holes") << withHoles(square, {boxCorners(0.05, 0.05, 0.1, 0.1),
                                                             boxCorners(0.08, 0.08, 0.15, 0.15)})
                                       << "cross or touch";
    QTest::addRow("nested holes") << withHoles(square,
                                               {boxCorners(0.05, 0.05, 0.15, 0.15), boxCorners(0.08, 0.08, 0.1, 0.1)})
                                  << "Hole 2 lies inside hole 1";
    QTest::addRow("10 000 km away") << shifted(1e7) << "beyond 1e6 m";
    QTest::addRow("NaN") << polygonPiece({{0, 0}, {0.2, notANumber}, {0.2, 0.2}}, e) << "not a number";
    QTest::addRow("infinity") << polygonPiece({{0, 0}, {infinity, 0}, {0.2, 0.2}}, e) << "not a number";
    QTest::addRow("spacing zero") << withSpacing(square, 0) << "spacing";
    QTest::addRow("spacing negative") << withSpacing(square, -1) << "spacing";
    QTest::addRow("spacing NaN") << withSpacing(square, notANumber) << "spacing";
    QTest::addRow("spacing infinite") << withSpacing(square, infinity) << "spacing";
    PieceInput open = square;
    open.outline[1].curve.end = {0.3, 0.3};
    QTest::addRow("an open border") << open << "the next one starts at";
    PieceInput notched = square;
    notched.outline[1].notches = {0.7, 0.3};
    QTest::addRow("notches out of order") << notched << "Notches";
}

void tst_HardInputs::isRefused() {
    QFETCH(PieceInput, piece);
    QFETCH(QString, words);
    compareError(meshGarment(inputOf(piece)), "piece \"" + piece.label + "\"", words.toStdString());
}

void tst_HardInputs::aNotchOnASpikeLaysNoLine() {
    PieceInput plain =
        polygonPiece({{0, 0}, {0.2, 0}, {0.2, 0.2}, {0.1, 0.2}, {0.1, 0.13}, {0.1, 0.2}, {0, 0.2}}, 0.02);
    plain.rule = LineRule::features;
    PieceInput notched = plain; // at a height of 174 mm, between two lines
    notched.outline[3].notches = {0.37};
    const auto expected = meshGarment(inputOf(plain)), found = meshGarment(inputOf(notched));
    QVERIFY(expected && found);
    QVERIFY(found->pieces[0].nodes == expected->pieces[0].nodes);
    QCOMPARE(QString::fromStdString(defectOf(found->pieces[0])), QString());
}

void tst_HardInputs::aNarrowPieceHasOneRow() {
    const auto garment = meshGarment(inputOf(rectanglePiece(0.5, 0.012, 0.02)));
    QVERIFY(garment);
    QCOMPARE(garment->pieces[0].rectangles.size(), std::size_t{25});
    QVERIFY(garment->pieces[0].triangles.empty());
}

void tst_HardInputs::anEdgeOnAScanLineIsFilledToIt() {
    // The step at 0.1 lies on the sixth line of the grid that the outer edges lay.
    const auto garment =
        meshGarment(inputOf(polygonPiece({{0, 0}, {0.2, 0}, {0.2, 0.1}, {0.1, 0.1}, {0.1, 0.2}, {0, 0.2}}, 0.02)));
    QVERIFY(garment);
    QVERIFY(garment->pieces[0].triangles.empty());
    QCOMPARE(garment->pieces[0].rectangles.size(), std::size_t{75});
}

void tst_HardInputs::aLargeEstimateIsRefusedBeforeMemoryIsTaken() {
    const auto refused = meshGarment(inputOf(rectanglePiece(1, 1, 1e-7)));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::tooLarge);
    QVERIFY(refused.error().text.find("1e+14 cells") != std::string::npos);
    PieceInput piece = rectanglePiece(1, 1, 0.01);
    piece.regions = {{"dense", boxCorners(0.1, 0.1, 0.9, 0.9), {}, 7}};
    QCOMPARE(meshGarment(inputOf(piece)).error().code, ErrorCode::tooLarge);
}

void tst_HardInputs::sixtyFourPartsOnOneCell() {
    PieceInput piece = rectanglePiece(0.2, 0.2, 0.02);
    piece.regions = {{"corner", boxCorners(0, 0, 0.02, 0.02), {}, 6}};
    const auto garment = meshGarment(inputOf(piece));
    QVERIFY(garment);
    QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0])), QString());
}

void tst_HardInputs::aDigitisedOutlineOfManyPoints() {
    const auto garment = meshGarment(inputOf(digitised(100000)));
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0])), QString());
}

void tst_HardInputs::seamOfAnEdgeWithItself() {
    MeshInput input{{rectanglePiece(0.2, 0.2, 0.02)}, {}};
    input.seams = {sideSeam({{0, 0, 1}}, {{0, 0, 1, 0, 1, true}})};
    compareError(meshGarment(input), "seam \"side seam\"", "edge \"e1\" twice");
    input.seams = {sideSeam({{0, 0, 1, 0, 0.5}}, {{0, 0, 1, 0.5, 1, true}})}; // folded at its middle: a dart of angle π
    const auto folded = meshGarment(input);
    QVERIFY(folded);
    QVERIFY(folded->seams[0].pairs.back()[0] == folded->seams[0].pairs.back()[1]);
}

void tst_HardInputs::seamWithAnEdgeOfNoLength() {
    MeshInput input{
        {polygonPiece({{0, 0}, {0.2, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, 0.02), rectanglePiece(0.2, 0.2, 0.02)}, {}};
    input.seams = {sideSeam({{0, 0, 1}}, {{1, 0, 3}})};
    compareError(meshGarment(input), "seam \"side seam\"", "edge \"e1\", which has no length");
}

void tst_HardInputs::seamChainTurnedTheWrongWay() {
    MeshInput input{{rectanglePiece(0.2, 0.2, 0.02), rectanglePiece(0.4, 0.2, 0.02)}, {}};
    input.seams = {sideSeam({{0, 0, 0}, {0, 0, 1, 0, 1, true}}, {{1, 0, 0}})};
    compareError(meshGarment(input), "seam \"side seam\"", "wrong direction");
    input.seams = {sideSeam({{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}})};
    QVERIFY(meshGarment(input));
    input.seams = {sideSeam({{0, 0, 7}}, {{1, 0, 0}})};
    compareError(meshGarment(input), "seam \"side seam\"", "does not have");
    input.seams = {sideSeam({{5, 0, 0}}, {{1, 0, 0}})};
    compareError(meshGarment(input), "seam \"side seam\"", "does not exist");
    input.seams = {sideSeam({{0, 0, 0, 0.5, 0.2}}, {{1, 0, 0}})};
    compareError(meshGarment(input), "seam \"side seam\"", "fraction");
}

void tst_HardInputs::aClosedSeamChainMustBeTurnedOneWay() {
    // The whole border of one square round that of another, as a sleeve goes into its armhole.
    MeshInput input{{rectanglePiece(0.2, 0.2, 0.02), rectanglePiece(0.2, 0.2, 0.02)}, {}};
    const std::vector<SeamPartInput> round{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
    std::vector<SeamPartInput> back{
        {1, 0, 3, 0, 1, true}, {1, 0, 2, 0, 1, true}, {1, 0, 1, 0, 1, true}, {1, 0, 0, 0, 1, true}};
    input.seams = {sideSeam(round, back)};
    const auto closed = meshGarment(input);
    QVERIFY2(closed, closed ? "" : toString(closed.error()).c_str());
    QVERIFY(closed->seams[0].pairs.front() == closed->seams[0].pairs.back());
    back[2].reversed = false;
    input.seams = {sideSeam(round, back)};
    compareError(meshGarment(input), "seam \"side seam\"", "edge \"e1\" in the wrong direction");
}

void tst_HardInputs::aDartOnABiasPieceClosesAtOneTip() {
    for (const double degrees : {17.0, 45.0}) {
        PieceInput piece =
            polygonPiece({{0, 0}, {0.09, 0}, {0.1, 0.12}, {0.11, 0}, {0.2, 0}, {0.2, 0.3}, {0, 0.3}}, 0.02);
        piece.grain = degrees * std::numbers::pi / 180;
        MeshInput input{{piece}, {sideSeam({{0, 0, 1}}, {{0, 0, 2, 0, 1, true}})}};
        const auto garment = meshGarment(input);
        QVERIFY(garment);
        QVERIFY(garment->seams[0].pairs.back()[0] == garment->seams[0].pairs.back()[1]);
        QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0])), QString());
    }
}

void tst_HardInputs::aSlitOfThreeUnitsIsRefusedWithItsPlace() {
    // Half a micrometre wide on a line of the grid: meshed, or refused with its place, but never a cell
    // without area.
    const double half = 2.5e-7;
    PieceInput piece = polygonPiece({{0, 0},
                                     {0.1 - half, 0},
                                     {0.1 - half, 0.1},
                                     {0.1 + half, 0.1},
                                     {0.1 + half, 0},
                                     {0.2, 0},
                                     {0.2, 0.2},
                                     {0, 0.2}},
                                    0.02);
    const auto garment = meshGarment(inputOf(piece));
    if (garment) QCOMPARE(garment->report.total.invertedCells, 0);
    else compareError(garment, "piece \"Piece\"", "nearer to itself");
}

void tst_HardInputs::seamsThatWalkTheirPointsForEver() {
    // Each half of an edge is sewn to the other, and the whole to a second piece shifted: points wander
    // without end.
    MeshInput input{{rectanglePiece(0.2, 1, 0.02), rectanglePiece(0.2, 1, 0.02)}, {}};
    input.seams = {sideSeam({{0, 0, 1, 0, 0.9}}, {{1, 0, 1, 0, 0.9}}),
                   sideSeam({{0, 0, 1, 0.1, 1}}, {{1, 0, 1, 0, 0.9}})};
    const auto result = meshGarment(input);
    if (result) // the shift is a tenth: the points close after ten rounds
        QCOMPARE(QString::fromStdString(defectOf(result->pieces[0])), QString());
    input.seams[1].sides[0][0] = {0, 0, 1, 0.000123, 0.900123};
    compareError(meshGarment(input), "seam", "");
}

TOILE_TEST(tst_HardInputs)
#include "tst_HardInputs.moc"
