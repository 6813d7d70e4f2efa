// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/view3d/Navigation.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

class tst_Navigation : public QObject {
    Q_OBJECT
private slots:
    void buttonsMeanWhatTheHabitsSay_data();
    void buttonsMeanWhatTheHabitsSay();
    void theWheelTurnedAwayComesNearer();
    void draggingUpwardZoomsIn();
    void noMotionChangesNothing();
};

void tst_Navigation::buttonsMeanWhatTheHabitsSay_data() {
    QTest::addColumn<CameraHabits>("habits");
    QTest::addColumn<PointerPress>("press");
    QTest::addColumn<CameraMotion>("motion");
    const auto row = [](const char* what, CameraHabits habits, PointerPress press, CameraMotion motion) {
        QTest::newRow(what) << habits << press << motion;
    };
    row("CLO: right drag orbits", CameraHabits::clo, {.right = true}, CameraMotion::orbit);
    row("CLO: middle drag pans", CameraHabits::clo, {.middle = true}, CameraMotion::pan);
    row("CLO: left drag is for tools", CameraHabits::clo, {.left = true}, CameraMotion::none);
    row("Blender: middle drag orbits", CameraHabits::blender, {.middle = true}, CameraMotion::orbit);
    row("Blender: with Shift it pans", CameraHabits::blender, {.middle = true, .shift = true}, CameraMotion::pan);
    row("Blender: with Ctrl it zooms", CameraHabits::blender, {.middle = true, .control = true}, CameraMotion::zoom);
    row("Blender: right drag is free", CameraHabits::blender, {.right = true}, CameraMotion::none);
    row("Maya: Alt and left drag orbit", CameraHabits::maya, {.left = true, .alt = true}, CameraMotion::orbit);
    row("Maya: Alt and middle drag pan", CameraHabits::maya, {.middle = true, .alt = true}, CameraMotion::pan);
    row("Maya: Alt and right drag zoom", CameraHabits::maya, {.right = true, .alt = true}, CameraMotion::zoom);
    row("Maya: without Alt left drag is for tools", CameraHabits::maya, {.left = true}, CameraMotion::none);
}

void tst_Navigation::buttonsMeanWhatTheHabitsSay() {
    QFETCH(CameraHabits, habits);
    QFETCH(PointerPress, press);
    QFETCH(CameraMotion, motion);
    QCOMPARE(motionFor(habits, press), motion);
}

void tst_Navigation::theWheelTurnedAwayComesNearer() {
    QVERIFY(wheeled({}, {800, 600}, {400, 300}, 1).distance < 3);
    QVERIFY(wheeled({}, {800, 600}, {400, 300}, -1).distance > 3);
}

void tst_Navigation::draggingUpwardZoomsIn() {
    QVERIFY(moved({}, {800, 600}, CameraMotion::zoom, {10, 300}, {10, 250}).distance < 3);
}

void tst_Navigation::noMotionChangesNothing() {
    QVERIFY(moved({}, {800, 600}, CameraMotion::none, {10, 300}, {70, 250}) == picture::Camera{});
}

TOILE_TEST(tst_Navigation)
#include "tst_Navigation.moc"
