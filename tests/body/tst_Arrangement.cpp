// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/Arrangement.h"
#include "tests/Suite.h"

#include "core/body/Mannequin.h"
#include "tests/body/SampleMeasurements.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace toile;
using namespace toile::body;

namespace {

const Body& usual() {
    static const Body body = makeMannequin(sampleMeasurements()[0].measurements)->body;
    return body;
}

const Body& tall() {
    static const Body body = makeMannequin(sampleMeasurements()[2].measurements)->body;
    return body;
}

constexpr std::array limbs{Limb::neck, Limb::torso, Limb::leftArm, Limb::rightArm, Limb::leftLeg, Limb::rightLeg};

bool isNear(const Vec3& a, const Vec3& b, double tolerance) {
    return distance(a, b) <= tolerance;
}

} // namespace

class tst_Arrangement : public QObject {
    Q_OBJECT
private slots:
    void framesAreRightHandedAndFaceTheFront();
    void leftAndRightFramesMirror();
    void volumesHoldTheirLimb();
    void carryingOverToTheSameBodyChangesNothing();
    void landmarksOfALimbAreCarriedToThoseOfTheOther();
    void placementsStayRigid();
    void sizesCompareLikeGirths();
    void aTableHasNoLimbs();
};

void tst_Arrangement::framesAreRightHandedAndFaceTheFront() {
    for (const Limb limb : limbs) {
        const Transform f = *limbFrame(usual(), limb);
        QVERIFY(isNear(cross(f.axisX, f.axisY), f.axisZ, 1e-12)); // rounding
        QVERIFY(std::abs(length(f.axisX) - 1) < 1e-12 && std::abs(dot(f.axisX, f.axisY)) < 1e-12);
        QVERIFY(f.axisZ.z > 0.9);
    }
    QVERIFY(limbFrame(usual(), Limb::torso)->axisY.y > 0.999);
    QVERIFY(limbFrame(usual(), Limb::leftLeg)->axisY.y < -0.99);
    QVERIFY(limbFrame(usual(), Limb::leftArm)->axisY.x > 0.6);
}

void tst_Arrangement::leftAndRightFramesMirror() {
    const Transform left = *limbFrame(usual(), Limb::leftArm), right = *limbFrame(usual(), Limb::rightArm);
    QVERIFY(isNear({-left.origin.x, left.origin.y, left.origin.z}, right.origin, 1e-12));
    QVERIFY(isNear({-left.axisY.x, left.axisY.y, left.axisY.z}, right.axisY, 1e-12));
}

void tst_Arrangement::volumesHoldTheirLimb() {
    const auto volumes = arrangementVolumes(usual());
    QCOMPARE(volumes.size(), limbs.size());
    const auto torso = std::ranges::find(volumes, Limb::torso, &ArrangementVolume::limb);
    const ArrangementRing& waist = torso->rings.front();
    QVERIFY(waist.side > 0.12 && waist.side < 0.14); // of a waist of 0.72 m
    QVERIFY(std::abs(torso->length - 0.41) < 0.005); // nape to waist as asked
    const auto arm = std::ranges::find(volumes, Limb::leftArm, &ArrangementVolume::limb);
    QVERIFY(arm->rings.back().side < 0.03); // a wrist
    for (const ArrangementVolume& v : volumes) QVERIFY(std::ranges::is_sorted(v.rings, {}, &ArrangementRing::at));
}

void tst_Arrangement::carryingOverToTheSameBodyChangesNothing() {
    for (const Limb limb : limbs) {
        const Transform same = *carriedOver(usual(), usual(), limb);
        for (const Vec3& p : {Vec3{0.1, 1.2, 0.3}, Vec3{-0.4, 0.9, 0}, Vec3{0, 0, 1}})
            QVERIFY(isNear(same.point(p), p, 1e-12));
    }
}

void tst_Arrangement::landmarksOfALimbAreCarriedToThoseOfTheOther() {
    const Landmarks &a = usual().landmarks, &b = tall().landmarks;
    QVERIFY(isNear(carriedOver(usual(), tall(), Limb::leftArm)->point(a.wristLeft), b.wristLeft,
                   1e-9)); // ends of the line
    QVERIFY(isNear(carriedOver(usual(), tall(), Limb::rightLeg)->point(a.ankleRight), b.ankleRight, 1e-9));
    QVERIFY(isNear(carriedOver(usual(), tall(), Limb::torso)->point(a.waist), b.waist, 1e-9));
    // Not fixed by the frame: the bust point comes near the other's.
    QVERIFY(isNear(carriedOver(usual(), tall(), Limb::torso)->point(a.bustLeft), b.bustLeft, 0.02));
}

void tst_Arrangement::placementsStayRigid() {
    const Transform placement{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.3, 1.2, 0}};
    const Transform carried = *placementCarriedOver(placement, usual(), tall(), Limb::leftArm);
    QVERIFY(std::abs(length(carried.axisX) - 1) < 1e-12 && std::abs(dot(carried.axisX, carried.axisY)) < 1e-12);
    QVERIFY(isNear(cross(carried.axisX, carried.axisY), carried.axisZ, 1e-12));
    QVERIFY(isNear(carried.origin, carriedOver(usual(), tall(), Limb::leftArm)->point(placement.origin), 1e-12));
}

void tst_Arrangement::sizesCompareLikeGirths() {
    QVERIFY(std::abs(*sizeRatio(usual(), usual(), Limb::torso) - 1) < 1e-12);
    // Between waist and under-bust the tall body is 2.5–4 % wider; half-axes are not quite girths.
    QVERIFY(std::abs(*sizeRatio(usual(), tall(), Limb::torso) - 0.80 / 0.78) < 0.03);
}

void tst_Arrangement::aTableHasNoLimbs() {
    const Body table{.name = "table", .mesh = usual().mesh, .landmarks = {}, .axes = {}};
    QVERIFY(!limbFrame(table, Limb::torso));
    QVERIFY(arrangementVolumes(table).empty());
    QVERIFY(!carriedOver(usual(), table, Limb::torso));
}

TOILE_TEST(tst_Arrangement)
#include "tst_Arrangement.moc"
