// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ToolBox.h"

#include "core/base/Contracts.h"
#include "ui/tools/CutHole.h"
#include "ui/tools/DrawInternalLine.h"
#include "ui/tools/DrawPiece.h"
#include "ui/tools/EditNotches.h"
#include "ui/tools/EditPoints.h"
#include "ui/tools/EditSewing.h"
#include "ui/tools/MovePieces.h"
#include "ui/tools/PressFolds.h"
#include "ui/tools/SetTacks.h"
#include "ui/tools/SewFree.h"
#include "ui/tools/SewSegments.h"
#include "ui/values/Words.h"

#include <algorithm>

namespace toile::ui {

ToolBox::ToolBox() {
    const auto add = [this](const char* id, const QString& text, const char* shortcut, const char* icon,
                            std::unique_ptr<Tool> tool, Uses uses = Uses::nothing) {
        entries_.push_back(
            {QLatin1String(id), text, QLatin1String(shortcut), QLatin1String(icon), std::move(tool), uses});
    };
    add("tool.transform", tr("Move pieces"), "A", "transform", std::make_unique<MovePieces>());
    add("tool.editPoints", tr("Edit points"), "Z", "edit-points", std::make_unique<EditPoints>());
    add("tool.drawPiece", tr("Draw piece"), "Shift+D", "draw-piece", std::make_unique<DrawPiece>());
    add("tool.internalLine", tr("Internal line"), "D", "internal-line", std::make_unique<DrawInternalLine>());
    add("tool.fold", tr("Press fold"), "Shift+F", "fold", std::make_unique<PressFolds>());
    add("tool.notch", tr("Notch"), "Shift+N", "notch", std::make_unique<EditNotches>());
    add("tool.dart", tr("Dart"), "Shift+T", "dart", std::make_unique<CutDart>(dart), Uses::dart);
    add("tool.hole", tr("Cut hole"), "Shift+H", "hole", std::make_unique<CutHole>());
    add("tool.paintPolygon", tr("Paint region by corners"), "Shift+R", "region-polygon",
        std::make_unique<PaintPolygon>(paint), Uses::spacing);
    add("tool.paintBrush", tr("Paint region with a brush"), "Shift+B", "region-brush",
        std::make_unique<PaintBrush>(paint), Uses::brush);
    add("tool.sewSegments", tr("Sew edges"), "N", "sew-segments", std::make_unique<SewSegments>());
    add("tool.sewFree", tr("Sew parts of edges"), "M", "sew-free", std::make_unique<SewFree>());
    add("tool.editSewing", tr("Edit sewing"), "B", "sew-edit", std::make_unique<EditSewing>());
    add("tool.tack", tr("Tack or button"), "Shift+K", "tack", std::make_unique<SetTacks>());
}

const ToolBox::Entry& ToolBox::entry(const QString& id) const {
    const auto found = std::ranges::find(entries_, id, &Entry::id);
    expects(found != entries_.end(), "a tool of this id");
    return *found;
}

} // namespace toile::ui
