// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>
#include <algorithm>
#include <set>

using namespace toile;
using namespace toile::meshing;

/// Seam preprocessing: equal counts at equal relative lengths.
class tst_Seams : public QObject {
    Q_OBJECT
private slots:
    void bothSidesCarryTheFinerCount();
    void aReversedPartIsWalkedBackwards();
    void jointsOfOneSideBecomeNodesOfTheOther();
    void chainsOfSeveralPiecesMeetAtTheJointsOfBothSides();
    void anUndeclaredMismatchIsAnErrorWithBothLengths();
    void declaredEaseKeepsEqualCounts();
    void notchesAreMatchedInOrder();
    void aNotchAtAJointOfTheChainCounts_data();
    void aNotchAtAJointOfTheChainCounts();
    void seamsThatShareAnEdgeShareItsCount();
    void aDartClosesAtOneTip();
    void nodesTooNearForTheGridAreRefused();
    void theThreeConditionsOfThePaperHoldForEverySeam();
};

namespace {

Vec2 pointOf(const GarmentMesh& garment, NodeRef ref) {
    return garment.pieces[static_cast<std::size_t>(ref.piece)].nodes[static_cast<std::size_t>(ref.node)];
}

} // namespace

void tst_Seams::bothSidesCarryTheFinerCount() {
    MeshInput input{{rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.1, 0.3, 0.01)}, {}};
    input.seams = {seamOf({{0, 0, 1}}, {{1, 0, 3, 0, 1, true}})};
    const auto garment = meshGarment(input);
    QVERIFY(garment);
    QCOMPARE(garment->seams[0].pairs.size(), std::size_t{31});
    for (const auto& [a, b] : garment->seams[0].pairs) // right edge of one, left edge of the other, both upwards
        QVERIFY(std::abs(pointOf(*garment, a).y - pointOf(*garment, b).y) < 1e-15);
    QVERIFY(pointOf(*garment, garment->seams[0].pairs.front()[0]) == (Vec2{0.2, 0}));
    QVERIFY(pointOf(*garment, garment->seams[0].pairs.back()[1]) == (Vec2{0, 0.3}));
    for (const PieceMesh& mesh : garment->pieces) QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
}

void tst_Seams::aReversedPartIsWalkedBackwards() {
    MeshInput input{{rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.2, 0.3, 0.02)}, {}};
    input.seams = {seamOf({{0, 0, 1, 0.25, 0.75, true}}, {{1, 0, 1, 0.25, 0.75, false}})};
    const auto garment = meshGarment(input);
    QVERIFY(garment);
    const auto& pairs = garment->seams[0].pairs;
    QCOMPARE(pairs.size(), std::size_t{9}); // ceil(0.15 / 0.02) = 8 parts
    QVERIFY(distance(pointOf(*garment, pairs.front()[0]), Vec2{0.2, 0.225}) < 1e-15);
    QVERIFY(distance(pointOf(*garment, pairs.front()[1]), Vec2{0.2, 0.075}) < 1e-15);
}

void tst_Seams::jointsOfOneSideBecomeNodesOfTheOther() {
    // Two narrow pieces side by side on one wide one; the joint lies at 0.13 of 0.3.
    MeshInput input{{rectanglePiece(0.13, 0.2, 0.02), rectanglePiece(0.17, 0.2, 0.02), rectanglePiece(0.3, 0.1, 0.02)},
                    {}};
    input.seams = {seamOf({{0, 0, 0}, {1, 0, 0}}, {{2, 0, 2, 0, 1, true}})};
    const auto garment = meshGarment(input);
    QVERIFY(garment);
    const auto& pairs = garment->seams[0].pairs;
    QCOMPARE(pairs.size(), std::size_t{7 + 1 + 9 + 1}); // the joint twice: two corners face one node
    QCOMPARE(pairs[7][0].piece, 0);
    QCOMPARE(pairs[8][0].piece, 1);
    QVERIFY(pairs[7][1] == pairs[8][1]);
    QVERIFY(distance(pointOf(*garment, pairs[7][1]), Vec2{0.13, 0.1}) < 1e-15);
}

void tst_Seams::chainsOfSeveralPiecesMeetAtTheJointsOfBothSides() {
    // Joints at 0.13 and 0.33 m on one side, at 0.25 m on the other: four stretches of 0.13, 0.12, 0.08 and 0.17 m.
    MeshInput input{{rectanglePiece(0.13, 0.2, 0.02), rectanglePiece(0.2, 0.2, 0.02), rectanglePiece(0.17, 0.2, 0.02),
                     rectanglePiece(0.25, 0.1, 0.02), rectanglePiece(0.25, 0.1, 0.02)},
                    {}};
    input.seams = {seamOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{3, 0, 2, 0, 1, true}, {4, 0, 2, 0, 1, true}})};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    const std::array<double, 3> leftOfA{0, 0.13, 0.33};
    std::array<std::set<double>, 2> along; // the places of the sewing points from the start of the seam, to 1 µm
    const auto rounded = [](double place) { return std::round(place * 1e6) / 1e6; };
    for (const auto& [a, b] : garment->seams[0].pairs) {
        along[0].insert(rounded(leftOfA[static_cast<std::size_t>(a.piece)] + pointOf(*garment, a).x));
        along[1].insert(rounded((b.piece - 3) * 0.25 + pointOf(*garment, b).x));
    }
    QVERIFY(along[0] == along[1]);
    QCOMPARE(along[0].size(), std::size_t{7 + 6 + 4 + 9 + 1}); // each stretch in ⌈L / 20 mm⌉ parts
    for (const double joint : {0.13, 0.25, 0.33}) QVERIFY(along[0].contains(joint));
    const SewnAlike alike = sewnAlike(garment->report.seams[0]);
    QVERIFY(alike.length && alike.count && alike.unit);
}

void tst_Seams::anUndeclaredMismatchIsAnErrorWithBothLengths() {
    MeshInput input{{rectanglePiece(0.2, 0.304, 0.02), rectanglePiece(0.2, 0.3, 0.02)}, {}};
    input.seams = {seamOf({{0, 0, 1}}, {{1, 0, 3, 0, 1, true}})};
    const auto refused = meshGarment(input);
    QVERIFY(!refused);
    QVERIFY(refused.error().text.find("304.0 mm") != std::string::npos);
    QVERIFY(refused.error().text.find("300.0 mm") != std::string::npos);
    input.pieces[0] = rectanglePiece(0.2, 0.302, 0.02);
    const auto warned = meshGarment(input);
    QVERIFY(warned);
    QCOMPARE(warned->report.warnings.size(), std::size_t{1});
    input.pieces[0] = rectanglePiece(0.2, 0.3009, 0.02);
    const auto silent = meshGarment(input);
    QVERIFY(silent);
    QVERIFY(silent->report.warnings.empty());
}

void tst_Seams::declaredEaseKeepsEqualCounts() {
    MeshInput input{{rectanglePiece(0.2, 0.33, 0.02), rectanglePiece(0.2, 0.3, 0.02)}, {}};
    input.seams = {seamOf({{0, 0, 1}}, {{1, 0, 3, 0, 1, true}})};
    input.seams[0].sections = {{0.03, {}}};
    const auto garment = meshGarment(input);
    QVERIFY(garment);
    QCOMPARE(garment->seams[0].pairs.size(), std::size_t{18}); // ceil(0.33 / 0.02) = 17 parts on both sides
    for (std::size_t k = 0; k < 18; ++k) {
        const auto& pair = garment->seams[0].pairs[k];
        QVERIFY(std::abs(pointOf(*garment, pair[0]).y - 0.33 * static_cast<double>(k) / 17) < 1e-15);
        QVERIFY(std::abs(pointOf(*garment, pair[1]).y - 0.30 * static_cast<double>(k) / 17) < 1e-15);
    }
    input.seams[0].sections = {{0, 1.1}}; // the same as a ratio
    QVERIFY(meshGarment(input));
}

void tst_Seams::notchesAreMatchedInOrder() {
    MeshInput input{{rectanglePiece(0.2, 0.4, 0.02), rectanglePiece(0.2, 0.4, 0.02)}, {}};
    input.pieces[0].outline[1].notches = {0.3};
    input.pieces[1].outline[3].notches = {0.69}; // walked backwards: 0.31
    input.seams = {seamOf({{0, 0, 1}}, {{1, 0, 3, 0, 1, true}})};
    input.seams[0].sections = {{-0.004, {}}, {0.004, {}}};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    const auto& pairs = garment->seams[0].pairs;
    QCOMPARE(pairs.size(), std::size_t{1 + 7 + 14});
    QVERIFY(distance(pointOf(*garment, pairs[7][0]), Vec2{0.2, 0.12}) < 1e-15);
    QVERIFY(distance(pointOf(*garment, pairs[7][1]), Vec2{0, 0.124}) < 1e-15);
}

void tst_Seams::aNotchAtAJointOfTheChainCounts_data() {
    QTest::addColumn<bool>("onFirst");
    QTest::addColumn<bool>("onSecond");
    QTest::newRow("marked on the first edge") << true << false;
    QTest::newRow("marked on the second edge") << false << true;
    QTest::newRow("marked on both") << true << true;
}

void tst_Seams::aNotchAtAJointOfTheChainCounts() {
    QFETCH(bool, onFirst);
    QFETCH(bool, onSecond);
    MeshInput input{{rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.4, 0.3, 0.02)},
                    {}};
    if (onFirst) input.pieces[0].outline[2].notches = {0};
    if (onSecond) input.pieces[1].outline[2].notches = {1};
    input.pieces[1].outline[2].notches.insert(input.pieces[1].outline[2].notches.begin(), 0.0); // the end of the chain
    input.pieces[2].outline[0].notches = {0.52};
    input.seams = {seamOf({{0, 0, 2, 0, 1, true}, {1, 0, 2, 0, 1, true}}, {{2, 0, 0}})};
    input.seams[0].sections = {{-0.008, {}}, {0.008, {}}};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    const auto& pairs = garment->seams[0].pairs;
    QVERIFY(std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
        const Vec2 first = pointOf(*garment, pair[0]), second = pointOf(*garment, pair[1]);
        const bool atJoint = first == (pair[0].piece == 0 ? Vec2{0.2, 0.3} : Vec2{0, 0.3});
        return atJoint && distance(second, Vec2{0.208, 0}) < 1e-12;
    }));
    for (const PieceMesh& mesh : garment->pieces) QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
}

void tst_Seams::seamsThatShareAnEdgeShareItsCount() {
    MeshInput input{{rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.2, 0.3, 0.01)},
                    {}};
    input.seams = {seamOf({{0, 0, 1}}, {{1, 0, 1}}), seamOf({{1, 0, 1}}, {{2, 0, 1}})};
    const auto garment = meshGarment(input);
    QVERIFY(garment);
    QCOMPARE(garment->seams[0].pairs.size(), std::size_t{31});
    QCOMPARE(garment->seams[1].pairs.size(), std::size_t{31});
}

void tst_Seams::aDartClosesAtOneTip() {
    PieceInput piece = polygonPiece({{0, 0}, {0.09, 0}, {0.1, 0.12}, {0.11, 0}, {0.2, 0}, {0.2, 0.3}, {0, 0.3}}, 0.02);
    MeshInput input{{piece}, {}};
    input.seams = {seamOf({{0, 0, 1}}, {{0, 0, 2, 0, 1, true}})};
    const auto garment = meshGarment(input);
    QVERIFY(garment);
    const auto& pairs = garment->seams[0].pairs;
    QCOMPARE(pairs.size(), std::size_t{8});
    QVERIFY(pairs.back()[0] == pairs.back()[1]);
    QVERIFY(pointOf(*garment, pairs.back()[0]) == (Vec2{0.1, 0.12}));
    QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0])), QString());
}

void tst_Seams::nodesTooNearForTheGridAreRefused() {
    // 20 m at 1 mm gathered into 0.25 m: nodes 12.5 µm apart, 51 units of 1/4096 mm.
    MeshInput input{{rectanglePiece(20, 0.002, 0.001, "Ruffle"), rectanglePiece(0.25, 0.5, 0.02, "Yoke")}, {}};
    input.seams = {seamOf({{0, 0, 2, 0, 1, true}}, {{1, 0, 0}})};
    input.seams[0].sections = {{0, 80.0}};
    const auto refused = meshGarment(input);
    QVERIFY(!refused);
    QCOMPARE(refused.error().place.object, std::string("piece \"Yoke\", edge \"e0\""));
    QVERIFY(refused.error().text.find("20000 nodes on 250.0 mm") != std::string::npos);
    input.seams[0].sections = {{0, 200.0}};
    QVERIFY(meshGarment(input).error().text.find("between 0.01 and 100") != std::string::npos);
}

void tst_Seams::theThreeConditionsOfThePaperHoldForEverySeam() {
    // Plain; with ease; two pieces on one; a chain with notches.
    MeshInput input{{rectanglePiece(0.2, 0.3, 0.02), rectanglePiece(0.1, 0.3, 0.01), rectanglePiece(0.1, 0.32, 0.02),
                     rectanglePiece(0.62, 0.05, 0.015)},
                    {}};
    input.seams = {seamOf({{0, 0, 1}}, {{1, 0, 3, 0, 1, true}}), seamOf({{2, 0, 1}}, {{1, 0, 1}}),
                   seamOf({{0, 0, 3, 0, 1, true}, {2, 0, 3, 0, 1, true}}, {{3, 0, 0}})};
    input.seams[1].sections = {{0.02, {}}};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    for (const SeamReport& seam : garment->report.seams) {
        const SewnAlike alike = sewnAlike(seam);
        QVERIFY(alike.length && alike.count && alike.unit);
    }
    QCOMPARE(garment->report.seams[0].countA, 31);
    QCOMPARE(garment->report.seams[2].countB, 20 + 22 + 1); // 0.3 and 0.32 m at the band's 15 mm
    SeamReport broken = garment->report.seams[0];
    broken.countB += 1;
    broken.lengthB += 0.01;
    broken.largestSpacingMismatch = 0.2;
    const SewnAlike unlike = sewnAlike(broken);
    QVERIFY(!unlike.length && !unlike.count && !unlike.unit);
}

TOILE_TEST(tst_Seams)
#include "tst_Seams.moc"
