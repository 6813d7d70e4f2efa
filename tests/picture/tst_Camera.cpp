// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Camera.h"
#include "tests/Suite.h"

#include <QTest>

#include <numbers>

using namespace toile;
using namespace toile::picture;

namespace {

constexpr Viewport picture800{800, 600};
constexpr double rounding = 1e-9; // metres and pixels of order one to a thousand, a few dozen operations

Camera someCamera() {
    return {.target = {0.1, 1.1, -0.2}, .distance = 2.7, .yaw = 0.8, .pitch = -0.4, .fovY = 0.6};
}

bool near(const Vec3& a, const Vec3& b, double tolerance = rounding) {
    return distance(a, b) <= tolerance;
}
bool near(Vec2 a, Vec2 b, double tolerance = rounding) {
    return distance(a, b) <= tolerance;
}

} // namespace

class tst_Camera : public QObject {
    Q_OBJECT
private slots:
    void axesAreOrthonormalAndRightHanded();
    void theTargetIsInTheMiddle();
    void fromTheFrontTheBodysLeftIsOnTheRightOfThePicture();
    void fromAboveTheFaceLooksDownThePicture();
    void pointsBehindTheEyeAreNotSeen();
    void aPickRayPassesThroughThePointSeenThere();
    void screenToWorldUndoesWorldToScreen();
    void matricesAgreeWithWorldToScreen();
    void panningKeepsThePointUnderThePointer();
    void zoomingKeepsThePointUnderThePointer();
    void zoomingInAndOutChangesNothing();
    void zoomingStopsBeforeTheTarget();
    void orbitingKeepsTargetAndDistance();
    void orbitingStopsAtTheZenith();
    void fittingShowsEveryCornerWithAMargin_data();
    void fittingShowsEveryCornerWithAMargin();
    void pixelSizeIsTheDistanceOfNeighbouringPixels();
};

void tst_Camera::axesAreOrthonormalAndRightHanded() {
    for (const double pitch : {-1.5707963, -0.7, 0.0, 0.4, 1.5707963}) {
        const auto [right, up, back] = axesOf({.yaw = 2.1, .pitch = pitch});
        QVERIFY(std::abs(length(right) - 1) < rounding && std::abs(length(up) - 1) < rounding);
        QVERIFY(near(cross(right, up), back));
    }
}

void tst_Camera::theTargetIsInTheMiddle() {
    const auto seen = worldToScreen(someCamera(), picture800, someCamera().target);
    QVERIFY(seen);
    QVERIFY(near(seen->pixel, {400, 300}));
    QVERIFY(std::abs(seen->depth - 2.7) < rounding);
}

void tst_Camera::fromTheFrontTheBodysLeftIsOnTheRightOfThePicture() {
    const Camera front = lookingFrom(ViewDirection::front, {});
    QVERIFY(worldToScreen(front, picture800, {0.2, 1, 0})->pixel.x > 400);
    QVERIFY(worldToScreen(front, picture800, {0, 1.2, 0})->pixel.y < 300);
    const Camera back = lookingFrom(ViewDirection::back, {});
    QVERIFY(worldToScreen(back, picture800, {0.2, 1, 0})->pixel.x < 400);
    const Camera left = lookingFrom(ViewDirection::left, {}); // the eye stands at the body's left, +x
    QVERIFY(near(eyeOf(left), {3, 1, 0}));
}

void tst_Camera::fromAboveTheFaceLooksDownThePicture() {
    const Camera top = lookingFrom(ViewDirection::top, {});
    QVERIFY(near(eyeOf(top), {0, 4, 0}));
    QVERIFY(worldToScreen(top, picture800, {0, 1, 0.2})->pixel.y > 300);
    QVERIFY(worldToScreen(top, picture800, {0.2, 1, 0})->pixel.x > 400);
}

void tst_Camera::pointsBehindTheEyeAreNotSeen() {
    const Camera camera = someCamera();
    QVERIFY(!worldToScreen(camera, picture800, eyeOf(camera) + axesOf(camera).back * 0.01));
    QVERIFY(!worldToScreen(camera, picture800, eyeOf(camera)));
}

void tst_Camera::aPickRayPassesThroughThePointSeenThere() {
    const Vec3 point{0.3, 0.7, 0.4};
    const auto seen = worldToScreen(someCamera(), picture800, point);
    const Ray ray = pickRay(someCamera(), picture800, seen->pixel);
    QVERIFY(near(ray.origin, eyeOf(someCamera())));
    QVERIFY(length(cross(point - ray.origin, ray.direction)) < rounding);
    QVERIFY(dot(point - ray.origin, ray.direction) > 0);
}

void tst_Camera::screenToWorldUndoesWorldToScreen() {
    const Vec3 point{-0.4, 1.3, 0.2};
    const auto seen = worldToScreen(someCamera(), picture800, point);
    QVERIFY(near(screenToWorld(someCamera(), picture800, seen->pixel, point), point));
}

void tst_Camera::matricesAgreeWithWorldToScreen() {
    const Matrix4 view = viewMatrix(someCamera()), projection = projectionMatrix(someCamera(), picture800, 0.1, 10);
    const auto times = [](const Matrix4& m, const std::array<double, 4>& v) {
        std::array<double, 4> r{};
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                r[row] += static_cast<double>(m[4 * column + row]) * v[column];
        return r;
    };
    const Vec3 point{0.3, 0.7, 0.4};
    const auto clip = times(projection, times(view, {point.x, point.y, point.z, 1}));
    const Vec2 pixel{(clip[0] / clip[3] * 0.5 + 0.5) * 800, (0.5 - clip[1] / clip[3] * 0.5) * 600};
    QVERIFY(near(pixel, worldToScreen(someCamera(), picture800, point)->pixel,
                 1e-3)); // matrices are single precision
    QVERIFY(std::abs(clip[2] / clip[3]) < 1);
}

void tst_Camera::panningKeepsThePointUnderThePointer() {
    const Vec2 from{210, 480}, to{333, 222};
    const Vec3 held = screenToWorld(someCamera(), picture800, from, someCamera().target);
    const Camera after = panned(someCamera(), picture800, from, to);
    QVERIFY(near(worldToScreen(after, picture800, held)->pixel, to));
    QCOMPARE(after.distance, someCamera().distance);
}

void tst_Camera::zoomingKeepsThePointUnderThePointer() {
    const Vec2 pixel{150, 90};
    const Vec3 held = screenToWorld(someCamera(), picture800, pixel, someCamera().target);
    const Camera after = zoomedTo(someCamera(), picture800, pixel, 0.6);
    QVERIFY(near(worldToScreen(after, picture800, held)->pixel, pixel));
    QVERIFY(std::abs(after.distance - 2.7 * 0.6) < rounding);
}

void tst_Camera::zoomingInAndOutChangesNothing() {
    const Vec2 pixel{150, 90};
    const Camera after = zoomedTo(zoomedTo(someCamera(), picture800, pixel, 0.5), picture800, pixel, 2);
    QVERIFY(near(after.target, someCamera().target));
    QVERIFY(std::abs(after.distance - someCamera().distance) < rounding);
}

void tst_Camera::zoomingStopsBeforeTheTarget() {
    Camera camera = someCamera();
    for (int i = 0; i < 200; ++i) camera = zoomedTo(camera, picture800, {10, 10}, 0.5);
    QVERIFY(camera.distance > 0.01);
    QVERIFY(isFinite(camera.target));
}

void tst_Camera::orbitingKeepsTargetAndDistance() {
    const Camera after = orbited(someCamera(), picture800, {120, -45});
    QVERIFY(near(after.target, someCamera().target));
    QVERIFY(std::abs(distance(eyeOf(after), after.target) - 2.7) < rounding);
    QVERIFY(!near(eyeOf(after), eyeOf(someCamera()), 0.1));
    const Camera halfTurn = orbited({}, picture800, {600, 0}); // as many pixels as the picture is high
    QVERIFY(near(eyeOf(halfTurn), {0, 1, -3}));
}

void tst_Camera::orbitingStopsAtTheZenith() {
    const Camera after = orbited(someCamera(), picture800, {0, 1e5});
    QVERIFY(near(eyeOf(after), someCamera().target + Vec3{0, 2.7, 0}));
}

void tst_Camera::fittingShowsEveryCornerWithAMargin_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<double>("pitch");
    QTest::newRow("a high picture, level") << 300 << 900 << 0.0;
    QTest::newRow("a wide picture, from above") << 1600 << 400 << 0.7;
    QTest::newRow("a square picture, from the zenith") << 500 << 500 << std::numbers::pi / 2;
}

void tst_Camera::fittingShowsEveryCornerWithAMargin() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(double, pitch);
    const Viewport viewport{width, height};
    const geometry::Box3 box{{-0.8, 0, -0.2}, {0.7, 1.7, 0.3}};
    const double margin = 0.05;
    const Camera camera = fitted({.yaw = 0.4, .pitch = pitch}, viewport, box, margin);
    double nearestToBorder = 1;
    for (int corner = 0; corner < 8; ++corner) {
        const auto seen = worldToScreen(camera, viewport,
                                        {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                         corner & 4 ? box.high.z : box.low.z});
        QVERIFY(seen);
        for (const double free :
             {seen->pixel.x / width, 1 - seen->pixel.x / width, seen->pixel.y / height, 1 - seen->pixel.y / height})
            nearestToBorder = std::min(nearestToBorder, free);
    }
    QVERIFY(std::abs(nearestToBorder - margin) < rounding); // as large as the margin lets it be
}

void tst_Camera::pixelSizeIsTheDistanceOfNeighbouringPixels() {
    const Vec3 point{0.3, 0.7, 0.4};
    const Vec3 a = screenToWorld(someCamera(), picture800, {100, 100}, point);
    const Vec3 b = screenToWorld(someCamera(), picture800, {101, 100}, point);
    QVERIFY(std::abs(pixelSize(someCamera(), picture800, point) - distance(a, b)) < rounding);
}

TOILE_TEST(tst_Camera)
#include "tst_Camera.moc"
