// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/View3D.h"
#include "ui/workbench/Workbench.h"

#include <QObject>

namespace toile::ui {

/// Keeps the 3D view showing what the workbench holds, and brings clicks and drags of the gizmo back as edits.
///
/// While the gizmo is dragged only the shown frame moves; the document changes once, at the end.
class SceneLink : public QObject {
    Q_OBJECT
public:
    SceneLink(Workbench& workbench, View3D& view, QObject* parent = nullptr);

    void setGizmoWanted(bool wanted);

private:
    /// The cloth has left the places where its pieces start.
    [[nodiscard]] bool isDraped() const;
    void showBody();
    void showFrame();
    void showColours();
    void showSelection();
    void dragPlacement(const std::string& pieceId, const Transform& placement, bool finished);

    Workbench& workbench_;
    View3D& view_;
    bool gizmoWanted_ = true;
    bool dragging_ = false;
    bool bodyHadMoved_ = false; ///< in the frame that is shown
};

/// The frame with one piece moved from where `from` places it to where `to` does.
[[nodiscard]] simulation::Frame withPieceMoved(simulation::Frame frame, const std::string& pieceId,
                                               const Transform& from, const Transform& to);

} // namespace toile::ui
