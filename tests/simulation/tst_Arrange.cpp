// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/body/Arrangement.h"
#include "core/body/Mannequin.h"
#include "core/collision/BodySurface.h"
#include "core/simulation/Arrange.h"
#include "tests/Suite.h"
#include "tests/simulation/UsualBody.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;

namespace {

body::Body shifted(body::Body body, const Vec3& by) {
    for (Vec3& p : body.mesh.vertices) p += by;
    body::Landmarks& m = body.landmarks;
    for (Vec3* p :
         {&m.nape, &m.frontNeck, &m.neckLeft, &m.neckRight, &m.acromionLeft, &m.acromionRight, &m.bustLeft,
          &m.bustRight, &m.waist, &m.hip, &m.crotch, &m.wristLeft, &m.wristRight, &m.ankleLeft, &m.ankleRight})
        *p += by;
    for (body::LimbAxis& axis : body.axes)
        for (Vec3& p : axis.points) p += by;
    return body;
}

/// The forearm turned to the front about an upright line through the middle of the arm.
body::Body withLeftElbowBent(body::Body body, double angle) {
    const Transform arm = *body::limbFrame(body, body::Limb::leftArm);
    const double half = 0.5 * body::limbLength(body, body::Limb::leftArm);
    const auto bend = [&](Vec3& p) {
        const double along = dot(p - arm.origin, arm.axisY);
        if (p.x < arm.origin.x || length(p - arm.origin - arm.axisY * along) > 0.15) return; // not of the arm
        const double turn =
            angle * std::clamp((along - half) / 0.1 + 0.5, 0.0, 1.0); // over 10 cm, so that nothing folds
        const Vec3 elbow = arm.point({0, half, 0}), d = p - elbow;
        // About x of the limb's frame, which is square to the arm and level: y goes to the front.
        const double y = dot(d, arm.axisY), z = dot(d, arm.axisZ);
        p = elbow + arm.axisX * dot(d, arm.axisX) + arm.axisY * (y * std::cos(turn) - z * std::sin(turn)) +
            arm.axisZ * (y * std::sin(turn) + z * std::cos(turn));
    };
    std::ranges::for_each(body.mesh.vertices, bend);
    bend(body.landmarks.wristLeft);
    for (body::LimbAxis& axis : body.axes)
        if (axis.limb == body::Limb::leftArm) {
            const Vec3 root = axis.points.front(), end = axis.points.back();
            axis.points.clear();
            for (int i = 0; i <= 20; ++i) axis.points.push_back(lerp(root, end, i / 20.0));
            std::ranges::for_each(axis.points, bend);
        }
    return body;
}

pattern::Pattern onlyPiece(pattern::Piece piece) {
    pattern::Pattern pattern;
    pattern.fabrics.push_back(plainCloth());
    pattern.pieces.push_back(std::move(piece));
    return pattern;
}

/// A square a hand's breadth before the belly.
pattern::Pattern apron() {
    pattern::Piece piece = polygonPiece("apron", {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}, 0.05);
    piece.placement = pattern::Placement{};
    piece.placement->transform.origin = usualBody().landmarks.waist + Vec3{0, 0, 0.2};
    return onlyPiece(std::move(piece));
}

/// A tube round the left arm, its axis half-way down it: wide enough for it, and not quite closed.
pattern::Pattern armlet() {
    const Transform arm = *body::limbFrame(usualBody(), body::Limb::leftArm);
    constexpr double radius = 0.07;
    pattern::Piece piece = polygonPiece("armlet", {{-0.2, -0.04}, {0.2, -0.04}, {0.2, 0.04}, {-0.2, 0.04}}, 0.02);
    piece.placement = pattern::Placement{{-arm.axisX, -arm.axisY, arm.axisZ, {}}, pattern::Curl{{0, 1}, radius}};
    piece.placement->transform.origin = arm.point({0, 0.25, radius});
    return onlyPiece(std::move(piece));
}

Vec3 originOf(const pattern::Pattern& pattern) {
    return pattern.pieces[0]->placement->transform.origin;
}

double leastClearance(const pattern::Pattern& pattern, const body::Body& body) {
    const auto surface = collision::BodySurface::create(body.mesh);
    double least = 1;
    const pattern::Piece& piece = *pattern.pieces[0];
    const geometry::Box2 box = [&] {
        std::vector<Vec2> corners;
        for (const auto& vertex : piece.outline.vertices) corners.push_back(vertex.position);
        return geometry::boundsOf(corners);
    }();
    for (int i = 0; i <= 40; ++i)
        for (int k = 0; k <= 10; ++k) {
            const Vec2 at{box.low.x + (box.high.x - box.low.x) * i / 40, box.low.y + (box.high.y - box.low.y) * k / 10};
            if (const auto near = surface->nearest(pattern::placed(*piece.placement, at), 0.2))
                least = std::min(least, near->signedDistance);
        }
    return least;
}

} // namespace

class tst_Arrange : public QObject {
    Q_OBJECT
private slots:
    void onTheSameBodyNothingChanges();
    void onAShiftedBodyPiecesGoAlong();
    void aPieceFollowsTheLimbThatItIsNearestTo();
    void onALargerBodyATubeIsWiderAndStaysClear();
    void onASlimmerBodyATubeIsNotRolledTighter();
    void aPieceThatWouldStartInTheBodyIsMovedOut();
    void aNarrowBandThatCrossesTheBodyIsMovedOut();
    void onABentArmASleeveFollowsItAndKeepsItsGirth();
    void aTrouserLegStartsOnItsOwnSide();
    void aSkirtThatSpansBothLegsStays();
    void piecesWithoutPlacementStayWithout();
    void withoutLimbsNothingChanges();
};

void tst_Arrange::onTheSameBodyNothingChanges() {
    for (const pattern::Pattern& pattern : {apron(), armlet()}) {
        const pattern::Pattern arranged = arrangedOn(pattern, usualBody(), usualBody());
        const pattern::Placement &before = *pattern.pieces[0]->placement, &after = *arranged.pieces[0]->placement;
        constexpr double rounding = 1e-12;
        QVERIFY(geometry::distance(before.transform.origin, after.transform.origin) < rounding);
        QVERIFY(geometry::distance(before.transform.axisX, after.transform.axisX) < rounding);
        QVERIFY(geometry::distance(before.transform.axisZ, after.transform.axisZ) < rounding);
        QCOMPARE(after.curl.has_value(), before.curl.has_value());
        if (before.curl) QVERIFY(std::abs(after.curl->radius - before.curl->radius) < rounding);
    }
}

void tst_Arrange::onAShiftedBodyPiecesGoAlong() {
    const Vec3 by{0.4, 0.1, -0.3};
    for (const pattern::Pattern& pattern : {apron(), armlet()}) {
        const pattern::Pattern arranged = arrangedOn(pattern, usualBody(), shifted(usualBody(), by));
        QVERIFY(geometry::distance(originOf(arranged), originOf(pattern) + by) < 1e-9); // sections are cut anew
    }
}

void tst_Arrange::aPieceFollowsTheLimbThatItIsNearestTo() {
    const body::Body other = body::makeMannequin({.height = 1.72, .arm = 0.64, .armAngle = 0.9})->body;
    const pattern::Pattern arranged = arrangedOn(armlet(), usualBody(), other);
    const Transform arm = *body::limbFrame(other, body::Limb::leftArm);
    const Vec3 d = originOf(arranged) - arm.origin;
    const double along = dot(d, arm.axisY) / body::limbLength(other, body::Limb::leftArm);
    QVERIFY(std::abs(along - 0.25 / body::limbLength(usualBody(), body::Limb::leftArm)) < 1e-9);
    QVERIFY(std::abs(dot(arranged.pieces[0]->placement->transform.axisY, arm.axisY) + 1) < 1e-9); // still along it
}

void tst_Arrange::onALargerBodyATubeIsWiderAndStaysClear() {
    const body::Body full = body::makeMannequin({.biceps = 0.35, .wrist = 0.19})->body;
    const pattern::Pattern arranged = arrangedOn(armlet(), usualBody(), full);
    QVERIFY(arranged.pieces[0]->placement->curl->radius > armlet().pieces[0]->placement->curl->radius);
    QVERIFY(leastClearance(arranged, full) > 0.003); // the skin offset
}

void tst_Arrange::onASlimmerBodyATubeIsNotRolledTighter() {
    const body::Body slim = body::makeMannequin({.biceps = 0.24, .wrist = 0.145})->body;
    const pattern::Pattern arranged = arrangedOn(armlet(), usualBody(), slim);
    QCOMPARE(arranged.pieces[0]->placement->curl->radius, armlet().pieces[0]->placement->curl->radius);
}

void tst_Arrange::aPieceThatWouldStartInTheBodyIsMovedOut() {
    pattern::Pattern close = apron();
    pattern::Piece piece = *close.pieces[0];
    piece.placement->transform.origin.z -= 0.14; // touches the belly
    close.pieces[0] = piece;
    const body::Body moved = shifted(usualBody(), {0.2, 0, 0});
    QVERIFY(leastClearance(close, usualBody()) < 0);
    const pattern::Pattern arranged = arrangedOn(close, usualBody(), moved);
    QVERIFY(leastClearance(arranged, moved) > 0.003);
    QVERIFY(originOf(arranged).z > originOf(close).z);
}

void tst_Arrange::aNarrowBandThatCrossesTheBodyIsMovedOut() { // its corners are clear, its long edges are not
    pattern::Piece band = polygonPiece("band", {{-0.3, 0}, {0.3, 0}, {0.3, 0.004}, {-0.3, 0.004}}, 0.02);
    band.placement = pattern::Placement{};
    band.placement->transform.origin = usualBody().landmarks.waist + Vec3{0, 0, 0.05};
    const pattern::Pattern pattern = onlyPiece(std::move(band));
    QVERIFY(leastClearance(pattern, usualBody()) < 0);
    QVERIFY(leastClearance(startingClearOf(pattern, usualBody()), usualBody()) > 0.003);
}

void tst_Arrange::onABentArmASleeveFollowsItAndKeepsItsGirth() {
    pattern::Pattern sleeve = armlet();
    pattern::Piece longer = *sleeve.pieces[0];
    for (auto& vertex : longer.outline.vertices)
        vertex.position.y = vertex.position.y < 0 ? -0.22 : 0.08; // over the elbow
    sleeve.pieces[0] = longer;
    const body::Body bent = withLeftElbowBent(usualBody(), 0.6);
    const pattern::Pattern arranged = arrangedOn(sleeve, usualBody(), bent);
    const pattern::Placement& placement = *arranged.pieces[0]->placement;
    QVERIFY(placement.curl->bent);
    QVERIFY(leastClearance(arranged, bent) > 0.003); // the skin offset
    for (const double y : {-0.22, -0.05, 0.08}) {
        double girth = 0;
        for (int i = 0; i < 400; ++i)
            girth += geometry::distance(pattern::placed(placement, {-0.2 + 0.001 * i, y}),
                                        pattern::placed(placement, {-0.199 + 0.001 * i, y}));
        QVERIFY(std::abs(girth - 0.4) < 1e-5);
    }
}

void tst_Arrange::aTrouserLegStartsOnItsOwnSide() {
    pattern::Piece leg = polygonPiece("leg", {{-0.05, -0.7}, {0.2, -0.7}, {0.2, 0.2}, {0.02, 0.2}}, 0.02);
    leg.placement = pattern::Placement{};
    leg.placement->transform.origin = usualBody().landmarks.crotch + Vec3{0, 0, 0.3};
    const pattern::Pattern arranged = startingClearOf(onlyPiece(leg), usualBody());
    QVERIFY(std::abs(originOf(arranged).x - (usualBody().landmarks.crotch.x + 0.05)) < 1e-12);
}

void tst_Arrange::aSkirtThatSpansBothLegsStays() {
    pattern::Piece skirt = polygonPiece("skirt", {{-0.2, -0.5}, {0.3, -0.5}, {0.3, 0.2}, {-0.2, 0.2}}, 0.02);
    skirt.placement = pattern::Placement{};
    skirt.placement->transform.origin = usualBody().landmarks.crotch + Vec3{0, 0, 0.3};
    const pattern::Pattern pattern = onlyPiece(std::move(skirt));
    QCOMPARE(originOf(startingClearOf(pattern, usualBody())), originOf(pattern));
}

void tst_Arrange::piecesWithoutPlacementStayWithout() {
    pattern::Pattern pattern = apron();
    pattern::Piece piece = *pattern.pieces[0];
    piece.placement.reset();
    pattern.pieces[0] = piece;
    QVERIFY(!arrangedOn(pattern, usualBody(), shifted(usualBody(), {1, 0, 0})).pieces[0]->placement);
}

void tst_Arrange::withoutLimbsNothingChanges() {
    body::Body table = usualBody();
    table.axes.clear();
    QCOMPARE(originOf(arrangedOn(apron(), usualBody(), table)), originOf(apron()));
    QCOMPARE(originOf(arrangedOn(apron(), table, usualBody())), originOf(apron()));
}

TOILE_TEST(tst_Arrange)
#include "tst_Arrange.moc"
