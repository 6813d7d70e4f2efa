// SPDX-License-Identifier: GPL-3.0-or-later
// Which actions stand where: menus, bars, and the menu of the right button. What they do: WindowActions.cpp.
#include "core/material/FabricPresets.h"
#include "ui/panels/PropertySheet.h"
#include "ui/window/MainWindow.h"
#include "ui/workbench/AddFabric.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace toile::ui {

void MainWindow::makeMenus() {
    const auto menu = [this](const QString& title, const QStringList& ids) {
        QMenu* made = menuBar()->addMenu(title);
        made->setToolTipsVisible(true); // they say why what is disabled cannot be done
        actions_.fill(*made, ids);
        return made;
    };
    QStringList tools;
    for (const ToolBox::Entry& entry : tools_.entries()) tools << entry.id;
    QMenu* file = menu(tr("&File"), {"file.new", "file.open"});
    auto* recent = file->addMenu(tr("Open &recent"));
    auto* samples = file->addMenu(tr("Sa&mples"));
    samples->setObjectName(QStringLiteral("samplesMenu"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { files_->fillRecent(*recent); });
    connect(samples, &QMenu::aboutToShow, this, [this, samples] { files_->fillSamples(*samples); });
    actions_.fill(*file, {"-", "file.save", "file.saveAs", "file.exportDrape", "-", "file.quit"});
    QMenu* edit = menu(tr("&Edit"), {"edit.undo", "edit.redo", "-", "edit.delete", "edit.layOut"});
    actions_.fill(*edit->addMenu(tr("&Place selected pieces")),
                  {"place.front", "place.back", "place.left", "place.right"});
    makeFabricMenu(*edit->addMenu(tr("Add &fabric")));
    actions_.fill(*edit, {"-", "edit.shortcuts"});
    menu(tr("&Tools"), tools);
    QMenu* view = menu(
        tr("&View"), {"view.fitAll",  "view.fitSelection", "view.zoomIn",   "view.zoomOut",   "-",         "view.front",
                      "view.back",    "view.left",         "view.right",    "view.top",       "-",         "look.mesh",
                      "look.regions", "look.seams",        "look.cutLines", "look.names",     "look.grid", "-",
                      "look3d.body",  "look3d.meshLines",  "look3d.seams",  "look3d.regions", "-"});
    actions_.fill(*view->addMenu(tr("Mouse in the &3D view")), {"habits.clo", "habits.blender", "habits.maya"});
    menu(tr("&Avatar"), {"avatar.mannequin", "avatar.import", "avatar.remove", "-", "avatar.liftArms",
                         "avatar.moveThroughPoses", "avatar.moveBack"});
    QMenu* simulation = menu(tr("&Simulation"), {"simulation.play", "simulation.step", "simulation.reset", "-"});
    methods_ = simulation->addMenu(tr("&Method"));
    methods_->setObjectName(QStringLiteral("methodMenu"));
    methods_->setToolTipsVisible(true);
    actions_.fill(*methods_, {"method.xpbd", "method.trbdf2", "-", "method.backward-euler", "method.bdf2",
                              "method.midpoint", "method.sdirk4", "method.baraff-witkin", "-", "method.rk4",
                              "method.symplectic-euler", "method.subcycled-euler"});
    actions_.fill(*simulation,
                  {"simulation.finish", "simulation.accuracy", "-", "simulation.saveCheckpoint", "simulation.resume"});
    menu(tr("&Help"), {"help.about"});
}

/// Everyday fabrics first, then the measured ones.
void MainWindow::makeFabricMenu(QMenu& menu) {
    menu.setObjectName(QStringLiteral("fabricMenu"));
    for (const auto& fabrics : {material::everydayFabrics(), material::measuredFabrics()}) {
        if (!menu.isEmpty()) menu.addSeparator();
        for (const material::Fabric& fabric : fabrics)
            menu.addAction(QString::fromStdString(fabric.name), this,
                           [this, fabric] { workbench_.take(fabricAdded(workbench_.desk(), fabric)); });
    }
}

void MainWindow::makeToolBars() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    bar->setIconSize({22, 22});
    actions_.fill(*bar, {"file.new",
                         "file.open",
                         "file.save",
                         "-",
                         "edit.undo",
                         "edit.redo",
                         "-",
                         "simulation.play",
                         "simulation.step",
                         "simulation.reset",
                         "-",
                         "tool.transform",
                         "tool.editPoints",
                         "tool.drawPiece",
                         "tool.internalLine",
                         "tool.fold",
                         "tool.notch",
                         "tool.dart",
                         "tool.hole",
                         "-",
                         "tool.paintPolygon",
                         "tool.paintBrush",
                         "-",
                         "tool.sewSegments",
                         "tool.sewFree",
                         "tool.editSewing",
                         "tool.tack",
                         "-",
                         "look.mesh",
                         "view.fitAll"});
    auto* play = qobject_cast<QToolButton*>(bar->widgetForAction(actions_["simulation.play"]));
    play->setMenu(methods_);
    play->setPopupMode(QToolButton::MenuButtonPopup);
}

void MainWindow::makeViewBar() {
    viewBar_->setObjectName(QStringLiteral("viewBar"));
    viewBar_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    actions_.fill(*viewBar_, {"view.front", "view.left", "view.back", "view.right", "view.top", "-", "look3d.body",
                              "look3d.meshLines", "look3d.seams", "look3d.regions"});
}

/// What can be done with what is under the pointer: the actions of its property sheet.
void MainWindow::showMenu(const Selection& under, QPoint globalPosition) {
    QMenu menu(this);
    for (const Item& item : under) {
        const PropertySheet sheet =
            sheetOf({workbench_.document(), workbench_.flat(), {item}}, workbench_.meshReport());
        menu.addAction(tr("Select %1").arg(sheet.title.toLower()), this, [this, item] { workbench_.select({item}); });
        for (const PropertyRow& row : sheet.rows) {
            const auto* action = std::get_if<ActionRow>(&row.content);
            if (!action) continue;
            menu.addAction(QStringLiteral("    ") + row.label, this, [this, act = *action, label = row.label] {
                workbench_.take(effectOf(label, act, workbench_.document()));
            });
        }
    }
    if (!under.empty()) menu.addSeparator();
    if (!under.empty() && std::holds_alternative<pattern::PieceId>(under.back())) {
        if (!contains(workbench_.selection(), under.back())) workbench_.select({under.back()});
        actions_.fill(*menu.addMenu(tr("Place piece")), {"place.front", "place.back", "place.left", "place.right"});
    }
    actions_.fill(menu, {"view.fitAll", "edit.layOut"});
    menu.exec(globalPosition);
}

} // namespace toile::ui
