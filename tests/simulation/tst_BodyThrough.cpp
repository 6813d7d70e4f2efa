// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyThrough.h"
#include "core/simulation/Warnings.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"
#include "tests/simulation/SmallScenes.h"
#include "tests/simulation/UsualBody.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;
using body::Limb;

namespace {

/// A sheet of 0.4 m that lies level, its middle there.
Scene sheetAround(const Vec3& middle) {
    Scene scene = sheetOnTable();
    pattern::Piece piece = polygonPiece("sheet", {{0, 0}, {0.4, 0}, {0.4, 0.4}, {0, 0.4}}, 0.03);
    piece.placement = scene.pattern.pieces[0]->placement;
    piece.placement->transform.origin = middle + Vec3{-0.2, 0, 0.2};
    scene.pattern.pieces = {Shared<pattern::Piece>(std::move(piece))};
    scene.body = Shared<body::Body>(usualBody());
    return scene;
}

/// A sheet that cuts a ball at a height over its middle.
Scene sheetInBall(double height) {
    Scene scene = sheetAround({0, height, 0});
    body::Body ball;
    ball.name = "ball";
    ball.mesh = shapes::starBody(24, 40, [](const Vec3&) { return 0.1; });
    scene.body = Shared<body::Body>(std::move(ball));
    return scene;
}

} // namespace

/// Which parts of the body stick through cloth.
class tst_BodyThrough : public QObject {
    Q_OBJECT
private slots:
    void aSheetRoundALimbIsPierced();
    void aHandCountsToItsArm();
    void whatOnlyCutsABendOfTheSkinIsNot();
    void aBodyWithoutLimbsIsTheBody();
    void trianglesWithoutAreaDoNotCount();
    void noneWhereNothingMeets();
    void theWarningsNamePartAndPiece();
};

void tst_BodyThrough::aSheetRoundALimbIsPierced() {
    const Vec3 ankles = lerp(usualBody().landmarks.ankleLeft, usualBody().landmarks.ankleRight, 0.5);
    const auto legs = bodyThrough(simulationOf(sheetAround(lerp(usualBody().landmarks.crotch, ankles, 0.5))));
    QVERIFY(legs == (std::vector{BodyThrough{Limb::leftLeg, 0}, BodyThrough{Limb::rightLeg, 0}}));
    QVERIFY(bodyThrough(simulationOf(sheetAround(ankles + Vec3{0, 0.2, 0}))) == legs);
}

void tst_BodyThrough::aHandCountsToItsArm() {
    const auto arm = bodyThrough(simulationOf(sheetAround(usualBody().landmarks.wristLeft + Vec3{0.1, -0.05, 0})));
    QVERIFY(arm == (std::vector{BodyThrough{Limb::leftArm, 0}}));
}

void tst_BodyThrough::whatOnlyCutsABendOfTheSkinIsNot() {
    const Simulation simulation = simulationOf(sheetInBall(0.09));
    QVERIFY(contactOf(simulation).bodyIntersections > 0);
    QVERIFY(bodyThrough(simulation).empty());
}

void tst_BodyThrough::aBodyWithoutLimbsIsTheBody() {
    const auto through = bodyThrough(simulationOf(sheetInBall(0)));
    QVERIFY(through == (std::vector{BodyThrough{std::nullopt, 0}}));
    QCOMPARE(partOf(through[0]), std::string("body"));
}

void tst_BodyThrough::trianglesWithoutAreaDoNotCount() {
    Scene scene = sheetInBall(0);
    body::Body ball = **scene.body;
    for (std::size_t t = 0, count = ball.mesh.triangles.size(); t < count; ++t) {
        const auto [a, b, c] = ball.mesh.triangles[t];
        ball.mesh.triangles.push_back({a, a, b});
    }
    scene.body = Shared<body::Body>(std::move(ball));
    const Simulation simulation = simulationOf(scene);
    QVERIFY(contactOf(simulation).bodyIntersections > contactOf(simulationOf(sheetInBall(0))).bodyIntersections);
    QVERIFY(bodyThrough(simulation) == (std::vector{BodyThrough{std::nullopt, 0}}));
}

void tst_BodyThrough::noneWhereNothingMeets() {
    QVERIFY(bodyThrough(simulationOf(sheetAround(usualBody().landmarks.waist + Vec3{0, 1, 0}))).empty());
    Scene alone = sheetOnTable();
    alone.body = {};
    QVERIFY(bodyThrough(simulationOf(alone)).empty());
}

void tst_BodyThrough::theWarningsNamePartAndPiece() {
    const Simulation simulation = simulationOf(sheetAround(usualBody().landmarks.wristRight + Vec3{-0.1, 0.05, 0}));
    const std::vector<Warning> warnings = warningsOf(simulation, contactOf(simulation));
    QVERIFY(std::ranges::any_of(warnings, [](const Warning& warning) {
        return warning.place == "piece \"sheet\"" && warning.text.starts_with("The right arm sticks through its cloth");
    }));
    QVERIFY(std::ranges::any_of(
        warnings, [](const Warning& warning) { return warning.text.ends_with("The body sticks through it."); }));
}

TOILE_TEST(tst_BodyThrough, QCoreApplication)
#include "tst_BodyThrough.moc"
