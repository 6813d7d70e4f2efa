// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowFixture.h"
#include "core/io/ToileFile.h"
#include "tests/Suite.h"

#include <QTemporaryDir>

using namespace toile;
using namespace toile::ui;

/// A garment from an empty document to a file, by mouse and keys alone.
class tst_SkirtSession : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void aSkirtIsDrawnPaintedSewnOnTheMannequinSavedAndReloaded();

private:
    static void drawPieces(Bench& bench);
    static void paintTheHem(Bench& bench);
    static void sewTheSides(Bench& bench);
    static void placeRoundTheBody(Bench& bench);
    static void simulate(Bench& bench);
    static void saveAndReload(Bench& bench);
};

namespace {

/// A trapezium: the hem below, the waist above.
constexpr double hem = 0.62, waist = 0.38, height = 0.45; // [m]
constexpr double slant = (hem - waist) / 2;
const std::array lefts{0.0, 0.7}; // of front and back on the table

/// A point of a side edge, a fifth of the way up from the hem.
Vec2 onSide(double left, bool right) {
    return {right ? left + hem - slant / 5 : left + slant / 5, height / 5};
}

Vec3 middleOf(const simulation::Frame& frame) {
    Vec3 sum;
    for (const Vec3& p : frame.positions) sum += p;
    return sum / double(frame.positions.size());
}

} // namespace

void tst_SkirtSession::aSkirtIsDrawnPaintedSewnOnTheMannequinSavedAndReloaded() {
    Bench bench;
    bench.look({0.66, 0.25}, 400);
    bench.action("avatar.mannequin")->trigger();
    for (const auto stage : {drawPieces, paintTheHem, sewTheSides, placeRoundTheBody, simulate, saveAndReload}) {
        stage(bench);
        if (QTest::currentTestFailed()) return;
    }
}

void tst_SkirtSession::drawPieces(Bench& bench) {
    bench.key(Qt::Key_D, Qt::ShiftModifier);
    for (const double left : lefts) {
        for (const Vec2 at : {Vec2{left, 0}, {left + hem, 0}, {left + hem - slant, height}, {left + slant, height}})
            bench.click(at);
        bench.toolKey(Qt::Key_Return);
    }
    QCOMPARE(bench.pattern().pieces.size(), std::size_t(2));
}

void tst_SkirtSession::paintTheHem(Bench& bench) {
    bench.key(Qt::Key_B, Qt::ShiftModifier);
    bench.drag({0.2, 0.12}, {0.42, 0.12}, [&] { bench.picture("painting-a-region.png"); });
    QCOMPARE(bench.pattern().pieces[0]->regions.size(), std::size_t(1));
    QTRY_COMPARE(bench.workbench.mesh().size(), std::size_t(2)); // meshed on its own thread
    QTRY_VERIFY(bench.workbench.mesh()[0].lines.size() > bench.workbench.mesh()[1].lines.size()); // the region is finer
}

void tst_SkirtSession::sewTheSides(Bench& bench) {
    bench.key(Qt::Key_N);
    bench.click(onSide(lefts[0], true));
    bench.point(onSide(lefts[1], false));
    bench.picture("setting-a-seam.png");
    bench.click(onSide(lefts[1], false));
    bench.click(onSide(lefts[0], false));
    bench.click(onSide(lefts[1], true));
    QCOMPARE(bench.pattern().seams.size(), std::size_t(2));
    for (const pattern::Seam& seam : bench.pattern().seams) // hem meets hem
        QVERIFY(seam.sides[0].front().reversed != seam.sides[1].front().reversed);
}

void tst_SkirtSession::placeRoundTheBody(Bench& bench) {
    QTRY_VERIFY(bench.workbench.body().has_value());
    QTRY_VERIFY(bench.workbench.frame().has_value());
    bench.action("view.fitAll")->trigger();
    bench.look({0.66, 0.25}, 400);
    bench.key(Qt::Key_A);
    for (const int piece : {0, 1}) {
        bench.click({lefts[piece] + 0.2, 0.3});
        QTRY_VERIFY(bench.window.view3D().gizmo()); // the scene with both pieces is built on its own thread
        bench.action("view.front")->trigger();
        bench.pullArrow(1, -0.28); // down to the hips
        QTRY_VERIFY(bench.window.view3D().gizmo());
        if (piece == 0) continue;
        bench.action("view.top")->trigger();
        bench.turnRing(std::numbers::pi);
        QTRY_VERIFY(bench.window.view3D().gizmo());
        bench.pullArrow(2, -0.6); // behind the body
    }
    bench.action("view.front")->trigger();
    bench.picture("placed.png");
    for (const int piece : {0, 1}) {
        const Transform& at = bench.pattern().pieces[piece]->placement->transform;
        const double side = piece == 0 ? 1 : -1;
        QVERIFY(distance(at.origin, {0, 0.82, 0.3 * side}) < 1e-9);
        QVERIFY(distance(at.axisZ, {0, 0, side}) < 1e-9); // the right side faces outward
    }
}

void tst_SkirtSession::simulate(Bench& bench) {
    QTRY_VERIFY(bench.workbench.frame()->largestSeamGap > 0.5);
    const int particles = bench.workbench.frame()->particles;
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.workbench.frame()->time > 0.25, 60000);
    bench.picture("sewing.png");
    // Sewn without weight, then shaken down without friction, then left to gravity.
    QTRY_VERIFY_WITH_TIMEOUT(bench.workbench.frame()->atRest, 300000);
    bench.key(Qt::Key_Space);
    QVERIFY(!bench.workbench.isPlaying());
    const simulation::Frame& frame = *bench.workbench.frame();
    QCOMPARE(frame.largestSeamGap, 0.0);
    QVERIFY(frame.particles < particles); // each closed seam is one row of particles
    const Vec3 middle = middleOf(frame);
    QVERIFY2(std::abs(middle.x) < 0.03 && middle.y > 0.7 && middle.y < 0.95, // it hangs from the hips
             qPrintable(QStringLiteral("%1, %2").arg(middle.x).arg(middle.y)));
    bench.picture("window.png");
}

void tst_SkirtSession::saveAndReload(Bench& bench) {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("skirt.toile"));
    Bench::nextFile(file);
    bench.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!bench.window.isWindowModified());
    const document::Document drawn = *io::asWritten(bench.workbench.document());
    bench.key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(bench.pattern().pieces.empty());
    Bench::nextFile(file);
    bench.key(Qt::Key_O, Qt::ControlModifier);
    QVERIFY(bench.workbench.document() == drawn);
    QTRY_VERIFY(bench.workbench.body().has_value()); // found from the new place
}

TOILE_TEST(tst_SkirtSession, QApplication)
#include "tst_SkirtSession.moc"
