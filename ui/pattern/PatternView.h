// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pattern/PatternPainter.h"
#include "ui/values/PointerEvent.h"
#include "ui/workbench/Workbench.h"

#include <QWidget>

namespace toile::ui {

/// The pattern on its table. Shows what the workbench holds and hands what the pointer does to the current tool.
/// Middle or right drag pans, the wheel zooms to the pointer; a right click asks for a menu.
class PatternView : public QWidget {
    Q_OBJECT
public:
    explicit PatternView(Workbench& workbench, QWidget* parent = nullptr);

    /// The tool is borrowed and may be changed at any time; the one before is cancelled. So is one whose document is
    /// replaced by another.
    void setTool(Tool* tool);
    [[nodiscard]] Tool* tool() const { return tool_; }
    void press(ToolKey key); ///< the tool gets it

    [[nodiscard]] const ViewTransform& view() const { return view_; }
    void setView(const ViewTransform& view);
    [[nodiscard]] const PatternLook& look() const { return look_; }
    void setLook(const PatternLook& look);
    void fitAll();
    void fitSelection();
    void zoomBy(double factor);

    [[nodiscard]] QSize sizeHint() const override { return {700, 600}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 200}; }

Q_SIGNALS:
    /// Where the pointer is, in the plane of the pattern [m].
    void pointerMoved(toile::Vec2 position);
    /// The right button was clicked on something, or on nothing.
    void menuWanted(const toile::ui::Selection& under, QPoint globalPosition);
    /// The tool's hint or options may have changed.
    void toolMoved();

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;

private:
    [[nodiscard]] PointerEvent eventOf(const QMouseEvent& event) const;
    void take(const Effect& effect);
    [[nodiscard]] Selection itemsUnder(const PointerEvent& event) const;

    Workbench& workbench_;
    Tool* tool_ = nullptr;
    ViewTransform view_;
    PatternLook look_;
    std::optional<QPointF> panFrom_;
    QPointF rightPress_;
    bool panned_ = false;
    bool fitsAll_ = true; ///< the view shows the whole pattern, and goes on doing so until the user moves it
};

} // namespace toile::ui
