// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/values/ViewTransform.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

class tst_ViewTransform : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void upInThePatternIsUpOnTheScreen();
    void screenAndPatternAreInverse();
    void painterMatrixIsTheSameMap();
    void panningMovesWhatLiesUnderThePointerWithIt();
    void zoomingKeepsWhatLiesUnderThePointer();
    void zoomStopsAtItsLimits();
    void fittingShowsTheWholeBox();
    void fittingNothingShowsAboutAMetre();
};

namespace {

constexpr double rounding = 1e-9; // of a few operations on numbers up to 1e4

ViewTransform someView() {
    return {{0.3, -0.2}, 1500, {640, 480}};
}

} // namespace

void tst_ViewTransform::upInThePatternIsUpOnTheScreen() {
    QVERIFY(someView().toScreen({0, 1}).y() < someView().toScreen({0, 0}).y());
    QVERIFY(someView().toScreen({1, 0}).x() > someView().toScreen({0, 0}).x());
}

void tst_ViewTransform::screenAndPatternAreInverse() {
    const Vec2 point{0.123, -0.456};
    QVERIFY(distance(someView().toPattern(someView().toScreen(point)), point) < rounding);
}

void tst_ViewTransform::painterMatrixIsTheSameMap() {
    const QPointF mapped = someView().matrix().map(QPointF(0.1, 0.2)), direct = someView().toScreen({0.1, 0.2});
    QVERIFY(QLineF(mapped, direct).length() < rounding);
}

void tst_ViewTransform::panningMovesWhatLiesUnderThePointerWithIt() {
    const QPointF from(100, 90), by(37, -21);
    const Vec2 under = someView().toPattern(from);
    QVERIFY(QLineF(panned(someView(), by).toScreen(under), from + by).length() < rounding);
}

void tst_ViewTransform::zoomingKeepsWhatLiesUnderThePointer() {
    const QPointF pixel(500, 77);
    const ViewTransform closer = zoomed(someView(), 1.7, pixel);
    QCOMPARE(closer.scale, 1500 * 1.7);
    QVERIFY(distance(closer.toPattern(pixel), someView().toPattern(pixel)) < rounding);
}

void tst_ViewTransform::zoomStopsAtItsLimits() {
    QCOMPARE(zoomed(someView(), 1e-9, {0, 0}).scale, 10.0);
    QCOMPARE(zoomed(someView(), 1e+9, {0, 0}).scale, 1e6);
}

void tst_ViewTransform::fittingShowsTheWholeBox() {
    const geometry::Box2 box{{-1, 2}, {1, 2.5}};
    const ViewTransform view = fitted(someView(), box, 20);
    QVERIFY(QLineF(view.toScreen(box.low), QPointF(20, view.toScreen(box.low).y())).length() <
            rounding); // width decides
    QVERIFY(view.toScreen(box.high).y() > 20);
    QVERIFY(view.toScreen(box.low).y() < 460);
}

void tst_ViewTransform::fittingNothingShowsAboutAMetre() {
    const ViewTransform view = fitted(someView(), {}, 20);
    QCOMPARE(view.toPattern({320, 0}).y - view.toPattern({320, 480}).y, 1.0);
}

TOILE_TEST(tst_ViewTransform)
#include "tst_ViewTransform.moc"
