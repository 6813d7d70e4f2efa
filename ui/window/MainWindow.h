// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/accuracy/AccuracyStudy.h"
#include "ui/pattern/PatternView.h"
#include "ui/view3d/View3D.h"
#include "ui/window/Actions.h"
#include "ui/window/FileCommands.h"
#include "ui/window/SceneLink.h"
#include "ui/window/StatusLine.h"
#include "ui/window/ToolBox.h"
#include "ui/window/ToolOptions.h"

#include <QMainWindow>

class QDockWidget;
class QMenu;
class QToolBar;

namespace toile::ui {

/// Of the action that chooses it.
[[nodiscard]] QString methodId(dynamics::Method method);

/// What the window gets from outside beside the workbench.
struct WindowParts {
    FileCommands::DrapeWriter writeDrape;
    QStringList sampleFolders;
    QString aboutText; ///< facts of the build
    AccuracyParts accuracy = {};
};

/// Of the settings: the id of the chosen action.
inline const QString cameraHabitsKey = QStringLiteral("cameraHabits");

/// Of the settings: whether a garment at rest is finished by statics.
inline const QString finishAtRestKey = QStringLiteral("finishAtRest");

/// Of the settings: by which method a sewn garment is draped, as dynamics::nameOf.
inline const QString drapingMethodKey = QStringLiteral("drapingMethod");

/// Puts the parts together; decides nothing. 3D view left, pattern right, objects and properties far right.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(Workbench& workbench, WindowParts parts, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] PatternView& patternView() { return *pattern_; }
    [[nodiscard]] View3D& view3D() { return *view3D_; }
    [[nodiscard]] FileCommands& files() { return *files_; }
    [[nodiscard]] const Actions& actions() const { return actions_; }
    void useTool(const QString& id);

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeActions();
    void makeMenus();
    void makeFabricMenu(QMenu& menu);
    void makeToolBars();
    void makeViewBar(); ///< above the 3D view
    void makeViews();
    void makeAccuracyDock();
    void connectWorkbench();
    void keepLook() const; ///< in the settings, for the next window
    void restoreLook();
    void showTitle();
    void showHistory();
    void showTool();
    void showMotion(); ///< which commands move the avatar, and whether the method may change
    void drapeWith(dynamics::Method method);
    void showMenu(const Selection& under, QPoint globalPosition);
    void about();

    [[nodiscard]] std::vector<ActionSpec> fileActions();
    [[nodiscard]] std::vector<ActionSpec> editActions();
    [[nodiscard]] std::vector<ActionSpec> viewActions();
    [[nodiscard]] std::vector<ActionSpec> simulationActions();
    [[nodiscard]] std::vector<ActionSpec> methodActions();
    [[nodiscard]] std::vector<ActionSpec> habitActions();
    [[nodiscard]] std::vector<ActionSpec> toolActions();

    Workbench& workbench_;
    WindowParts parts_;
    ToolBox tools_;
    QString tool_;
    Actions actions_;
    FileCommands* files_ = nullptr;
    View3D* view3D_ = nullptr;
    QToolBar* viewBar_ = nullptr;
    QMenu* methods_ = nullptr; ///< stands in the menu and at the button that plays
    PatternView* pattern_ = nullptr;
    ToolOptions* options_ = nullptr;
    StatusLine* status_ = nullptr;
    QDockWidget* accuracy_ = nullptr;
    SceneLink* link_ = nullptr;
};

} // namespace toile::ui
