// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/View3D.h"

#include "ui/view3d/GraphicsGate.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace toile::ui {

using picture::ViewDirection;

namespace {

constexpr double clickSlack = 4; // a press that moves less than this is a click [px]

Vec2 positionOf(const QSinglePointEvent& event) {
    return {event.position().x(), event.position().y()};
}

PointerPress pressOf(const QMouseEvent& event) {
    return {event.button() == Qt::LeftButton,
            event.button() == Qt::MiddleButton,
            event.button() == Qt::RightButton,
            event.modifiers().testFlag(Qt::ShiftModifier),
            event.modifiers().testFlag(Qt::ControlModifier),
            event.modifiers().testFlag(Qt::AltModifier)};
}

} // namespace

View3D::View3D(QWidget* parent) : QWidget(parent) {
    setObjectName("view3d");
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (const Graphics graphics = probeGraphics(); graphics.path == GraphicsPath::window)
        install(makeWindowHost(
            graphics.format,
            [this] {
                return Shown{scene_, camera_};
            },
            [this](const QString&) { showRaster(); }, this));
    else showRaster();
}

View3D::~View3D() = default;

void View3D::showRaster() {
    install(makeRasterHost(
        [this] {
            return Shown{scene_, camera_};
        },
        [this](const QString& why) {
            install(makeMessageHost(tr("The 3D view cannot be shown; everything else works.") + "\n\n" + why, this));
        },
        this));
}

void View3D::install(std::unique_ptr<SceneHost> host) {
    if (host_) {
        layout()->removeWidget(host_->widget());
        host_->widget()->hide();
        host_->widget()->deleteLater(); // it may be the one that called
    }
    host_ = std::move(host);
    layout()->addWidget(host_->widget());
}

picture::Viewport View3D::viewport() const {
    return {std::max(width(), 1), std::max(height(), 1)};
}

void View3D::changed() {
    scene_.overlay = gizmo_ ? gizmo_->strokes(gizmoView()) : std::vector<picture::Stroke>{};
    if (scene_.frame && scene_.options.cloth)
        std::ranges::move(marksOfPins(**scene_.frame, camera_, viewport()), std::back_inserter(scene_.overlay));
    const auto mark = [this](const HeldPlace& place, bool inHand) {
        std::ranges::move(marksOf(place, inHand, scene_, camera_, viewport()), std::back_inserter(scene_.overlay));
    };
    for (const HeldPlace& pin : pins_) mark(pin, false);
    if (isPulling()) mark(pull_->place(), true);
    host_->changed();
}

void View3D::setBody(std::optional<Shared<body::Body>> body) {
    scene_.body = std::move(body);
    fitFirst();
    changed();
}

void View3D::setFrame(simulation::Frame frame) {
    scene_.frame = Shared(std::move(frame));
    fitFirst();
    changed();
}

void View3D::clearFrame() {
    scene_.frame.reset();
    changed();
}

void View3D::setOptions(const picture::RenderOptions& options) {
    if (scene_.options == options) return;
    scene_.options = options;
    changed();
}

void View3D::setColours(std::map<std::string, picture::Colour> pieces, std::vector<picture::Colour> seams) {
    scene_.pieceColours = std::move(pieces);
    scene_.seamColours = std::move(seams);
    changed();
}

void View3D::setSelection(const std::string& pieceId) {
    if (scene_.selectedPiece == pieceId) return;
    scene_.selectedPiece = pieceId;
    changed();
}

void View3D::setGizmo(const std::optional<Transform>& placement) {
    if (gizmo_ && gizmo_->isDragging() && placement) return;
    gizmo_.reset();
    const std::optional<Vec3> pivot = middleOfSelection();
    if (placement && pivot) gizmo_.emplace(*placement, *pivot);
    changed();
}

void View3D::setPulling(bool possible) {
    mayPull_ = possible;
    if (!possible && !pull_) unsetCursor();
}

void View3D::setPins(std::vector<HeldPlace> pins) {
    if (pins_ == pins) return;
    pins_ = std::move(pins);
    changed();
}

void View3D::setCamera(const picture::Camera& camera) {
    camera_ = camera;
    untouched_ = false;
    changed();
}

std::optional<Vec3> View3D::middleOfSelection() const {
    if (!scene_.frame) return std::nullopt;
    const simulation::Frame& frame = **scene_.frame;
    for (const auto& piece : frame.topology->pieces)
        if (piece.id == scene_.selectedPiece && piece.vertexCount > 0) {
            const auto first = frame.positions.begin() + piece.firstVertex;
            const geometry::Box3 box = geometry::boundsOf({first, first + piece.vertexCount});
            return (box.low + box.high) * 0.5;
        }
    return std::nullopt;
}

void View3D::viewFront() {
    look(ViewDirection::front);
}
void View3D::viewBack() {
    look(ViewDirection::back);
}
void View3D::viewLeft() {
    look(ViewDirection::left);
}
void View3D::viewRight() {
    look(ViewDirection::right);
}
void View3D::viewTop() {
    look(ViewDirection::top);
}

void View3D::look(ViewDirection direction) {
    setCamera(lookingFrom(direction, camera_));
}

void View3D::fit() {
    const auto box = boundsOf(scene_);
    if (!box) return;
    camera_ = fitted(camera_, viewport(), *box);
    fitted_ = true;
    changed();
}

void View3D::fitFirst() {
    if (untouched_ && !fitted_) fit();
}

void View3D::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (untouched_) fit();
    changed(); // the gizmo keeps its size in pixels
}

void View3D::mousePressEvent(QMouseEvent* event) {
    pressedAt_ = lastAt_ = positionOf(*event);
    if ((gizmo_ && gizmo_->isDragging()) || pull_) return; // another button during a drag
    motion_ = motionFor(habits_, pressOf(*event));
    if (motion_ != CameraMotion::none || event->button() != Qt::LeftButton) return;
    mayClick_ = !(gizmo_ && gizmo_->press(gizmoView(), pressedAt_));
    if (mayClick_ && mayPull_) takeHold(pressedAt_);
    changed();
}

void View3D::mouseMoveEvent(QMouseEvent* event) {
    const Vec2 at = positionOf(*event), from = std::exchange(lastAt_, at);
    if (distance(at, pressedAt_) > clickSlack) mayClick_ = false;
    if (motion_ != CameraMotion::none) {
        setCamera(moved(camera_, viewport(), motion_, from, at));
    } else if (gizmo_ && gizmo_->isDragging()) {
        gizmo_->drag(gizmoView(), at, event->modifiers().testFlag(Qt::ControlModifier));
        changed();
        Q_EMIT placementDragged(scene_.selectedPiece, gizmo_->placement(), false);
    } else if (isPulling()) {
        pull_->drag(camera_, viewport(), at);
        setCursor(Qt::ClosedHandCursor);
        changed();
        Q_EMIT clothPulled(pull_->place(), pull_->pin());
    } else if (gizmo_ && gizmo_->hover(gizmoView(), at)) {
        changed();
    } else if (mayPull_ && event->buttons() == Qt::NoButton) {
        showWhatCanBeGrabbed(at);
    }
}

void View3D::mouseReleaseEvent(QMouseEvent* event) {
    if (gizmo_ && gizmo_->isDragging()) {
        if (event->button() == Qt::LeftButton) finishDrag(true);
        return;
    }
    if (isPulling()) {
        if (event->button() == Qt::LeftButton) endPull(event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    motion_ = CameraMotion::none;
    const std::optional<ClothPull> grabbed = std::exchange(pull_, std::nullopt);
    if (!std::exchange(mayClick_, false) || event->button() != Qt::LeftButton) return;
    if (grabbed && grabbed->pin()) {
        Q_EMIT pinClicked(*grabbed->pin());
        return;
    }
    const auto place = placeUnder(scene_, pickRay(camera_, viewport(), positionOf(*event)));
    Q_EMIT pieceClicked(place ? place->piece : std::string());
}

void View3D::takeHold(Vec2 pixel) {
    if (const auto pin = pinUnder(pins_, camera_, viewport(), pixel)) pull_.emplace(pins_[*pin], pin);
    else if (auto place = placeUnder(scene_, pickRay(camera_, viewport(), pixel)))
        pull_.emplace(std::move(*place), std::nullopt);
}

void View3D::endPull(bool keep) {
    pull_.reset();
    unsetCursor();
    changed();
    Q_EMIT clothLetGo(keep);
}

void View3D::showWhatCanBeGrabbed(Vec2 pixel) {
    const bool grabbable =
        pinUnder(pins_, camera_, viewport(), pixel) || placeUnder(scene_, pickRay(camera_, viewport(), pixel));
    if (grabbable) setCursor(Qt::OpenHandCursor);
    else unsetCursor();
}

void View3D::wheelEvent(QWheelEvent* event) {
    setCamera(wheeled(camera_, viewport(), positionOf(*event), event->angleDelta().y() / 120.0));
    event->accept();
}

void View3D::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && gizmo_ && gizmo_->isDragging()) finishDrag(false);
    else if (event->key() == Qt::Key_Escape && isPulling()) endPull(false);
    else QWidget::keyPressEvent(event);
}

void View3D::leaveEvent(QEvent* event) {
    if (gizmo_ && !gizmo_->isDragging() && gizmo_->hovered() != GizmoHandle::none) {
        gizmo_->hover(gizmoView(), {-1e6, -1e6});
        changed();
    }
    QWidget::leaveEvent(event);
}

void View3D::finishDrag(bool keep) {
    if (keep) gizmo_->release();
    else gizmo_->cancel();
    changed();
    Q_EMIT placementDragged(scene_.selectedPiece, gizmo_->placement(), true);
}

} // namespace toile::ui
