// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/AddFabric.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternFabrics.h"
#include "ui/values/Words.h"

namespace toile::ui {

using namespace pattern;

Effect fabricAdded(const Desk& desk, material::Fabric fabric) {
    const QString name = tr("Add fabric");
    Effect effect = effectOf(name, document::edited(desk.document, [&](const Pattern& pattern, IdSource& ids) {
                                 fabric.id = ids.take<FabricId>();
                                 return addFabric(pattern, fabric);
                             }));
    if (effect.edit) effect.selection = Selection{fabric.id};
    return effect;
}

} // namespace toile::ui
