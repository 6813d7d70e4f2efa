// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/view3d/PlacementGizmo.h"

#include <QTest>

#include <numbers>

using namespace toile;
using namespace toile::ui;
using picture::Camera;

namespace {

constexpr double gizmoRounding = 1e-9;
const Vec3 pivot{0.1, 1.2, 0.15};
const Transform start{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.1, 1.0, 0.2}}; // a quarter turn about y

/// From the front, a little from above and from the left: all six handles can be told apart.
GizmoView fromTheFront() {
    return {{.target = {0, 1, 0}, .distance = 2.5, .yaw = 0.5, .pitch = 0.4}, {800, 600}};
}

Vec2 seenAt(const GizmoView& view, const Vec3& point) {
    return worldToScreen(view.camera, view.viewport, point)->pixel;
}

/// A point of the world at so many pixels from the pivot along a direction.
Vec3 at(const GizmoView& view, const Vec3& direction, double pixels) {
    return pivot + normalized(direction) * (pixels * pixelSize(view.camera, view.viewport, pivot));
}

struct Grab {
    GizmoHandle handle;
    Vec3 direction; ///< from the pivot to a place of the handle that no other handle covers
    double pixels;
};
const std::vector<Grab> grabs{{GizmoHandle::moveX, {1, 0, 0}, 90}, {GizmoHandle::moveY, {0, 1, 0}, 90},
                              {GizmoHandle::moveZ, {0, 0, 1}, 90}, {GizmoHandle::turnX, {0, 1, 1}, 70},
                              {GizmoHandle::turnY, {1, 0, 1}, 70}, {GizmoHandle::turnZ, {1, 1, 0}, 70}};

bool isRigid(const Transform& t) {
    return std::abs(length(t.axisX) - 1) < gizmoRounding && std::abs(dot(t.axisX, t.axisY)) < gizmoRounding &&
           distance(cross(t.axisX, t.axisY), t.axisZ) < gizmoRounding;
}
bool near(const Transform& a, const Transform& b) {
    return distance(a.axisX, b.axisX) < gizmoRounding && distance(a.axisY, b.axisY) < gizmoRounding &&
           distance(a.axisZ, b.axisZ) < gizmoRounding && distance(a.origin, b.origin) < gizmoRounding;
}

} // namespace

class tst_PlacementGizmo : public QObject {
    Q_OBJECT
private slots:
    void everyHandleIsFoundWhereItIsDrawn();
    void besideTheHandlesNothingIsGrabbed();
    void anArrowMovesAlongItsAxisByWhatThePointerMoved();
    void aRingTurnsAboutItsAxisThroughThePivot();
    void turnsGoOnPastHalfACircle();
    void aRingSeenEdgeOnStillTurns();
    void anArrowIsMeantWhereARingSeenEdgeOnCoversIt();
    void anArrowAlongTheLineOfSightIsNotOffered();
    void draggingBackGivesTheFirstPlacement();
    void stepsAreWholeCentimetresAndFiveDegrees();
    void cancelGivesThePlacementFromBefore();
    void withoutAGrabADragDoesNothing();
    void hoveringLightsTheHandle();
    void theSizeOnTheScreenDoesNotDependOnTheDistance();
    void onlyTheHeldHandleIsDrawnWhileDragging();
};

void tst_PlacementGizmo::everyHandleIsFoundWhereItIsDrawn() {
    const PlacementGizmo gizmo(start, pivot);
    for (const Grab& grab : grabs)
        QCOMPARE(
            gizmo.handleAt(fromTheFront(), seenAt(fromTheFront(), at(fromTheFront(), grab.direction, grab.pixels))),
            grab.handle);
}

void tst_PlacementGizmo::besideTheHandlesNothingIsGrabbed() {
    PlacementGizmo gizmo(start, pivot);
    QVERIFY(!gizmo.press(fromTheFront(), {20, 20}));
    QVERIFY(!gizmo.isDragging());
}

void tst_PlacementGizmo::anArrowMovesAlongItsAxisByWhatThePointerMoved() {
    for (const Grab& grab : grabs) {
        if (grab.handle >= GizmoHandle::turnX) continue;
        PlacementGizmo gizmo(start, pivot);
        const Vec3 from = at(fromTheFront(), grab.direction, grab.pixels), moved = grab.direction * 0.137;
        QVERIFY(gizmo.press(fromTheFront(), seenAt(fromTheFront(), from)));
        Transform wanted = start;
        wanted.origin += moved;
        QVERIFY(near(gizmo.drag(fromTheFront(), seenAt(fromTheFront(), from + moved)), wanted));
        QVERIFY(distance(gizmo.pivot(), pivot + moved) < gizmoRounding);
    }
}

void tst_PlacementGizmo::aRingTurnsAboutItsAxisThroughThePivot() {
    for (const Grab& grab : grabs) {
        if (grab.handle < GizmoHandle::turnX) continue;
        Vec3 axis;
        axis[static_cast<int>(grab.handle) - static_cast<int>(GizmoHandle::turnX)] = 1;
        PlacementGizmo gizmo(start, pivot);
        const Vec3 from = at(fromTheFront(), grab.direction, grab.pixels);
        const Transform turn = turnedAbout(pivot, axis, 0.7);
        QVERIFY(gizmo.press(fromTheFront(), seenAt(fromTheFront(), from)));
        const Transform after = gizmo.drag(fromTheFront(), seenAt(fromTheFront(), turn.point(from)));
        QVERIFY(isRigid(after));
        QVERIFY(near(after, composed(turn, start)));
        QVERIFY(distance(gizmo.pivot(), pivot) < gizmoRounding);
    }
}

void tst_PlacementGizmo::turnsGoOnPastHalfACircle() {
    PlacementGizmo gizmo(Transform{}, pivot);
    const Vec3 from = at(fromTheFront(), {1, 0, 1}, 70);
    QVERIFY(gizmo.press(fromTheFront(), seenAt(fromTheFront(), from)));
    for (int step = 1; step <= 40; ++step) { // one and a quarter turns, then the same way back
        const double angle = 2.5 * std::numbers::pi * step / 40;
        const Transform turn = turnedAbout(pivot, {0, 1, 0}, angle);
        QVERIFY(near(gizmo.drag(fromTheFront(), seenAt(fromTheFront(), turn.point(from))), turn));
    }
}

void tst_PlacementGizmo::aRingSeenEdgeOnStillTurns() {
    const GizmoView level{{.target = pivot, .distance = 2.5}, {800, 600}}; // the ring about y is a level line
    PlacementGizmo gizmo(Transform{}, pivot);
    QCOMPARE(gizmo.handleAt(level, {370, 300}), GizmoHandle::turnY);
    QVERIFY(gizmo.press(level, {370, 300}));
    const Transform turned = gizmo.drag(level, {380, 300});
    QVERIFY(isRigid(turned));
    // The front of the ring follows the pointer: to the right is counter-clockwise seen from above; 70 px are
    // 1 rad, but for the front being nearer to the eye than the pivot.
    const double angle = std::atan2(-turned.axisX.z, turned.axisX.x);
    QVERIFY2(std::abs(angle - 10.0 / 70) < 0.02, QByteArray::number(angle));
}

void tst_PlacementGizmo::anArrowIsMeantWhereARingSeenEdgeOnCoversIt() {
    const GizmoView level{{.target = pivot, .distance = 2.5}, {800, 600}};
    const PlacementGizmo gizmo(Transform{}, pivot);
    QCOMPARE(gizmo.handleAt(level, {440, 300}), GizmoHandle::moveX);
    QCOMPARE(gizmo.handleAt(level, {400, 250}), GizmoHandle::moveY);
    QCOMPARE(gizmo.handleAt(level, {400, 350}), GizmoHandle::turnX); // there is no arrow on this side
}

void tst_PlacementGizmo::anArrowAlongTheLineOfSightIsNotOffered() {
    const GizmoView front{{.target = pivot, .distance = 2.5}, {800, 600}};
    const PlacementGizmo gizmo(start, pivot);
    QVERIFY(gizmo.handleAt(front, {400, 300}) != GizmoHandle::moveZ); // its tip is here
    QVERIFY(gizmo.handleAt(front, {490, 300}) == GizmoHandle::moveX);
}

void tst_PlacementGizmo::draggingBackGivesTheFirstPlacement() {
    for (const Grab& grab : grabs) {
        PlacementGizmo gizmo(start, pivot);
        const Vec2 from = seenAt(fromTheFront(), at(fromTheFront(), grab.direction, grab.pixels));
        QVERIFY(gizmo.press(fromTheFront(), from));
        QVERIFY(!near(gizmo.drag(fromTheFront(), from + Vec2{25, -18}), start));
        QVERIFY(near(gizmo.drag(fromTheFront(), from), start));
    }
}

void tst_PlacementGizmo::stepsAreWholeCentimetresAndFiveDegrees() {
    PlacementGizmo arrow(start, pivot);
    const Vec3 tip = at(fromTheFront(), {1, 0, 0}, 90);
    QVERIFY(arrow.press(fromTheFront(), seenAt(fromTheFront(), tip)));
    arrow.drag(fromTheFront(), seenAt(fromTheFront(), tip + Vec3{0.0321, 0, 0}), true);
    QVERIFY(std::abs(arrow.placement().origin.x - start.origin.x - 0.03) < gizmoRounding);

    PlacementGizmo ring(Transform{}, pivot);
    const Vec3 from = at(fromTheFront(), {1, 0, 1}, 70);
    QVERIFY(ring.press(fromTheFront(), seenAt(fromTheFront(), from)));
    const double degree = std::numbers::pi / 180;
    ring.drag(fromTheFront(), seenAt(fromTheFront(), turnedAbout(pivot, {0, 1, 0}, 18 * degree).point(from)), true);
    QVERIFY(near(ring.placement(), turnedAbout(pivot, {0, 1, 0}, 20 * degree)));
}

void tst_PlacementGizmo::cancelGivesThePlacementFromBefore() {
    PlacementGizmo gizmo(start, pivot);
    const Vec2 from = seenAt(fromTheFront(), at(fromTheFront(), {1, 0, 0}, 90));
    QVERIFY(gizmo.press(fromTheFront(), from));
    gizmo.drag(fromTheFront(), from + Vec2{50, 0});
    QVERIFY(gizmo.placement() != start);
    gizmo.cancel();
    QVERIFY(gizmo.placement() == start && gizmo.pivot() == pivot && !gizmo.isDragging());
}

void tst_PlacementGizmo::withoutAGrabADragDoesNothing() {
    PlacementGizmo gizmo(start, pivot);
    gizmo.drag(fromTheFront(), {300, 200});
    gizmo.release();
    gizmo.cancel();
    QVERIFY(gizmo.placement() == start);
}

void tst_PlacementGizmo::hoveringLightsTheHandle() {
    PlacementGizmo gizmo(start, pivot);
    const Vec2 tip = seenAt(fromTheFront(), at(fromTheFront(), {0, 1, 0}, 90));
    QVERIFY(gizmo.hover(fromTheFront(), tip));
    QCOMPARE(gizmo.hovered(), GizmoHandle::moveY);
    QVERIFY(!gizmo.hover(fromTheFront(), tip + Vec2{1, 0})); // still the same
    QVERIFY(gizmo.hover(fromTheFront(), {20, 20}));
}

void tst_PlacementGizmo::theSizeOnTheScreenDoesNotDependOnTheDistance() {
    const auto height = [](double distance) {
        const GizmoView view{{.target = pivot, .distance = distance}, {800, 600}};
        double top = 1e9;
        for (const auto& stroke : PlacementGizmo(start, pivot).strokes(view))
            for (const Vec3& p : stroke.points) top = std::min(top, seenAt(view, p).y);
        return 300 - top;
    };
    QVERIFY(std::abs(height(1) - height(6)) < 1); // the head's depth is seen a little larger from near [px]
    QVERIFY(height(1) > 80);
}

void tst_PlacementGizmo::onlyTheHeldHandleIsDrawnWhileDragging() {
    PlacementGizmo gizmo(start, pivot);
    const std::size_t all = gizmo.strokes(fromTheFront()).size();
    QVERIFY(gizmo.press(fromTheFront(), seenAt(fromTheFront(), at(fromTheFront(), {0, 1, 0}, 90))));
    const std::size_t one = gizmo.strokes(fromTheFront()).size();
    QVERIFY(one > 0 && one < all / 3);
}

TOILE_TEST(tst_PlacementGizmo)
#include "tst_PlacementGizmo.moc"
