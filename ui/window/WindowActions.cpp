// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/MainWindow.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternPieces.h"
#include "ui/window/ShortcutDialog.h"
#include "ui/workbench/Arrange.h"

#include <QApplication>
#include <QDockWidget>
#include <QSettings>

namespace toile::ui {

std::vector<ActionSpec> MainWindow::fileActions() {
    return {
        {"file.new", tr("&New"), QKeySequence::New, "new", false, [this] { files_->startNew(); }},
        {"file.open", tr("&Open…"), QKeySequence::Open, "open", false, [this] { files_->open(); }},
        {"file.save", tr("&Save"), QKeySequence::Save, "save", false, [this] { files_->save(); }},
        {"file.saveAs", tr("Save &as…"), QKeySequence(tr("Ctrl+Shift+S")), {}, false, [this] { files_->saveAs(); }},
        {"file.exportDrape",
         tr("&Export drape…"),
         QKeySequence(tr("Ctrl+E")),
         {},
         false,
         [this] { files_->exportDrape(); }},
        {"file.quit", tr("&Quit"), QKeySequence(tr("Ctrl+Q")), {}, false, [this] { close(); }},
        {"avatar.import", tr("&Import avatar…"), {}, "avatar", false, [this] { files_->importAvatar(); }},
        {"avatar.mannequin", tr("Toile's &mannequin"), {}, {}, false, [this] { files_->useMannequin(); }},
        {"avatar.remove", tr("&Remove avatar"), {}, {}, false, [this] { workbench_.removeAvatar(); }},
        {"avatar.liftArms",
         tr("&Lift the arms"),
         QKeySequence(tr("Ctrl+L")),
         {},
         true,
         [this] { workbench_.liftArms(); },
         tr("See how the garment does with the arms up; again to let them down")},
        {"avatar.moveThroughPoses",
         tr("Move through &poses…"),
         QKeySequence(tr("Ctrl+Shift+L")),
         {},
         false,
         [this] { files_->moveAvatar(); },
         tr("See how the garment does while the avatar goes through a sequence of poses")},
        {"avatar.moveBack",
         tr("Move &back"),
         QKeySequence(tr("Ctrl+B")),
         {},
         false,
         [this] { workbench_.moveBack(); },
         tr("The way the avatar moved last, backwards")},
        {"help.about", tr("&About Toile"), {}, {}, false, [this] { about(); }},
    };
}

std::vector<ActionSpec> MainWindow::editActions() {
    const auto place = [this](BodySide side) {
        return [this, side] {
            workbench_.take(arranged(workbench_.desk(), workbench_.body() ? &**workbench_.body() : nullptr, side));
        };
    };
    return {
        {"place.front", tr("In &front of the body"), {}, {}, false, place(BodySide::front)},
        {"place.back", tr("&Behind the body"), {}, {}, false, place(BodySide::back)},
        {"place.left", tr("At its &left"), {}, {}, false, place(BodySide::left)},
        {"place.right", tr("At its &right"), {}, {}, false, place(BodySide::right)},
        {"edit.undo", tr("&Undo"), QKeySequence(tr("Ctrl+Z")), "undo", false, [this] { workbench_.undo(); }},
        {"edit.redo", tr("&Redo"), QKeySequence(tr("Ctrl+Shift+Z")), "redo", false, [this] { workbench_.redo(); }},
        {"edit.shortcuts",
         tr("&Keyboard shortcuts…"),
         {},
         {},
         false,
         [this] { ShortcutDialog(actions_, this).exec(); }},
        {"edit.delete", tr("&Delete"), QKeySequence::Delete, {}, false, [this] { pattern_->press(ToolKey::erase); }},
        {"edit.layOut",
         tr("&Lay out pieces"),
         {},
         {},
         false,
         [this] {
             workbench_.take(
                 effectOf(tr("Lay out pieces"),
                          document::edited(workbench_.document(), [](const pattern::Pattern& p, pattern::IdSource&) {
                              return Result<pattern::Pattern>(laidOut(p));
                          })));
             pattern_->fitAll();
         },
         tr("Put the pieces side by side on the table; shapes and drape stay as they are")},
    };
}

std::vector<ActionSpec> MainWindow::viewActions() {
    const auto look = [this](bool PatternLook::*part) {
        return [this, part] {
            PatternLook next = pattern_->look();
            next.*part = !(next.*part);
            pattern_->setLook(next);
        };
    };
    const auto render = [this](bool picture::RenderOptions::*part) {
        return [this, part] {
            picture::RenderOptions next = view3D_->scene().options;
            next.*part = !(next.*part);
            view3D_->setOptions(next);
        };
    };
    return {
        {"view.fitAll", tr("Fit &all"), QKeySequence(tr("Ctrl+9")), "fit", false,
         [this] {
             pattern_->fitAll();
             view3D_->fit();
         }},
        {"view.fitSelection",
         tr("Fit &selection"),
         QKeySequence(tr("Ctrl+8")),
         {},
         false,
         [this] { pattern_->fitSelection(); }},
        {"view.zoomIn", tr("Zoom &in"), QKeySequence::ZoomIn, {}, false, [this] { pattern_->zoomBy(1.25); }},
        {"view.zoomOut", tr("Zoom &out"), QKeySequence::ZoomOut, {}, false, [this] { pattern_->zoomBy(0.8); }},
        {"view.front",
         tr("&Front"),
         QKeySequence(tr("Ctrl+1")),
         {},
         false,
         [this] { view3D_->viewFront(); },
         {},
         tr("Front")},
        {"view.back",
         tr("&Back"),
         QKeySequence(tr("Ctrl+2")),
         {},
         false,
         [this] { view3D_->viewBack(); },
         {},
         tr("Back")},
        {"view.left",
         tr("&Left side"),
         QKeySequence(tr("Ctrl+3")),
         {},
         false,
         [this] { view3D_->viewLeft(); },
         {},
         tr("Left")},
        {"view.right",
         tr("&Right side"),
         QKeySequence(tr("Ctrl+4")),
         {},
         false,
         [this] { view3D_->viewRight(); },
         {},
         tr("Right")},
        {"view.top", tr("&Top"), QKeySequence(tr("Ctrl+5")), {}, false, [this] { view3D_->viewTop(); }, {}, tr("Top")},
        {"look.mesh", tr("&Mesh on the pattern"), QKeySequence(tr("Ctrl+M")), "mesh", true, look(&PatternLook::mesh)},
        {"look.regions", tr("&Regions on the pattern"), {}, {}, true, look(&PatternLook::regions)},
        {"look.seams", tr("&Seams on the pattern"), {}, {}, true, look(&PatternLook::seams)},
        {"look.cutLines", tr("C&ut lines on the pattern"), {}, {}, true, look(&PatternLook::cutLines)},
        {"look.names", tr("&Names on the pattern"), {}, {}, true, look(&PatternLook::names)},
        {"look.grid", tr("&Grid and rulers"), {}, {}, true, look(&PatternLook::grid)},
        {"look3d.body", tr("&Avatar"), {}, {}, true, render(&picture::RenderOptions::body), {}, tr("Avatar")},
        {"look3d.meshLines",
         tr("Mesh on the &cloth"),
         QKeySequence(tr("Ctrl+Shift+M")),
         {},
         true,
         render(&picture::RenderOptions::meshLines),
         {},
         tr("Mesh")},
        {"look3d.seams",
         tr("Seams on the cl&oth"),
         {},
         {},
         true,
         render(&picture::RenderOptions::seams),
         {},
         tr("Seams")},
        {"look3d.regions",
         tr("Regions on the clot&h"),
         {},
         {},
         true,
         render(&picture::RenderOptions::regions),
         {},
         tr("Regions")},
    };
}

std::vector<ActionSpec> MainWindow::simulationActions() {
    return {
        {"simulation.play", tr("&Simulate"), QKeySequence(Qt::Key_Space), "play", true,
         [this] { workbench_.isPlaying() ? workbench_.pause() : workbench_.play(); },
         tr("Start or pause the simulation")},
        {"simulation.step", tr("One s&tep"), QKeySequence(tr("Ctrl+.")), "step", false, [this] { workbench_.step(); }},
        {"simulation.reset", tr("&Reset"), QKeySequence(tr("Ctrl+R")), "reset", false, [this] { workbench_.reset(); },
         tr("Back to where the pieces were placed")},
        {"simulation.finish",
         tr("&Finish at rest"),
         {},
         {},
         true,
         [this] {
             const bool wanted = actions_["simulation.finish"]->isChecked();
             QSettings().setValue(finishAtRestKey, wanted);
             workbench_.finishAtRest(wanted);
         },
         tr("Find the equilibrium by statics when the cloth has come to rest: lengths are right within less")},
        {"simulation.accuracy",
         tr("&Accuracy"),
         {},
         {},
         true,
         [this] { accuracy_->setVisible(actions_["simulation.accuracy"]->isChecked()); },
         tr("Measure how wrong the drape is, and what less error would cost")},
        {"simulation.saveCheckpoint",
         tr("Save &checkpoint…"),
         {},
         {},
         false,
         [this] { files_->saveCheckpoint(); },
         tr("Keep where the simulation stands in a file, to go on from there another day")},
        {"simulation.resume",
         tr("R&esume…"),
         {},
         {},
         false,
         [this] { files_->resume(); },
         tr("Go on from a checkpoint of this pattern")},
    };
}

QString methodId(dynamics::Method method) {
    return QStringLiteral("method.") + QString::fromUtf8(dynamics::nameOf(method).data());
}

std::vector<ActionSpec> MainWindow::methodActions() {
    using dynamics::Method;
    const QString implicitTip = tr("Implicit steps at the cloth's true stiffness; slow");
    const QString explicitTip =
        tr("Explicit steps, as short as the stiffest spring asks for: to compare with; very slow");
    std::vector<ActionSpec> table;
    const auto row = [&](Method method, const QString& text, const QString& shortText, const QString& tip) {
        table.push_back({methodId(method), text, {}, {}, true, [this, method] { drapeWith(method); }, tip, shortText});
    };
    row(Method::xpbd, tr("&Fast: position-based (XPBD)"), tr("Fast"),
        tr("For fitting: the cloth follows the hand, and lengths are right once it is finished at rest"));
    row(Method::trBdf2, tr("&Accurate in motion (TR-BDF2)"), tr("TR-BDF2"),
        tr("How the cloth moves, its error controlled; many times slower, and at rest no nearer to the truth"));
    row(Method::backwardEuler, tr("Backward &Euler"), tr("Backward Euler"), implicitTip);
    row(Method::bdf2, tr("B&DF2"), tr("BDF2"), implicitTip);
    row(Method::midpoint, tr("Implicit &midpoint"), tr("Implicit midpoint"), implicitTip);
    row(Method::sdirk4, tr("&SDIRK4"), tr("SDIRK4"), implicitTip);
    row(Method::baraffWitkin, tr("&Baraff–Witkin"), tr("Baraff–Witkin"), implicitTip);
    row(Method::rk4, tr("&Runge–Kutta 4, explicit"), tr("Runge–Kutta 4"), explicitTip);
    row(Method::symplecticEuler, tr("S&ymplectic Euler, explicit"), tr("Symplectic Euler"), explicitTip);
    row(Method::subcycledEuler, tr("Subcycled E&uler, explicit"), tr("Subcycled Euler"), explicitTip);
    return table;
}

std::vector<ActionSpec> MainWindow::habitActions() {
    std::vector<ActionSpec> table;
    for (const auto& [id, text, habits] :
         {std::tuple("habits.clo", tr("As in &CLO: right drag orbits, middle drag pans"), CameraHabits::clo),
          std::tuple("habits.blender", tr("As in &Blender: middle drag orbits, with Shift pans"),
                     CameraHabits::blender),
          std::tuple("habits.maya", tr("As in &Maya: Alt with left, middle, right drag"), CameraHabits::maya)})
        table.push_back({QLatin1String(id), text, {}, {}, true, [this, id = QLatin1String(id), habits = habits] {
                             view3D_->setCameraHabits(habits);
                             QSettings().setValue(cameraHabitsKey, id);
                         }});
    return table;
}

std::vector<ActionSpec> MainWindow::toolActions() {
    std::vector<ActionSpec> table;
    for (const ToolBox::Entry& entry : tools_.entries())
        table.push_back({entry.id, entry.text, QKeySequence(entry.shortcut), entry.icon, true,
                         [this, id = entry.id] { useTool(id); }});
    return table;
}

} // namespace toile::ui
