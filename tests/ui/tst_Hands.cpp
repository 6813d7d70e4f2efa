// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowFixture.h"
#include "tests/Suite.h"
#include "ui/window/HandLink.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

/// Cloth dragged with the mouse in the 3D view while it is simulated.
class tst_Hands : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { prepareApplication(); }
    void draggedClothFollowsThePointer();
    void shiftLeavesAPinThatAClickTakesOut();
    void aPinIsDraggedToAnotherPlace();
    void escapeLetsGo();
    void aResetFreesAll();
    void whatDoesNotPlayIsNotGrabbed();

private:
    /// Two squares that were sewn together and float, at play.
    struct Floating : Bench {
        Floating() {
            const QString file = qEnvironmentVariable("TOILE_SOURCE_DIR") + "/samples/two-squares.toile";
            if (!workbench.openCopy(file)) qFatal("cannot open %s", qPrintable(file));
            workbench.play();
            if (!reaches([this] { return workbench.frame()->time > 2; })) qFatal("it does not play");
            window.view3D().viewFront();
            window.view3D().fit();
        }
        bool reaches(const std::function<bool()>& wanted) {
            return QTest::qWaitFor([&] { return workbench.frame() && wanted(); }, 30000);
        }
        [[nodiscard]] Vec3 place() const { return workbench.frame()->positions[middle()]; }
        [[nodiscard]] std::size_t middle() const {
            const auto& frame = *workbench.frame();
            const auto& material = frame.topology->material;
            const auto end = material.begin() + frame.topology->pieces[0].vertexCount;
            Vec2 centre;
            for (auto at = material.begin(); at != end; ++at) centre = centre + *at / double(end - material.begin());
            return static_cast<std::size_t>(
                std::ranges::min_element(material.begin(), end, {}, [&](Vec2 p) { return distance(p, centre); }) -
                material.begin());
        }
        void press(QPoint at) { QTest::mousePress(&window.view3D(), Qt::LeftButton, {}, at); }
        void moveTo(QPoint from, QPoint to) {
            for (int i = 1; i <= 5; ++i) {
                const QPointF at = QPointF(from) + QPointF(to - from) * i / 5;
                QMouseEvent move(QEvent::MouseMove, at, window.view3D().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                                 Qt::NoModifier);
                QApplication::sendEvent(&window.view3D(), &move);
            }
        }
        void release(QPoint at, Qt::KeyboardModifiers modifiers = {}) {
            QTest::mouseRelease(&window.view3D(), Qt::LeftButton, modifiers, at);
        }
        void drag(QPoint from, QPoint to, Qt::KeyboardModifiers atTheEnd) {
            press(from);
            moveTo(from, to);
            release(to, atTheEnd);
        }
        const std::vector<HeldPlace>& pins() { return window.findChild<HandLink*>()->pins(); }
    };
};

void tst_Hands::draggedClothFollowsThePointer() {
    Floating cloth;
    const Vec3 before = cloth.place(), aim = before + Vec3{0, 0.1, 0};
    const QPoint from = cloth.pixelOf(before), to = cloth.pixelOf(aim);
    cloth.press(from);
    cloth.moveTo(from, to);
    QVERIFY(cloth.reaches([&] { return distance(cloth.place(), aim) < 0.02; }));
    QVERIFY(!cloth.window.view3D().scene().overlay.empty());
    cloth.picture("hand.png");
    cloth.release(to);
    QVERIFY(cloth.window.view3D().scene().overlay.empty());
    QVERIFY(cloth.pins().empty());
    QVERIFY(cloth.workbench.selection().empty()); // it was no click
}

void tst_Hands::shiftLeavesAPinThatAClickTakesOut() {
    Floating cloth;
    const Vec3 before = cloth.place(), aim = before + Vec3{0, 0.1, 0};
    const QPoint from = cloth.pixelOf(before), to = cloth.pixelOf(aim);
    cloth.drag(from, to, Qt::ShiftModifier);
    QCOMPARE(cloth.pins().size(), std::size_t{1});
    QVERIFY(cloth.reaches([&] { return distance(cloth.place(), aim) < 0.02; }));
    QVERIFY(!cloth.window.view3D().scene().overlay.empty());
    QTest::mouseClick(&cloth.window.view3D(), Qt::LeftButton, {}, to);
    QVERIFY(cloth.pins().empty());
    QVERIFY(cloth.window.view3D().scene().overlay.empty());
}

void tst_Hands::aPinIsDraggedToAnotherPlace() {
    Floating cloth;
    const Vec3 before = cloth.place(), first = before + Vec3{0, 0.1, 0}, second = before + Vec3{0.05, 0.15, 0};
    const QPoint from = cloth.pixelOf(before), to = cloth.pixelOf(first), on = cloth.pixelOf(second);
    cloth.drag(from, to, Qt::ShiftModifier);
    cloth.drag(to, on, {});
    QCOMPARE(cloth.pins().size(), std::size_t{1}); // without Shift, too: it was one before
    QVERIFY(distance(cloth.pins()[0].target, second) < 0.01);
    QVERIFY(cloth.reaches([&] { return distance(cloth.place(), second) < 0.02; }));
}

void tst_Hands::escapeLetsGo() {
    Floating cloth;
    const QPoint from = cloth.pixelOf(cloth.place()), to = from + QPoint(40, 0);
    cloth.press(from);
    cloth.moveTo(from, to);
    QTest::keyClick(&cloth.window.view3D(), Qt::Key_Escape);
    QVERIFY(cloth.window.view3D().scene().overlay.empty());
    cloth.release(to, Qt::ShiftModifier);
    QVERIFY(cloth.pins().empty());
}

void tst_Hands::aResetFreesAll() {
    Floating cloth;
    const QPoint from = cloth.pixelOf(cloth.place()), to = from + QPoint(40, 0);
    cloth.drag(from, to, Qt::ShiftModifier);
    QCOMPARE(cloth.pins().size(), std::size_t{1});
    cloth.workbench.reset();
    QVERIFY(cloth.reaches([&] { return cloth.workbench.frame()->time == 0; }));
    QVERIFY(cloth.pins().empty());
}

void tst_Hands::whatDoesNotPlayIsNotGrabbed() {
    Floating cloth;
    cloth.workbench.pause();
    const QPoint from = cloth.pixelOf(cloth.place()), to = from + QPoint(40, 0);
    cloth.press(from);
    cloth.moveTo(from, to);
    QVERIFY(cloth.window.view3D().scene().overlay.empty());
    cloth.release(to, Qt::ShiftModifier);
    QVERIFY(cloth.pins().empty());
}

TOILE_TEST(tst_Hands, QApplication)
#include "tst_Hands.moc"
