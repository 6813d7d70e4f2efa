// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/CutDart.h"
#include "ui/tools/PaintRegion.h"
#include "ui/tools/Tool.h"

#include <QString>

#include <memory>
#include <vector>

namespace toile::ui {

/// All tools of the pattern view, by the ids of their actions.
class ToolBox {
public:
    ToolBox();

    enum class Uses { nothing, spacing, brush, dart };
    struct Entry {
        QString id, text, shortcut, icon;
        std::unique_ptr<Tool> tool;
        Uses uses = Uses::nothing;
    };
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    [[nodiscard]] const Entry& entry(const QString& id) const;

    PaintOptions paint;
    DartOptions dart;

private:
    std::vector<Entry> entries_;
};

} // namespace toile::ui
