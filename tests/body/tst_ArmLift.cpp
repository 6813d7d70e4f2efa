// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/ArmLift.h"
#include "core/body/Mannequin.h"
#include "tests/Suite.h"

#include <QTest>

#include <algorithm>
#include <numbers>

using namespace toile;
using namespace toile::body;

class tst_ArmLift : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void armsGoWhollyAndTheTrunkNotAtAll();
    void theHandIsLiftedByTheAngle();
    void theMotionBeginsAndEndsSoftly();
    void itIsTheSameOnBothSides();
    void whatCannotBeLiftedIsRefused();

private:
    Body body_;
};

void tst_ArmLift::initTestCase() {
    auto mannequin = makeMannequin({});
    QVERIFY(mannequin.has_value());
    body_ = std::move(mannequin->body);
}

void tst_ArmLift::armsGoWhollyAndTheTrunkNotAtAll() {
    const auto shares = armShares(body_);
    QVERIFY(shares.has_value());
    int between = 0;
    for (std::size_t v = 0; v < shares->size(); ++v) {
        const Vec3& at = body_.mesh.vertices[v];
        const double share = (*shares)[v];
        QVERIFY(std::abs(share) <= 1 + 1e-12);
        if (at.x > body_.landmarks.wristLeft.x - 0.1) QCOMPARE(share, 1.0);
        if (at.x < body_.landmarks.wristRight.x + 0.1) QCOMPARE(share, -1.0);
        if (at.y < body_.landmarks.waist.y && std::abs(at.x) < 0.2) QCOMPARE(share, 0.0);
        if (at.y > body_.landmarks.nape.y + 0.05) QCOMPARE(share, 0.0);
        between += std::abs(share) > 0.1 && std::abs(share) < 0.9;
    }
    QVERIFY(between > 100);
}

void tst_ArmLift::theHandIsLiftedByTheAngle() {
    constexpr double angle = std::numbers::pi / 2;
    const auto motion = armLift(body_, angle, 0.5);
    QVERIFY(motion.has_value());
    QCOMPARE(motion->duration(), 0.5);
    QVERIFY(geometry::checkedMotion(*motion, body_.mesh, 1e-12).has_value());
    const auto axis = std::ranges::find(body_.axes, Limb::leftArm, &LimbAxis::limb);
    const Vec3 joint = axis->points.front();
    const auto tip = std::ranges::max_element(body_.mesh.vertices, {}, &Vec3::x) - body_.mesh.vertices.begin();
    const Vec3 from = body_.mesh.vertices[tip] - joint, to = motion->poses.back()[tip] - joint;
    QVERIFY(std::abs(length(from) - length(to)) < 1e-9);
    QVERIFY(std::abs(std::atan2(to.y, to.x) - std::atan2(from.y, from.x) - angle) < 1e-9);
}

void tst_ArmLift::theMotionBeginsAndEndsSoftly() {
    const auto motion = armLift(body_, 1.5, 0.5);
    QVERIFY(motion.has_value());
    const double middle = motion->farthest(0.25 - 0.01, 0.25 + 0.01);
    QVERIFY(motion->farthest(0, 0.02) < 0.05 * middle);
    QVERIFY(motion->farthest(0.48, 0.5) < 0.05 * middle);
}

void tst_ArmLift::itIsTheSameOnBothSides() {
    const auto motion = armLift(body_, -0.5, 0.5);
    QVERIFY(motion.has_value());
    const auto& pose = motion->poses.back();
    const auto left = std::ranges::max(pose, {}, &Vec3::x), right = std::ranges::min(pose, {}, &Vec3::x);
    QVERIFY(std::abs(left.x + right.x) < 1e-3 && std::abs(left.y - right.y) < 1e-3);
    QVERIFY(left.x < std::ranges::max(body_.mesh.vertices, {}, &Vec3::x).x); // lowered
}

void tst_ArmLift::whatCannotBeLiftedIsRefused() {
    QVERIFY(!armLift(body_, 4, 1));
    QVERIFY(!armLift(body_, 1, 0));
    Body armless = body_;
    std::erase_if(armless.axes, [](const LimbAxis& axis) { return axis.limb == Limb::rightArm; });
    const auto refused = armLift(armless, 1, 1);
    QVERIFY(!refused);
    QVERIFY(refused.error().text.find("no arms") != std::string::npos);
}

TOILE_TEST(tst_ArmLift)
#include "tst_ArmLift.moc"
