// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/RenderScene.h"
#include "ui/view3d/ClothPull.h"
#include "ui/view3d/Navigation.h"
#include "ui/view3d/PlacementGizmo.h"
#include "ui/view3d/SceneHost.h"

#include <QWidget>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace toile::ui {

/// The body and the cloth in space. Shows values it is given; knows no document and no simulation.
///
/// Draws on demand. Where OpenGL cannot draw into the window it shows pictures drawn beside it, and where
/// there is no OpenGL at all a message; input and signals are the same.
class View3D : public QWidget {
    Q_OBJECT
public:
    explicit View3D(QWidget* parent = nullptr);
    ~View3D() override;

    void setBody(std::optional<Shared<body::Body>> body);
    /// Cheap while the topology is the same Shared value as before.
    void setFrame(simulation::Frame frame);
    void clearFrame();
    void setOptions(const picture::RenderOptions& options);
    /// Colours of the right side by piece id, and of seams by their index in the frame; what is absent has a
    /// default.
    void setColours(std::map<std::string, picture::Colour> pieces, std::vector<picture::Colour> seams);
    /// Empty = none.
    void setSelection(const std::string& pieceId);
    /// Shows arrows and rings that move the selected piece; absent hides them. They stand in the middle of the piece
    /// as the frame has it; while the frame has not got it yet there are none. A drag that is under way goes on.
    void setGizmo(const std::optional<Transform>& placement);
    /// Whether the pointer can grab cloth and pins. A pull that is under way goes on.
    void setPulling(bool possible);
    /// Marks of places that are held.
    void setPins(std::vector<HeldPlace> pins);
    void setCamera(const picture::Camera& camera);
    void setCameraHabits(CameraHabits habits) { habits_ = habits; }

    [[nodiscard]] const picture::Camera& camera() const { return camera_; }
    [[nodiscard]] const picture::RenderScene& scene() const { return scene_; }
    [[nodiscard]] const std::optional<PlacementGizmo>& gizmo() const { return gizmo_; }
    [[nodiscard]] picture::Viewport viewport() const;
    /// Graphics card or driver, for bug reports; empty before the first picture.
    [[nodiscard]] QString deviceName() const { return host_->deviceName(); }

    [[nodiscard]] QSize sizeHint() const override { return {640, 720}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 160}; }

public Q_SLOTS:
    void viewFront();
    void viewBack();
    void viewLeft();
    void viewRight();
    void viewTop();
    /// Everything that is drawn fills the view; the direction stays.
    void fit();

Q_SIGNALS:
    /// A left click; the id is empty where no cloth is.
    void pieceClicked(const std::string& pieceId);
    /// While the gizmo is dragged, and once more, finished, at its end; after a cancelled drag (Escape) with
    /// the placement from before it.
    void placementDragged(const std::string& pieceId, const toile::geometry::Transform& placement, bool finished);
    /// While cloth is dragged, or the pin of this index.
    void clothPulled(const HeldPlace& place, std::optional<std::size_t> pin);
    /// The pull is over; with Shift held its last place is to stay a pin.
    void clothLetGo(bool keep);
    void pinClicked(std::size_t pin);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] GizmoView gizmoView() const { return {camera_, viewport()}; }
    [[nodiscard]] std::optional<Vec3> middleOfSelection() const;
    void install(std::unique_ptr<SceneHost> host);
    void showRaster();
    void look(picture::ViewDirection direction);
    void fitFirst();
    void changed();
    void finishDrag(bool keep);
    [[nodiscard]] bool isPulling() const { return pull_ && !mayClick_; }
    void takeHold(Vec2 pixel);
    void endPull(bool keep);
    void showWhatCanBeGrabbed(Vec2 pixel);

    picture::RenderScene scene_;
    picture::Camera camera_;
    std::optional<PlacementGizmo> gizmo_;
    std::optional<ClothPull> pull_; ///< from the press on
    std::vector<HeldPlace> pins_;
    bool mayPull_ = false;
    std::unique_ptr<SceneHost> host_;
    CameraHabits habits_ = CameraHabits::clo;
    CameraMotion motion_ = CameraMotion::none;
    Vec2 pressedAt_, lastAt_; ///< [px]
    bool mayClick_ = false;   ///< the left button is down and has not moved
    bool untouched_ = true;   ///< nobody has moved the camera: it keeps to what was shown first
    bool fitted_ = false;
};

} // namespace toile::ui
