// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/SceneLink.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternPlacement.h"
#include "ui/pattern/Colours.h"

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

picture::Colour colourOf(const QColor& colour) {
    return {colour.redF(), colour.greenF(), colour.blueF(), 1};
}

/// The inverse of a rigid motion.
Transform inverse(const Transform& m) {
    Transform result;
    result.axisX = {m.axisX.x, m.axisY.x, m.axisZ.x};
    result.axisY = {m.axisX.y, m.axisY.y, m.axisZ.y};
    result.axisZ = {m.axisX.z, m.axisY.z, m.axisZ.z};
    result.origin = -result.direction(m.origin);
    return result;
}

/// Fabric on the body: stronger than the tint of the same fabric on the table.
QColor clothColour(std::size_t fabric) {
    const QColor tint = colours::fabricTint(fabric);
    return QColor::fromHsvF(tint.hueF(), 0.28F, 0.86F);
}

} // namespace

simulation::Frame withPieceMoved(simulation::Frame frame, const std::string& pieceId, const Transform& from,
                                 const Transform& to) {
    const Transform motion = composed(to, inverse(from));
    for (const auto& piece : frame.topology->pieces) {
        if (piece.id != pieceId) continue;
        for (int i = piece.firstVertex; i < piece.firstVertex + piece.vertexCount; ++i)
            frame.positions[i] = motion.point(frame.positions[i]);
    }
    return frame;
}

SceneLink::SceneLink(Workbench& workbench, View3D& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
    connect(&workbench, &Workbench::bodyChanged, this, &SceneLink::showBody);
    connect(&workbench, &Workbench::frameArrived, this, &SceneLink::showFrame);
    connect(&workbench, &Workbench::documentChanged, this, [this] {
        showColours();
        showSelection();
        if (workbench_.document().pattern.pieces.empty()) view_.clearFrame();
    });
    connect(&workbench, &Workbench::selectionChanged, this, &SceneLink::showSelection);
    connect(&workbench, &Workbench::playingChanged, this, &SceneLink::showSelection);
    connect(&view, &View3D::pieceClicked, this, [this](const std::string& id) {
        workbench_.select(id.empty() ? Selection{} : Selection{PieceId(id)});
        if (!id.empty() && gizmoWanted_ && isDraped())
            workbench_.tell(tr("Reset the simulation to move pieces round the body."));
    });
    connect(&view, &View3D::placementDragged, this, &SceneLink::dragPlacement);
    showBody();
    showColours();
    showSelection();
}

void SceneLink::setGizmoWanted(bool wanted) {
    gizmoWanted_ = wanted;
    showSelection();
}

bool SceneLink::isDraped() const {
    return workbench_.frame() && workbench_.frame()->time > 0;
}

void SceneLink::showBody() {
    const auto& moved = workbench_.frame() ? workbench_.frame()->body : std::nullopt;
    view_.setBody(moved ? moved : workbench_.body());
}

void SceneLink::showFrame() {
    if (dragging_) return;
    if (!workbench_.frame()) return view_.clearFrame();
    if (workbench_.frame()->body || bodyHadMoved_) showBody();
    bodyHadMoved_ = workbench_.bodyHasMoved();
    const bool first = view_.scene().frame == std::nullopt;
    view_.setFrame(*workbench_.frame());
    if (first || view_.gizmo() || workbench_.frame()->time == 0) showSelection();
}

void SceneLink::showColours() {
    const Pattern& pattern = workbench_.document().pattern;
    std::map<std::string, picture::Colour> pieces;
    for (const auto& piece : pattern.pieces) {
        const auto fabric =
            std::ranges::find_if(pattern.fabrics, [&](const auto& f) { return f->id == piece->fabric; });
        const auto index = fabric == pattern.fabrics.end() ? 0 : fabric - pattern.fabrics.begin();
        pieces[piece->id.value] = colourOf(clothColour(static_cast<std::size_t>(index)));
    }
    std::vector<picture::Colour> seams;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) seams.push_back(colourOf(colours::distinct(i)));
    view_.setColours(std::move(pieces), std::move(seams));
}

void SceneLink::showSelection() {
    if (dragging_) return;
    const Selection& selection = workbench_.selection();
    const PieceId id = selection.empty() ? PieceId() : pieceOf(selection.back());
    view_.setSelection(id.value);
    const Piece* piece = findPiece(workbench_.document().pattern, id);
    const bool movable = piece && piece->placement && gizmoWanted_ && !isDraped() && !workbench_.isPlaying();
    view_.setGizmo(movable ? std::optional(piece->placement->transform) : std::nullopt);
}

void SceneLink::dragPlacement(const std::string& pieceId, const Transform& placement, bool finished) {
    dragging_ = !finished;
    const Piece* piece = findPiece(workbench_.document().pattern, PieceId(pieceId));
    if (!piece || !piece->placement) { // undone meanwhile
        showFrame();
        return showSelection();
    }
    if (workbench_.frame())
        view_.setFrame(withPieceMoved(*workbench_.frame(), pieceId, piece->placement->transform, placement));
    if (!finished || placement == piece->placement->transform) return;
    Placement next = *piece->placement;
    next.transform = placement;
    workbench_.take(
        effectOf(tr("Place piece"), document::edited(workbench_.document(), [&](const Pattern& p, IdSource&) {
                     return setPlacement(p, PieceId(pieceId), next);
                 })));
}

} // namespace toile::ui
