// SPDX-License-Identifier: GPL-3.0-or-later
#include "WorkbenchFixture.h"
#include "core/body/Mannequin.h"
#include "core/document/DocumentEdits.h"
#include "tests/Suite.h"

#include <QSignalSpy>
#include <QTest>

#include <future>

using namespace toile;
using namespace toile::ui;

namespace {

simulation::Frame wornFrameOf(std::uint64_t generation) {
    simulation::Frame frame = frameOf(generation);
    frame.phase = simulation::Phase::draping;
    return frame;
}

/// A garment on an avatar of one vertex, with a motion of it that is read.
struct Dressed : Fixture {
    const geometry::VertexMotion walk{0.5, {{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}}}};
    std::optional<Workbench> workbench;
    explicit Dressed(std::function<Result<geometry::VertexMotion>()> read = {}) {
        auto made = parts();
        made.readBody = [](const std::string&) {
            body::Body body;
            body.mesh.vertices = {{0, 0, 0}};
            return Result<body::Body>(std::move(body));
        };
        made.readMotion = [this, read = std::move(read)](const std::string&, const body::Body&, double) {
            return read ? read() : Result<geometry::VertexMotion>(walk);
        };
        workbench.emplace(std::move(made));
        workbench->startFrom(document::withAvatar(twoRectangles(), "body.glb"), {}, false);
        (void)QTest::qWaitFor([this] { return workbench->body().has_value(); });
    }
    void show(simulation::Frame frame) {
        log.frame = std::move(frame);
        workbench->pollFrame();
    }
    void showWorn() { show(wornFrameOf(workbench->generation())); }
    void showMoved(bool moves) {
        simulation::Frame frame = wornFrameOf(workbench->generation());
        frame.body = Shared<body::Body>();
        frame.bodyMoves = moves;
        show(frame);
    }
};

} // namespace

/// When the avatar may move, and through what.
class tst_WorkbenchMotion : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void armsAreLiftedAndLetDownAgain();
    void theAvatarStaysWhileItCannotMove();
    void posesAreReadAndGoneThroughAndBack();
    void posesOfAnAvatarBeforeMoveNothing();
};

void tst_WorkbenchMotion::armsAreLiftedAndLetDownAgain() {
    Fixture fixture;
    Workbench bench(fixture.parts());
    QSignalSpy told(&bench, &Workbench::messageChanged);
    bench.liftArms();
    QCOMPARE(told.size(), 1); // there is nothing yet
    QVERIFY(!fixture.log.motion);

    auto mannequin = body::makeMannequin({});
    QVERIFY(mannequin.has_value());
    Fixture dressed;
    auto parts = dressed.parts();
    parts.readBody = [&](const std::string&) -> Result<body::Body> { return mannequin->body; };
    Workbench workbench(std::move(parts));
    QSignalSpy read(&workbench, &Workbench::bodyChanged);
    workbench.startFrom(document::withAvatar(twoRectangles(), "body.glb"), {}, false);
    QTRY_VERIFY(workbench.body().has_value());
    dressed.log.frame = wornFrameOf(workbench.generation());
    workbench.pollFrame();
    workbench.liftArms();
    QVERIFY(dressed.log.motion);
    const auto up = dressed.log.motion;
    QVERIFY(up->poses.front() == mannequin->body.mesh.vertices);
    QVERIFY(std::ranges::max(up->poses.back(), {}, &Vec3::x).y > mannequin->body.landmarks.wristLeft.y + 0.3);

    dressed.log.frame = wornFrameOf(workbench.generation());
    dressed.log.frame->body = Shared<body::Body>(mannequin->body);
    workbench.pollFrame();
    QVERIFY(workbench.bodyHasMoved());
    QVERIFY(workbench.armsAreUp());
    workbench.liftArms();
    QVERIFY(dressed.log.motion->poses.front() == up->poses.back());
    QVERIFY(dressed.log.motion->poses.back() == up->poses.front());
}

void tst_WorkbenchMotion::theAvatarStaysWhileItCannotMove() {
    Fixture bare;
    Workbench empty(bare.parts());
    QVERIFY(empty.whyNotMoved().contains("no avatar"));

    Dressed dressed;
    Workbench& workbench = *dressed.workbench;
    QVERIFY(workbench.whyNotMoved().contains("no garment"));
    dressed.show(frameOf(workbench.generation()));
    QVERIFY(workbench.whyNotMoved().contains("until its seams are closed"));
    QSignalSpy told(&workbench, &Workbench::messageChanged);
    workbench.moveThroughPoses(QStringLiteral("walk"), 0.5);
    QCOMPARE(told.size(), 1);
    QCOMPARE(told[0][0].toString(), workbench.whyNotMoved());
    QVERIFY(told[0][1].toBool());

    dressed.showWorn();
    QVERIFY(workbench.whyNotMoved().isEmpty());
    QVERIFY(workbench.whyNotMovedBack().contains("as it did at first"));
    workbench.drapeWith(dynamics::Method::trBdf2);
    QVERIFY(dressed.log.method == dynamics::Method::trBdf2);
    QVERIFY(workbench.whyNotMoved().contains("only the fast method"));
    workbench.drapeWith(dynamics::Method::xpbd);
    QVERIFY(workbench.whyMethodStays().isEmpty());
    workbench.moveBack();
    QVERIFY(!dressed.log.motion);
    dressed.showMoved(true);
    QVERIFY(workbench.whyNotMoved().contains("moving already"));
    QVERIFY(!workbench.whyMethodStays().isEmpty());
    dressed.showMoved(false);
    QVERIFY(workbench.whyNotMoved().contains("move it back first"));
}

void tst_WorkbenchMotion::posesAreReadAndGoneThroughAndBack() {
    std::promise<void> mayRead;
    auto reading = mayRead.get_future().share();
    Dressed* self = nullptr;
    Dressed dressed([&] {
        reading.wait();
        return Result<geometry::VertexMotion>(self->walk);
    });
    self = &dressed;
    Workbench& workbench = *dressed.workbench;
    dressed.showWorn();
    QSignalSpy read(&workbench, &Workbench::posesRead);
    workbench.moveThroughPoses(QStringLiteral("walk"), 0.5);
    QVERIFY(workbench.whyNotMoved().contains("being read"));
    QVERIFY(!dressed.log.motion);
    mayRead.set_value();
    QTRY_COMPARE(read.size(), 2);
    QVERIFY(dressed.log.motion);
    QVERIFY(*dressed.log.motion == dressed.walk);
    dressed.showMoved(true);
    QVERIFY(!workbench.whyNotMovedBack().isEmpty());
    dressed.showMoved(false);
    QVERIFY(!workbench.armsAreUp());
    workbench.moveBack();
    QVERIFY(dressed.log.motion->poses.front() == dressed.walk.poses.back());
    QVERIFY(dressed.log.motion->poses.back() == dressed.walk.poses.front());
}

void tst_WorkbenchMotion::posesOfAnAvatarBeforeMoveNothing() {
    std::promise<void> mayRead;
    auto reading = mayRead.get_future().share();
    Dressed dressed([&] {
        reading.wait();
        return Result<geometry::VertexMotion>(geometry::VertexMotion{0.5, {{{0, 0, 0}}, {{0, 0, 1}}}});
    });
    Workbench& workbench = *dressed.workbench;
    dressed.showWorn();
    workbench.moveThroughPoses(QStringLiteral("walk"), 0.5);
    QSignalSpy told(&workbench, &Workbench::messageChanged);
    workbench.removeAvatar();
    mayRead.set_value();
    QTRY_VERIFY(!told.isEmpty());
    QVERIFY(told.back()[0].toString().contains("avatar before"));
    QVERIFY(!dressed.log.motion);
}

TOILE_TEST(tst_WorkbenchMotion, QCoreApplication)
#include "tst_WorkbenchMotion.moc"
