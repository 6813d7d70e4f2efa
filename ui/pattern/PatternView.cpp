// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pattern/PatternView.h"

#include "ui/pattern/Colours.h"
#include "ui/values/Picking.h"

#include <QMouseEvent>

#include <cmath>

namespace toile::ui {
namespace {

constexpr double touch = 8;      // what counts as touching [pixel]
constexpr double fitMargin = 46; // rulers and some air [pixel]
constexpr double zoomStep = 1.2; // a notch of the wheel

Modifiers modifiersOf(Qt::KeyboardModifiers modifiers) {
    return {modifiers.testFlag(Qt::ShiftModifier), modifiers.testFlag(Qt::ControlModifier),
            modifiers.testFlag(Qt::AltModifier)};
}

Button buttonOf(Qt::MouseButtons buttons) {
    if (buttons & Qt::LeftButton) return Button::left;
    if (buttons & Qt::RightButton) return Button::right;
    if (buttons & Qt::MiddleButton) return Button::middle;
    return Button::none;
}

/// Delete is an action of the window: it works wherever the focus is.
std::optional<ToolKey> toolKeyOf(int key) {
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter: return ToolKey::enter;
    case Qt::Key_Escape: return ToolKey::escape;
    case Qt::Key_Backspace: return ToolKey::backspace;
    default: return std::nullopt;
    }
}

} // namespace

PatternView::PatternView(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
    setObjectName(QStringLiteral("patternView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    const auto repaint = [this] { update(); };
    connect(&workbench, &Workbench::documentChanged, this, repaint);
    connect(&workbench, &Workbench::selectionChanged, this, repaint);
    connect(&workbench, &Workbench::meshChanged, this, repaint);
    connect(&workbench, &Workbench::documentReplaced, this, [this] { setTool(tool_); });
}

void PatternView::setTool(Tool* tool) {
    if (tool_) tool_->cancel();
    tool_ = tool;
    update();
    Q_EMIT toolMoved();
}

void PatternView::press(ToolKey key) {
    if (tool_) take(tool_->key(workbench_.desk(), key));
}

void PatternView::setView(const ViewTransform& view) {
    view_ = view;
    view_.size = size();
    fitsAll_ = false;
    update();
}

void PatternView::setLook(const PatternLook& look) {
    look_ = look;
    update();
}

void PatternView::fitAll() {
    setView(fitted(view_, boundsOf(workbench_.flat()), fitMargin));
    fitsAll_ = true;
}

void PatternView::fitSelection() {
    std::vector<Vec2> corners;
    for (const Item& item : workbench_.selection())
        if (const FlatPiece* piece = findPiece(workbench_.flat(), pieceOf(item))) {
            const geometry::Box2 box = boundsOf(*piece);
            corners.insert(corners.end(), {box.low, box.high});
        }
    if (corners.empty()) return fitAll();
    setView(fitted(view_, geometry::boundsOf(corners), fitMargin));
}

void PatternView::zoomBy(double factor) {
    setView(zoomed(view_, factor, QRectF(rect()).center()));
}

void PatternView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Overlay overlay = tool_ ? tool_->overlay(workbench_.desk()) : Overlay{};
    PatternLook look = look_;
    look.vertices = look.vertices || (tool_ && tool_->showsPoints());
    paint(painter, view_,
          {workbench_.document().pattern, workbench_.flat(), workbench_.mesh(), workbench_.selection(),
           tool_ ? tool_->hovered() : std::nullopt, overlay, look});
}

void PatternView::resizeEvent(QResizeEvent*) {
    view_.size = size();
    if (fitsAll_) fitAll();
}

PointerEvent PatternView::eventOf(const QMouseEvent& event) const {
    const Button button = event.button() == Qt::NoButton ? buttonOf(event.buttons()) : buttonOf(event.button());
    return {view_.toPattern(event.position()), button, modifiersOf(event.modifiers()), touch / view_.scale};
}

void PatternView::take(const Effect& effect) {
    workbench_.take(effect);
    update();
    Q_EMIT toolMoved();
}

void PatternView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton || event->button() == Qt::RightButton) {
        panFrom_ = rightPress_ = event->position();
        panned_ = false;
        return;
    }
    if (tool_) take(tool_->press(workbench_.desk(), eventOf(*event)));
}

void PatternView::mouseMoveEvent(QMouseEvent* event) {
    Q_EMIT pointerMoved(view_.toPattern(event->position()));
    if (panFrom_) {
        if (!panned_ && QLineF(rightPress_, event->position()).length() < 4) return;
        panned_ = true;
        setCursor(Qt::ClosedHandCursor);
        setView(panned(view_, event->position() - *panFrom_));
        panFrom_ = event->position();
        return;
    }
    if (tool_) take(tool_->move(workbench_.desk(), eventOf(*event)));
}

void PatternView::mouseReleaseEvent(QMouseEvent* event) {
    if (panFrom_ && event->button() != Qt::LeftButton) {
        panFrom_.reset();
        unsetCursor();
        if (!panned_ && event->button() == Qt::RightButton)
            Q_EMIT menuWanted(itemsUnder(eventOf(*event)), event->globalPosition().toPoint());
        return;
    }
    if (tool_) take(tool_->release(workbench_.desk(), eventOf(*event)));
}

void PatternView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return mousePressEvent(event);
    if (tool_) take(tool_->doubleClick(workbench_.desk(), eventOf(*event)));
}

void PatternView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier) && tool_ && tool_->wheel(notches)) {
        update();
        Q_EMIT toolMoved();
        return;
    }
    setView(zoomed(view_, std::pow(zoomStep, notches), event->position()));
}

void PatternView::keyPressEvent(QKeyEvent* event) {
    const auto key = toolKeyOf(event->key());
    if (!key) return QWidget::keyPressEvent(event);
    press(*key);
}

Selection PatternView::itemsUnder(const PointerEvent& event) const {
    const FlatPattern& flat = workbench_.flat();
    Selection under;
    if (const auto vertex = vertexAt(flat, event.position, event.tolerance)) under.push_back(*vertex);
    if (const auto edge = edgeAt(flat, event.position, event.tolerance)) under.push_back(edge->edge);
    if (const auto seam = seamAt(workbench_.document().pattern, flat, event.position, event.tolerance))
        under.push_back(*seam);
    if (const auto region = regionAt(flat, event.position)) under.push_back(*region);
    if (const auto piece = pieceAt(flat, event.position)) under.push_back(*piece);
    return under;
}

} // namespace toile::ui
