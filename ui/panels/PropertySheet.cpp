// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/PropertySheet.h"

#include "core/pattern/PatternTacks.h"

namespace toile::ui {
namespace {

using namespace pattern;

struct SheetOf {
    const Desk& desk;
    const meshing::MeshReport& mesh;

    PropertySheet operator()(const PieceId& id) const {
        return pieceSheet(desk.document, *findPiece(desk.document.pattern, id), mesh);
    }
    PropertySheet operator()(const VertexRef& vertex) const { return vertexSheet(desk, vertex); }
    PropertySheet operator()(const EdgeRef& edge) const { return edgeSheet(desk, edge); }
    PropertySheet operator()(const RegionRef& region) const { return regionSheet(desk.document, region); }
    PropertySheet operator()(const FoldRef& fold) const { return foldSheet(desk.document, fold); }
    PropertySheet operator()(const SeamId& id) const { return seamSheet(desk, *findSeam(desk.document.pattern, id)); }
    PropertySheet operator()(const TackId& id) const {
        return tackSheet(desk.document, *findTack(desk.document.pattern, id));
    }
    PropertySheet operator()(const FabricId& id) const {
        return fabricSheet(desk.document, *findFabric(desk.document.pattern, id));
    }
    PropertySheet operator()(AvatarItem) const { return sceneSheet(desk.document); }
    PropertySheet operator()(SceneItem) const { return sceneSheet(desk.document); }
};

} // namespace

Effect effectOf(const QString& name, const ActionRow& action, const document::Document& document) {
    Effect effect = effectOf(name, action.act(document));
    if (effect.edit && action.losses) effect.message = action.losses(document);
    return effect;
}

PropertySheet sheetOf(const Desk& desk, const meshing::MeshReport& mesh) {
    const Selection selection = existing(desk.selection, desk.document.pattern);
    if (selection.empty()) return sceneSheet(desk.document);
    return std::visit(SheetOf{desk, mesh}, selection.back());
}

} // namespace toile::ui
