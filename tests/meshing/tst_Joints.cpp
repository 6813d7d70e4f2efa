// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Index.h"
#include "core/meshing/DisplayElements.h"
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>

using namespace toile;
using namespace toile::meshing;

/// What can be said of smoothness and quality without physics.
class tst_Joints : public QObject {
    Q_OBJECT
private slots:
    void joinedRegionsHaveNoCrack();
    void everyDisplayedTriangleIsCutFromItsElement();
    void spacingAcrossEdgesDiffersByTwoAtMost();
    void theStripKeepsItsAngles();
    void mostElementsAreRectangles();
    void theAreaErrorIsThatOfTheChords();
    void threadsDoNotChangeTheMesh();
    void thePaperRuleLeavesLongChainsOfSlaves();
    void thePaperRuleHasNodesWhereScanLinesMeetTheBorder();
    void thePaperRuleDividesSewnEdgesAlike();
    void theReportOfASquareIsKnown();
    void theReportTellsAnglesAndAlignment();
    void aMeshThatIsNotJudgedIsTheSame();
};

namespace {

/// The bodice with a slanted region at 1/4 and one at its shoulder at 1/2.
PieceInput regionBodice(double spacing) {
    PieceInput piece = bodicePiece(spacing);
    piece.regions = {{"waist", {{0.03, 0.11}, {0.2, 0.18}, {0.17, 0.33}, {0.06, 0.29}}, {}, 2},
                     {"shoulder", box(0.05, 0.45, 0.3, 0.7), {}, 1}};
    return piece;
}

struct Span {
    double width, height;
};

Span spanOf(const PieceMesh& mesh, const Rectangle& r) {
    const Vec2 diagonal = mesh.material[at(r.nodes[2])] - mesh.material[at(r.nodes[0])];
    return {diagonal.x, diagonal.y};
}

} // namespace

void tst_Joints::joinedRegionsHaveNoCrack() {
    const auto garment = meshGarment(inputOf(regionBodice(0.02)));
    QVERIFY(garment);
    const PieceMesh& mesh = garment->pieces[0];
    QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
    QVERIFY(mesh.slaves.size() > 50);
    for (const SlaveNode& slave : mesh.slaves) { // an interface point by its node and by its coarse side
        Vec2 onSide;
        for (const auto& [master, weight] : slave.masters) onSide += mesh.nodes[at(master)] * weight;
        QVERIFY(distance(onSide, mesh.nodes[at(slave.node)]) <= 1e-12 * 0.62); // of the piece's length
    }
}

void tst_Joints::everyDisplayedTriangleIsCutFromItsElement() {
    PieceInput paper = regionBodice(0.02);
    paper.rule = LineRule::paper; // several slaves on a side
    for (const PieceInput& piece : {regionBodice(0.02), paper}) {
        const auto garment = meshGarment(inputOf(piece));
        QVERIFY(garment);
        const PieceMesh& mesh = garment->pieces[0];
        const std::vector<int> elements = displayElements(mesh);
        QCOMPARE(elements.size(), mesh.display.size());
        std::vector<double> areas(mesh.rectangles.size() + mesh.triangles.size(), 0);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const auto [a, b, c] = mesh.display[i];
            areas[at(elements[i])] += triangleArea(mesh.material[at(a)], mesh.material[at(b)], mesh.material[at(c)]);
        }
        for (std::size_t r = 0; r < mesh.rectangles.size(); ++r) {
            const Span span = spanOf(mesh, mesh.rectangles[r]);
            QVERIFY(std::abs(areas[r] / (span.width * span.height) - 1) < 1e-9);
            QCOMPARE(regionOf(mesh, static_cast<int>(r)), mesh.rectangles[r].region);
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto [a, b, c] = mesh.triangles[t].nodes;
            const double area = triangleArea(mesh.material[at(a)], mesh.material[at(b)], mesh.material[at(c)]);
            QVERIFY(std::abs(areas[mesh.rectangles.size() + t] / area - 1) < 1e-9);
        }
    }
}

void tst_Joints::spacingAcrossEdgesDiffersByTwoAtMost() {
    const auto garment = meshGarment(inputOf(regionBodice(0.02)));
    QVERIFY(garment);
    const PieceMesh& mesh = garment->pieces[0];
    std::vector<Span> least(mesh.nodes.size(), {1e9, 1e9}), most(mesh.nodes.size(), {0, 0});
    for (const Rectangle& r : mesh.rectangles) {
        const Span span = spanOf(mesh, r);
        for (const int node : r.nodes) {
            least[at(node)] = {std::min(least[at(node)].width, span.width),
                               std::min(least[at(node)].height, span.height)};
            most[at(node)] = {std::max(most[at(node)].width, span.width), std::max(most[at(node)].height, span.height)};
        }
    }
    for (std::size_t i = 0; i < least.size(); ++i) // 1e-9: rounding of coordinates
        QVERIFY(most[i].width <= 2 * least[i].width * (1 + 1e-9) && most[i].height <= 2 * least[i].height * (1 + 1e-9));
}

void tst_Joints::theStripKeepsItsAngles() {
    for (const double spacing : {0.02, 0.01, 0.005})
        for (const PieceInput& piece : {bodicePiece(spacing), circlePiece(0.25, spacing)}) {
            const auto garment = meshGarment(inputOf(piece));
            QVERIFY(garment);
            const PieceReport& report = garment->report.pieces[0];
            qInfo("%s at %.0f mm: %d nodes, %.1f %% rectangles, least angle %.1f degrees", piece.label.c_str(),
                  spacing * 1e3, report.nodes, report.rectangleFraction * 100,
                  report.minimumAngle * 180 / std::numbers::pi);
            QVERIFY(report.minimumAngle >= 28 * std::numbers::pi / 180); // the goal; no corner of theirs is sharper
        }
}

void tst_Joints::mostElementsAreRectangles() {
    // Goals over the sample garments are 80 % at 20 mm and 90 % at 10 mm; a bodice alone must reach them too.
    QVERIFY(meshGarment(inputOf(bodicePiece(0.02)))->report.total.rectangleFraction >= 0.80);
    QVERIFY(meshGarment(inputOf(bodicePiece(0.01)))->report.total.rectangleFraction >= 0.90);
    QVERIFY(meshGarment(inputOf(bodicePiece(0.005)))->report.total.rectangleFraction >= 0.94);
}

void tst_Joints::theAreaErrorIsThatOfTheChords() {
    // n chords of a circle of radius r: area n/2 r² sin(2π/n), sagitta r (1 − cos(π/n)).
    const double r = 0.25;
    const auto garment = meshGarment(inputOf(circlePiece(r, 0.02)));
    QVERIFY(garment);
    const PieceReport& report = garment->report.pieces[0];
    const int n = 2 * static_cast<int>(std::ceil(std::numbers::pi * r / 0.02));
    const double relative = 1 - n / (2 * std::numbers::pi) * std::sin(2 * std::numbers::pi / n);
    QVERIFY(std::abs(report.areaRelativeError - relative) < 1e-8); // Simpson's rule for the circle
    QVERIFY(std::abs(report.boundaryDeviation - r * (1 - std::cos(std::numbers::pi / n))) < 1e-12);
}

void tst_Joints::threadsDoNotChangeTheMesh() {
    MeshInput input;
    for (int i = 0; i < 8; ++i) input.pieces.push_back(regionBodice(0.02 + 0.001 * i));
    const auto first = meshGarment(input), second = meshGarment(input);
    QVERIFY(first && second);
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        QVERIFY(first->pieces[p].nodes == second->pieces[p].nodes);
        QVERIFY(first->pieces[p].display == second->pieces[p].display);
        const auto alone = meshGarment(inputOf(input.pieces[p]));
        QVERIFY(alone->pieces[0].nodes == first->pieces[p].nodes);
    }
}

void tst_Joints::thePaperRuleLeavesLongChainsOfSlaves() {
    PieceInput piece = rectanglePiece(1, 1, 1.0 / 16);
    piece.rule = LineRule::paper;
    piece.regions = {{"quarter", box(0.25, 0.25, 0.75, 0.75), {}, 2}};
    const auto garment = meshGarment(inputOf(piece));
    QVERIFY(garment);
    QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0])), QString());
    QCOMPARE(garment->pieces[0].slaves.size(), std::size_t{4 * 8 * 3}); // three on each coarse side, at t = k/4
    QCOMPARE(garment->pieces[0].rectangles.size(), std::size_t{256 - 64 + 64 * 16});
}

void tst_Joints::thePaperRuleHasNodesWhereScanLinesMeetTheBorder() {
    // Vertices at x = 0, 0.1, 0.4 and y = 0, 0.05, 0.35: gaps divided below 0.08 m.
    PieceInput piece = polygonPiece({{0, 0}, {0.4, 0.05}, {0.1, 0.35}}, 0.08);
    piece.rule = LineRule::paper;
    const auto garment = meshGarment(inputOf(piece));
    QVERIFY(garment);
    const PieceMesh& mesh = garment->pieces[0];
    QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
    const std::vector<double> x{0, 0.05, 0.1, 0.175, 0.25, 0.325, 0.4}, y{0, 0.05, 0.125, 0.2, 0.275, 0.35};
    const auto nearest = [](const std::vector<double>& lines, double at) {
        double least = 1e9;
        for (const double line : lines) least = std::min(least, std::abs(line - at));
        return least;
    };
    std::size_t nodes = 0;
    for (const EdgeNodes& edge : mesh.loops[0])
        for (std::size_t k = 0; k + 1 < edge.size(); ++k, ++nodes) {
            const Vec2 node = mesh.nodes[at(edge[k].node)];
            QVERIFY(std::min(nearest(x, node.x), nearest(y, node.y)) < 1e-9);
        }
    // The vertices and the lines between the ends of each edge: 5; 3 where both families meet; 1 and 4.
    QCOMPARE(nodes, std::size_t{3 + 5 + 3 + (1 + 4)});
}

void tst_Joints::thePaperRuleDividesSewnEdgesAlike() {
    MeshInput input{{rectanglePiece(0.3, 0.4, 0.05), polygonPiece({{0, 0}, {0.3, 0}, {0.27, 0.4}, {0, 0.4}}, 0.03)},
                    {}};
    for (PieceInput& piece : input.pieces) piece.rule = LineRule::paper;
    input.seams = {{"s", {{{{0, 0, 1}}, {{1, 0, 1}}}}, {}}};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    const SewnAlike alike = sewnAlike(garment->report.seams[0]);
    QVERIFY(alike.length && alike.count && alike.unit);
    QCOMPARE(garment->report.seams[0].countA,
             14 + 1); // 0.4 m in 14 rows below 0.03 m; the one column between is the edge itself
    for (const PieceMesh& mesh : garment->pieces) QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
}

void tst_Joints::theReportOfASquareIsKnown() {
    const auto garment = meshGarment(inputOf(rectanglePiece(1, 0.5, 0.125)));
    QVERIFY(garment);
    const PieceReport& report = garment->report.pieces[0];
    QCOMPARE(report.angles[90], 4 * 8 * 4); // the corners of 8 × 4 rectangles
    for (const double part : {0.01, 0.5, 0.99}) QCOMPARE(angleBelow(report, part), 90);
    QVERIFY(std::abs(report.sideLength - 32 * 0.5) < 1e-12);
    QCOMPARE(report.grainAlignment, 1.0);
    QVERIFY(std::abs(report.neighbourSizeRatio - 1) < 1e-12);
    QVERIFY(std::abs(report.maximumAspect - 1) < 1e-12);
}

void tst_Joints::theReportTellsAnglesAndAlignment() {
    const auto garment = meshGarment(inputOf(circlePiece(0.25, 0.02)));
    QVERIFY(garment);
    const PieceReport& report = garment->report.total;
    int corners = 0;
    for (const int count : report.angles) corners += count;
    QCOMPARE(corners, 4 * report.quads + 3 * report.triangles);
    const int first = angleBelow(report, 0), median = angleBelow(report, 0.5), last = angleBelow(report, 0.99);
    QCOMPARE(first, static_cast<int>(report.minimumAngle * 180 / std::numbers::pi));
    QCOMPARE(median, 90); // most elements are rectangles
    QVERIFY(last > 90 && last <= report.maximumAngle * 180 / std::numbers::pi);
    QVERIFY(report.grainAlignment > report.rectangleFraction * 0.9 && report.grainAlignment < 1);
    QVERIFY(report.neighbourSizeRatio > 1 && report.neighbourSizeRatio < 4);
}

void tst_Joints::aMeshThatIsNotJudgedIsTheSame() {
    const MeshInput input = inputOf(regionBodice(0.02));
    const auto judged = meshGarment(input), quick = meshGarment(input, {.judged = false});
    QVERIFY(judged && quick);
    QVERIFY(judged->pieces[0].nodes == quick->pieces[0].nodes && judged->pieces[0].display == quick->pieces[0].display);
    QCOMPARE(quick->report.total.rectangleFraction, judged->report.total.rectangleFraction);
    QCOMPARE(quick->report.total.quads, judged->report.total.quads);
}

TOILE_TEST(tst_Joints)
#include "tst_Joints.moc"
