// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "samples/Blouse.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "tests/Suite.h"
#include "tests/samples/Corners.h"

using namespace toile;
using namespace toile::pattern;
using namespace toile::samples;

namespace {

struct Sample {
    body::Measurements measurements = blouseWearer();
    body::Body body = makeMannequin(measurements)->body;
    Figures figures = figuresOf(measurements, body.landmarks);
    BlouseSettings settings;
    UpperLevels levels = draftUpperBlock(measurements, figures, settings.block).value().levels;
    Pattern pattern = blouse(measurements, body, settings).value().pattern;

    [[nodiscard]] const Piece& piece(const char* id) const { return *findPiece(pattern, PieceId{id}); }
    [[nodiscard]] double angle(const char* id, const char* corner) const {
        return cornerDegrees(piece(id), vertexId(id, corner));
    }
};

/// Drafted once for all tests: finding the body takes a second.
const Sample& sample() {
    static const Sample drafted;
    return drafted;
}

} // namespace

class tst_Blouse : public QObject {
    Q_OBJECT
private slots:
    void wearingEaseIsAsAsked();
    void sewnEdgesAgreeUpToTheirEase();
    void matedCornersAreTrue_data();
    void matedCornersAreTrue();
    void dartLegsAreEqualAndCloseTheSideSeamStraight();
    void capEaseLiesAboveTheNotches();
    void theBackHasFourRegionsThreeOfThemHalved();
    void rightPiecesStartAsMirrorImages();
    void rightSidesFaceOutward();
    void piecesStartClearOfTheBody();
    void measuresThatDoNotGoTogetherAreNamed();
};

void tst_Blouse::wearingEaseIsAsAsked() {
    const Sample& s = sample();
    const auto round = [&](double front, double back) {
        return 2 * widthAt(s.piece("front-left"), front) + widthAt(s.piece("back"), back);
    };
    constexpr double micrometre = 1e-6; // the widths are measured on flattened curves
    QVERIFY(std::abs(round(s.levels.bustFront, s.levels.bustBack) - s.measurements.bust - 0.090) < micrometre);
    QVERIFY(std::abs(round(s.levels.hipFront, s.levels.hipBack) - s.measurements.hip - 0.060) < micrometre);
    QVERIFY(std::abs(widthAt(s.piece("back"), s.levels.acrossBack) - s.figures.acrossBack - 0.020) < micrometre);
    QVERIFY(std::abs(widthAt(s.piece("sleeve-left"), -s.settings.bicepsBelow) - s.measurements.biceps - 0.070) <
            micrometre);
}

void tst_Blouse::sewnEdgesAgreeUpToTheirEase() {
    const Sample& s = sample();
    for (const Seam& seam : s.pattern.seams) {
        double ease = 0;
        for (const SeamSection& section : seam.sections) ease += section.ease;
        const double difference = sideLength(s.pattern, seam, 0) - sideLength(s.pattern, seam, 1);
        QVERIFY2(std::abs(difference - ease) < 1e-6, seam.name.c_str()); // cloth is cut to a millimetre; this is exact
    }
}

void tst_Blouse::matedCornersAreTrue_data() {
    QTest::addColumn<QStringList>("corners"); // piece:corner …, whose angles together make a straight line
    QTest::newRow("shoulder and neck") << QStringList{"front-left:neck-side", "back:neck-side-left"};
    QTest::newRow("shoulder and armhole") << QStringList{"front-left:shoulder-tip", "back:shoulder-tip-left"};
    QTest::newRow("underarm of the torso") << QStringList{"front-left:underarm", "back:underarm-left"};
    QTest::newRow("underarm of the sleeve") << QStringList{"sleeve-left:underarm-front", "sleeve-left:underarm-back"};
    QTest::newRow("hem at the side") << QStringList{"front-left:hem-side", "back:hem-side-left"};
    QTest::newRow("hem at the centre front") << QStringList{"front-left:hem-centre", "front-left:hem-centre"};
    QTest::newRow("neckline at the centre front") << QStringList{"front-left:neck-centre", "front-left:neck-centre"};
    QTest::newRow("neckline at the centre back") << QStringList{"back:neck-centre"};
    QTest::newRow("sleeve bottom") << QStringList{"sleeve-left:bottom-front", "sleeve-left:bottom-back"};
    QTest::newRow("cuff") << QStringList{"cuff-left:bottom-left", "cuff-left:bottom-right"};
    QTest::newRow("dart at the side seam") << QStringList{"front-left:dart-lower", "front-left:dart-upper"};
}

void tst_Blouse::matedCornersAreTrue() {
    QFETCH(QStringList, corners);
    const Sample& s = sample();
    double sum = 0;
    for (const QString& corner : corners) {
        const QByteArray piece = corner.section(':', 0, 0).toUtf8(), name = corner.section(':', 1).toUtf8();
        sum += s.angle(piece, name);
    }
    QVERIFY2(std::abs(sum - 180) < 3, qPrintable(QString::number(sum))); // the trade's tolerance
}

void tst_Blouse::dartLegsAreEqualAndCloseTheSideSeamStraight() {
    const Sample& s = sample();
    const Piece& front = s.piece("front-left");
    const double lower = edgeLength(front, edgeId("front-left", "dart-lower"));
    QVERIFY(std::abs(lower - edgeLength(front, edgeId("front-left", "dart-upper"))) < 1e-9);
    const Vec2 mouth = vertexPosition(front, vertexId("front-left", "dart-upper")) -
                       vertexPosition(front, vertexId("front-left", "dart-lower"));
    QVERIFY(std::abs(length(mouth) - s.settings.block.dartIntake) < 1e-9);
    // The tape round the bust passes above the dart.
    QVERIFY(vertexPosition(front, vertexId("front-left", "dart-upper")).y < s.levels.bustFront);
}

void tst_Blouse::capEaseLiesAboveTheNotches() {
    const Sample& s = sample();
    const Piece &sleeve = s.piece("sleeve-left"), &front = s.piece("front-left"), &back = s.piece("back");
    const auto below = [](const Piece& piece, std::size_t notch, bool fromStart) {
        const Notch& n = piece.notches[notch];
        return edgeLength(piece, n.edge) * (fromStart ? n.position : 1 - n.position);
    };
    QVERIFY(std::abs(below(sleeve, 0, true) - below(back, 0, true)) < 1e-9);
    QVERIFY(std::abs(below(sleeve, 1, false) - below(front, 0, true)) < 1e-9);
    const double ease =
        edgeLength(sleeve, edgeId("sleeve-left", "cap-front")) + edgeLength(sleeve, edgeId("sleeve-left", "cap-back")) -
        edgeLength(front, edgeId("front-left", "armhole")) - edgeLength(back, edgeId("back", "armhole-left"));
    QVERIFY(ease >= 0.008 && ease <= 0.015);
}

void tst_Blouse::theBackHasFourRegionsThreeOfThemHalved() {
    const Sample& s = sample();
    const auto& regions = s.piece("back").regions;
    QCOMPARE(regions.size(), std::size_t{4});
    QCOMPARE(std::ranges::count(regions, 1, &Region::refinement), 3);
    QCOMPARE(std::ranges::count(regions, 0, &Region::refinement), 1);
}

void tst_Blouse::rightPiecesStartAsMirrorImages() {
    const Sample& s = sample();
    for (const auto& [left, right] :
         {std::pair{"front-left", "front-right"}, {"sleeve-left", "sleeve-right"}, {"cuff-left", "cuff-right"}})
        for (const Vertex& vertex : s.piece(left).outline.vertices) {
            const Vec3 p = placed(*s.piece(left).placement, vertex.position);
            const Vec3 q = placed(*s.piece(right).placement, {-vertex.position.x, vertex.position.y});
            QVERIFY(distance({-p.x, p.y, p.z}, q) < 1e-9);
        }
}

void tst_Blouse::rightSidesFaceOutward() {
    const Sample& s = sample();
    const auto normal = [&](const char* id) {
        const Placement& at = *s.piece(id).placement;
        const Vec3 o = placed(at, {0, 0});
        return normalized(cross(placed(at, {1e-4, 0}) - o, placed(at, {0, 1e-4}) - o));
    };
    QVERIFY(normal("front-left").z > 0.9 && normal("front-right").z > 0.9 && normal("back").z < -0.9);
    QVERIFY(normal("sleeve-left").y > 0.5 && normal("sleeve-left").x > 0.5); // up and away from the trunk
    QVERIFY(normal("sleeve-right").x < -0.5);
}

void tst_Blouse::piecesStartClearOfTheBody() {
    const Sample& s = sample();
    for (const auto& [id, clearance] :
         {std::pair{"front-left", 0.019}, {"back", 0.019}, {"sleeve-left", 0.007}, {"cuff-left", 0.007}})
        QVERIFY2(clearanceOf(s.piece(id), *s.piece(id).placement, s.body) > clearance, id);
}

void tst_Blouse::measuresThatDoNotGoTogetherAreNamed() {
    const Sample& s = sample();
    const auto sentence = [&](const body::Measurements& measurements, const BlouseSettings& settings) {
        const auto drafted = blouse(measurements, s.body, settings);
        return drafted ? std::string() : drafted.error().text;
    };
    BlouseSettings wideCuff = s.settings; // wider than the sleeve that narrows towards it
    wideCuff.cuffEase = 0.5;
    const std::string taper = sentence(s.measurements, wideCuff);
    QVERIFY2(taper.find("The draft finds no taper of the sleeve") == 0, taper.c_str());
    body::Measurements broad = s.measurements; // a hip twice the bust
    broad.hip = 2 * broad.bust;
    const std::string hem = sentence(broad, s.settings);
    QVERIFY2(hem.find("The draft finds no width of the hem") == 0, hem.c_str());
}

TOILE_TEST(tst_Blouse)
#include "tst_Blouse.moc"
