// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/view3d/View3D.h"

#include "core/picture/OffscreenGl.h"
#include "ui/view3d/GraphicsGate.h"

#include <QTest>

#include <set>

using namespace toile;
using namespace toile::ui;

namespace {

/// Two squares of 0.4 m beside each other, one metre high: "left" and "right" as seen from the front.
simulation::Frame twoSquares() {
    simulation::FrameTopology topology;
    simulation::Frame frame;
    for (const double x : {-0.5, 0.1}) {
        const int v = static_cast<int>(frame.positions.size()), t = static_cast<int>(topology.triangles.size());
        frame.positions.insert(frame.positions.end(), {{x, 0.8, 0}, {x + 0.4, 0.8, 0}, {x + 0.4, 1.2, 0}, {x, 1.2, 0}});
        topology.triangles.insert(topology.triangles.end(), {{v, v + 1, v + 2}, {v, v + 2, v + 3}});
        topology.pieces.push_back({x < 0 ? "left" : "right", "", v, 4, t, 2});
    }
    topology.triangleRegion.assign(4, -1);
    frame.topology = Shared(std::move(topology));
    return frame;
}

std::unique_ptr<View3D> shownView() {
    auto view = std::make_unique<View3D>();
    view->resize(400, 300);
    view->setFrame(twoSquares());
    view->show();
    [[maybe_unused]] const bool exposed = QTest::qWaitForWindowExposed(view.get());
    return view;
}

QPoint seenAt(const View3D& view, const Vec3& point) {
    const Vec2 pixel = worldToScreen(view.camera(), view.viewport(), point)->pixel;
    return {qRound(pixel.x), qRound(pixel.y)};
}

int coloursIn(const QImage& image) {
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); y += 3)
        for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y));
    return static_cast<int>(colours.size());
}

void drag(View3D& view, Qt::MouseButton button, QPoint from, QPoint to) {
    QTest::mousePress(&view, button, {}, from);
    for (int i = 1; i <= 5; ++i) {
        const QPointF at = QPointF(from) + QPointF(to - from) * i / 5;
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, button, {}, to);
}

struct Clicks {
    explicit Clicks(View3D& view) {
        QObject::connect(&view, &View3D::pieceClicked, [this](const std::string& id) { ids.push_back(id); });
    }
    std::vector<std::string> ids;
};

struct Drags {
    struct Drag {
        std::string piece;
        Transform placement;
        bool finished;
    };
    explicit Drags(View3D& view) {
        QObject::connect(&view, &View3D::placementDragged,
                         [this](const std::string& id, const Transform& placement, bool finished) {
                             all.push_back({id, placement, finished});
                         });
    }
    std::vector<Drag> all;
};

} // namespace

class tst_View3D : public QObject {
    Q_OBJECT
private slots:
    void showsAPicture();
    void aNewFrameChangesThePicture();
    void theFirstSceneIsFittedAndFollowsTheWindow();
    void aClickSelectsThePieceUnderThePointer();
    void aClickBesideTheClothGivesNoPiece();
    void clothBehindTheBodyIsNotClicked();
    void rightDragOrbits();
    void middleDragKeepsThePointUnderThePointer();
    void theWheelZoomsToThePointer();
    void viewsLookFromTheirSide();
    void pinsOfThePatternAreRinged();
    void theGizmoStandsInTheMiddleOfTheSelectedPiece();
    void draggingAnArrowSignalsThePlacement();
    void escapeEndsADragWithThePlacementFromBefore();
    void aPlacementSetDuringADragDoesNotDisturbIt();
    void aDragOfTheGizmoIsNoClick();
    void sizesOfOnePixelAreSurvived();

private:
    static bool canDraw() { return probeGraphics().path == GraphicsPath::window || picture::OffscreenGl::create(); }
};

void tst_View3D::pinsOfThePatternAreRinged() {
    const auto view = shownView();
    QVERIFY(view->scene().overlay.empty());
    simulation::Frame frame = twoSquares();
    simulation::FrameTopology topology = *frame.topology;
    topology.pins = {{2, false}, {5, true}};
    frame.topology = Shared(std::move(topology));
    view->setFrame(frame);
    const auto& rings = view->scene().overlay;
    QCOMPARE(rings.size(), std::size_t(3)); // two round the one to the body
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        const Vec3& pinned = frame.positions[ring == 0 ? 2 : 5];
        const double radius = geometry::distance(rings[ring].points.front(), pinned);
        for (const Vec3& point : rings[ring].points)
            QVERIFY(std::abs(geometry::distance(point, pinned) - radius) < 1e-9);
    }
    picture::RenderOptions bodyAlone;
    bodyAlone.cloth = false;
    view->setOptions(bodyAlone);
    QVERIFY(view->scene().overlay.empty());
}

void tst_View3D::showsAPicture() {
    if (!canDraw()) QSKIP("NOT RUN: there is no OpenGL here");
    const auto view = shownView();
    const QImage picture = view->grab().toImage();
    QVERIFY2(coloursIn(picture) > 30, QByteArray::number(coloursIn(picture)));
    const QColor cloth = picture.pixelColor(seenAt(*view, {-0.3, 1, 0}));
    QVERIFY(cloth.blue() > cloth.red() + 15); // the default fabric
    QVERIFY(!view->deviceName().isEmpty());
}

void tst_View3D::aNewFrameChangesThePicture() {
    if (!canDraw()) QSKIP("NOT RUN: there is no OpenGL here");
    const auto view = shownView();
    const QImage before = view->grab().toImage();
    simulation::Frame moved = twoSquares();
    for (Vec3& p : moved.positions) p.y += 0.1;
    view->setFrame(moved);
    QVERIFY(view->grab().toImage() != before);
}

void tst_View3D::theFirstSceneIsFittedAndFollowsTheWindow() {
    const auto view = shownView();
    QVERIFY(distance(view->camera().target, {0, 1, 0}) < 1e-9);
    view->resize(200, 380);
    QVERIFY(view->rect().contains(seenAt(*view, {-0.5, 0.8, 0})));
    view->viewBack(); // from now on the camera is the user's
    const picture::Camera chosen = view->camera();
    view->resize(400, 300);
    QVERIFY(view->camera() == chosen);
}

void tst_View3D::aClickSelectsThePieceUnderThePointer() {
    const auto view = shownView();
    const Clicks clicks(*view);
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, seenAt(*view, {-0.3, 1, 0}));
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, seenAt(*view, {0.3, 1.1, 0}));
    QCOMPARE(clicks.ids, (std::vector<std::string>{"left", "right"}));
}

void tst_View3D::aClickBesideTheClothGivesNoPiece() {
    const auto view = shownView();
    const Clicks clicks(*view);
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, seenAt(*view, {0, 1, 0}));
    QCOMPARE(clicks.ids, std::vector<std::string>{""});
}

void tst_View3D::clothBehindTheBodyIsNotClicked() {
    const auto view = shownView();
    view->setBody(Shared(body::Body{.mesh = {{{-0.5, 0.8, 0.1}, {0, 0.8, 0.1}, {-0.3, 1.3, 0.1}}, {{0, 1, 2}}}}));
    const Clicks clicks(*view);
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, seenAt(*view, {-0.3, 1, 0}));
    QCOMPARE(clicks.ids, std::vector<std::string>{""});
    picture::RenderOptions options;
    options.body = false;
    view->setOptions(options);
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, seenAt(*view, {-0.3, 1, 0}));
    QCOMPARE(clicks.ids.back(), std::string("left"));
}

void tst_View3D::rightDragOrbits() {
    const auto view = shownView();
    const picture::Camera before = view->camera();
    drag(*view, Qt::RightButton, {200, 150}, {260, 170});
    QVERIFY(view->camera() != before);
    QVERIFY(view->camera().yaw < before.yaw && view->camera().pitch > before.pitch);
    QCOMPARE(view->camera().target, before.target);
}

void tst_View3D::middleDragKeepsThePointUnderThePointer() {
    const auto view = shownView();
    const Vec3 held = screenToWorld(view->camera(), view->viewport(), {150, 100}, view->camera().target);
    drag(*view, Qt::MiddleButton, {150, 100}, {240, 190});
    QCOMPARE(seenAt(*view, held), QPoint(240, 190));
}

void tst_View3D::theWheelZoomsToThePointer() {
    const auto view = shownView();
    const Vec3 held = screenToWorld(view->camera(), view->viewport(), {100, 80}, view->camera().target);
    const double before = view->camera().distance;
    QWheelEvent event({100, 80}, view->mapToGlobal(QPointF(100, 80)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view.get(), &event);
    QVERIFY(view->camera().distance < before);
    QCOMPARE(seenAt(*view, held), QPoint(100, 80));
}

void tst_View3D::viewsLookFromTheirSide() {
    const auto view = shownView();
    const auto eye = [&] { return eyeOf(view->camera()) - view->camera().target; };
    view->viewFront();
    QVERIFY(eye().z > 0.9 * view->camera().distance);
    view->viewBack();
    QVERIFY(eye().z < -0.9 * view->camera().distance);
    view->viewLeft();
    QVERIFY(eye().x > 0.9 * view->camera().distance);
    view->viewRight();
    QVERIFY(eye().x < -0.9 * view->camera().distance);
    view->viewTop();
    QVERIFY(eye().y > 0.9 * view->camera().distance);
    view->fit();
    QVERIFY(view->rect().contains(seenAt(*view, {-0.5, 0.8, 0})));
}

void tst_View3D::theGizmoStandsInTheMiddleOfTheSelectedPiece() {
    const auto view = shownView();
    view->setSelection("right");
    view->setGizmo(Transform{});
    QVERIFY(distance(view->gizmo()->pivot(), {0.3, 1, 0}) < 1e-9);
    QVERIFY(!view->scene().overlay.empty());
    view->setGizmo({});
    QVERIFY(view->scene().overlay.empty());
    view->setSelection("a piece whose scene is still being built");
    view->setGizmo(Transform{});
    QVERIFY(!view->gizmo());
}

void tst_View3D::draggingAnArrowSignalsThePlacement() {
    const auto view = shownView();
    view->setSelection("right");
    view->setGizmo(Transform{});
    const Drags drags(*view);
    const QPoint middle = seenAt(*view, {0.3, 1, 0});
    drag(*view, Qt::LeftButton, middle - QPoint(0, 85), middle - QPoint(0, 115)); // the upward arrow
    QVERIFY(drags.all.size() > 2);
    QCOMPARE(drags.all.back().piece, std::string("right"));
    QVERIFY(drags.all.back().finished && !drags.all.front().finished);
    const double moved = 30 * pixelSize(view->camera(), view->viewport(), {0.3, 1, 0});
    QVERIFY(distance(drags.all.back().placement.origin, {0, moved, 0}) < 0.02 * moved); // pixels are whole
}

void tst_View3D::escapeEndsADragWithThePlacementFromBefore() {
    const auto view = shownView();
    view->setSelection("right");
    view->setGizmo(Transform{});
    const Drags drags(*view);
    const QPoint tip = seenAt(*view, {0.3, 1, 0}) - QPoint(0, 85);
    QTest::mousePress(view.get(), Qt::LeftButton, {}, tip);
    QMouseEvent move(QEvent::MouseMove, tip - QPointF(0, 20), view->mapToGlobal(tip - QPointF(0, 20)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view.get(), &move);
    QTest::keyClick(view.get(), Qt::Key_Escape);
    QCOMPARE(drags.all.size(), std::size_t{2});
    QVERIFY(drags.all[0].placement != Transform{});
    QVERIFY(drags.all[1].finished && drags.all[1].placement == Transform{});
    QTest::mouseRelease(view.get(), Qt::LeftButton, {}, tip);
    QCOMPARE(drags.all.size(), std::size_t{2});
}

void tst_View3D::aPlacementSetDuringADragDoesNotDisturbIt() {
    const auto view = shownView();
    view->setSelection("right");
    view->setGizmo(Transform{});
    const Drags drags(*view);
    // As a window does: what is dragged comes back as the document's placement.
    QObject::connect(view.get(), &View3D::placementDragged,
                     [&](const std::string&, const Transform& placement, bool) { view->setGizmo(placement); });
    const QPoint middle = seenAt(*view, {0.3, 1, 0});
    drag(*view, Qt::LeftButton, middle - QPoint(0, 85), middle - QPoint(0, 115));
    const double moved = 30 * pixelSize(view->camera(), view->viewport(), {0.3, 1, 0});
    QVERIFY(distance(drags.all.back().placement.origin, {0, moved, 0}) < 0.02 * moved);
}

void tst_View3D::aDragOfTheGizmoIsNoClick() {
    const auto view = shownView();
    view->setSelection("right");
    view->setGizmo(Transform{});
    const Clicks clicks(*view);
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, seenAt(*view, {0.3, 1, 0}) - QPoint(0, 85));
    QVERIFY(clicks.ids.empty());
}

void tst_View3D::sizesOfOnePixelAreSurvived() {
    View3D view;
    view.setMinimumSize(1, 1);
    view.resize(1, 1);
    view.setFrame(twoSquares());
    view.show();
    QVERIFY(!view.grab().isNull());
}

TOILE_TEST(tst_View3D, QApplication)
#include "tst_View3D.moc"
