// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/MainWindow.h"

#include "ui/accuracy/AccuracyPanel.h"
#include "ui/panels/ObjectList.h"
#include "ui/panels/PropertyEditor.h"
#include "ui/window/HandLink.h"

#include <QAbstractButton>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMessageBox>
#include <QSettings>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>

namespace toile::ui {
namespace {

/// A view with its bar above it.
QWidget* below(QWidget* bar, QWidget* view) {
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    bar->setFixedHeight(50);
    column->addWidget(bar);
    column->addWidget(view, 1);
    return side;
}

/// Before shortcuts are looked for: Space, where it presses or opens what has the focus.
bool isPressOfAField(const QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    QWidget* field = QApplication::focusWidget();
    return key.key() == Qt::Key_Space && key.modifiers() == Qt::NoModifier &&
           (qobject_cast<QAbstractButton*>(field) || qobject_cast<QComboBox*>(field));
}

} // namespace

MainWindow::MainWindow(Workbench& workbench, WindowParts parts, QWidget* parent)
    : QMainWindow(parent), workbench_(workbench), parts_(std::move(parts)) {
    setObjectName(QStringLiteral("mainWindow"));
    files_ = new FileCommands(workbench, *this, parts_.writeDrape, parts_.sampleFolders);
    makeViews();
    makeActions();
    makeMenus();
    makeToolBars();
    makeViewBar();
    makeAccuracyDock();
    connectWorkbench();
    useTool(QStringLiteral("tool.transform"));
    for (QWidget* window : std::initializer_list<QWidget*>{this, accuracy_}) // torn off, it is a window as well
        window->installEventFilter(this);
    restoreLook();
}

MainWindow::~MainWindow() {
    disconnect(&workbench_, nullptr, this, nullptr); // a field that loses the focus below still changes the document
    disconnect(accuracy_, nullptr, this, nullptr);   // a dock that is hidden below still tells of it
}

void MainWindow::makeViews() {
    view3D_ = new View3D;
    view3D_->setObjectName(QStringLiteral("view3D"));
    pattern_ = new PatternView(workbench_);
    options_ = new ToolOptions(tools_);
    viewBar_ = new QToolBar;
    QWidget* bodySide = below(viewBar_, view3D_);
    QWidget* patternSide = below(options_, pattern_);

    auto* panels = new QSplitter(Qt::Vertical);
    panels->setObjectName(QStringLiteral("panels"));
    panels->addWidget(new ObjectList(workbench_));
    panels->addWidget(new PropertyEditor(workbench_));
    panels->setStretchFactor(0, 2);
    panels->setStretchFactor(1, 3);
    panels->setMinimumWidth(240);
    panels->setChildrenCollapsible(false);

    auto* sides = new QSplitter(Qt::Horizontal);
    sides->setObjectName(QStringLiteral("sides"));
    for (QWidget* part : std::initializer_list<QWidget*>{bodySide, patternSide, panels}) sides->addWidget(part);
    sides->setStretchFactor(0, 5);
    sides->setStretchFactor(1, 7);
    sides->setStretchFactor(2, 0);
    sides->setSizes({560, 660, 280});
    sides->setChildrenCollapsible(false);
    setCentralWidget(sides);
    status_ = new StatusLine;
    setStatusBar(status_);
    link_ = new SceneLink(workbench_, *view3D_, this);
    new HandLink(workbench_, *view3D_, this);
}

/// Below the views, and hidden until it is asked for; it can be torn off.
void MainWindow::makeAccuracyDock() {
    auto* panel = new AccuracyPanel(workbench_, parts_.accuracy);
    accuracy_ = new QDockWidget(tr("Accuracy"), this);
    accuracy_->setObjectName(QStringLiteral("accuracyDock"));
    accuracy_->setWidget(panel);
    addDockWidget(Qt::BottomDockWidgetArea, accuracy_);
    accuracy_->hide();
    connect(accuracy_, &QDockWidget::visibilityChanged, this,
            [this] { actions_["simulation.accuracy"]->setChecked(!accuracy_->isHidden()); });
    connect(panel, &AccuracyPanel::resultShown, this, [this] {
        constexpr int roomForAChart = 400; // [pixels]
        if (accuracy_->height() < roomForAChart) resizeDocks({accuracy_}, {roomForAChart}, Qt::Vertical);
    });
    connect(panel, &AccuracyPanel::methodWanted, this, &MainWindow::drapeWith);
    connect(panel, &AccuracyPanel::finishWanted, this, [this] {
        if (QAction* finish = actions_["simulation.finish"]; !finish->isChecked()) finish->trigger();
    });
}

void MainWindow::makeActions() {
    for (const auto& table : {fileActions(), editActions(), viewActions(), simulationActions(), methodActions(),
                              habitActions(), toolActions()})
        actions_.add(*this, table);
    auto* tools = new QActionGroup(this);
    for (const ToolBox::Entry& entry : tools_.entries()) tools->addAction(actions_[entry.id]);
    auto* habits = new QActionGroup(this);
    for (const char* id : {"habits.clo", "habits.blender", "habits.maya"})
        habits->addAction(actions_[QLatin1String(id)]);
    auto* methods = new QActionGroup(this);
    for (const dynamics::Method method : dynamics::allMethods()) methods->addAction(actions_[methodId(method)]);
    const QString kept = QSettings().value(drapingMethodKey).toString();
    drapeWith(dynamics::methodNamed(kept.toStdString()).value_or(dynamics::Method::xpbd));
    const QString habit = QSettings().value(cameraHabitsKey).toString();
    for (QAction* action : habits->actions())
        if (action->objectName() == habit || (habit.isEmpty() && action == habits->actions().front()))
            action->trigger();
    const PatternLook look = pattern_->look();
    const picture::RenderOptions render = view3D_->scene().options;
    for (const auto& [id, on] :
         std::initializer_list<std::pair<const char*, bool>>{{"look.mesh", look.mesh},
                                                             {"look.regions", look.regions},
                                                             {"look.seams", look.seams},
                                                             {"look.cutLines", look.cutLines},
                                                             {"look.names", look.names},
                                                             {"look.grid", look.grid},
                                                             {"look3d.body", render.body},
                                                             {"look3d.meshLines", render.meshLines},
                                                             {"look3d.seams", render.seams},
                                                             {"look3d.regions", render.regions}})
        actions_[QLatin1String(id)]->setChecked(on);
    if (QSettings().value(finishAtRestKey, true).toBool()) actions_["simulation.finish"]->trigger();
}

void MainWindow::connectWorkbench() {
    connect(&workbench_, &Workbench::fileChanged, this, &MainWindow::showTitle);
    connect(&workbench_, &Workbench::documentChanged, this, &MainWindow::showHistory);
    connect(&workbench_, &Workbench::documentReplaced, this, [this] { pattern_->fitAll(); });
    connect(&workbench_, &Workbench::messageChanged, status_, &StatusLine::tell);
    const auto showFrame = [this] {
        status_->showFrame(workbench_.frame() ? &*workbench_.frame() : nullptr, workbench_.isPlaying());
        showMotion();
    };
    connect(&workbench_, &Workbench::frameArrived, this, showFrame);
    connect(&workbench_, &Workbench::bodyChanged, this, &MainWindow::showMotion);
    connect(&workbench_, &Workbench::posesRead, this, &MainWindow::showMotion);
    connect(&workbench_, &Workbench::playingChanged, this, [this, showFrame] {
        showFrame();
        QAction* play = actions_["simulation.play"];
        play->setChecked(workbench_.isPlaying());
        play->setIcon(
            QIcon(workbench_.isPlaying() ? QStringLiteral(":/icons/pause.svg") : QStringLiteral(":/icons/play.svg")));
    });
    connect(pattern_, &PatternView::pointerMoved, status_, &StatusLine::showPointer);
    connect(pattern_, &PatternView::toolMoved, this, &MainWindow::showTool);
    connect(pattern_, &PatternView::menuWanted, this, &MainWindow::showMenu);
    showTitle();
    showHistory();
    showMotion();
}

void MainWindow::useTool(const QString& id) {
    tool_ = id;
    actions_[id]->setChecked(true);
    pattern_->setTool(tools_.entry(id).tool.get());
    pattern_->setFocus();
    showTool();
}

void MainWindow::showTool() {
    options_->show(tools_.entry(tool_));
}

void MainWindow::showMotion() {
    const bool armsAreUp = workbench_.armsAreUp();
    const QString there = workbench_.whyNotMoved(), back = workbench_.whyNotMovedBack();
    actions_.allow(QStringLiteral("avatar.liftArms"), armsAreUp ? back : there);
    actions_["avatar.liftArms"]->setChecked(armsAreUp);
    actions_.allow(QStringLiteral("avatar.moveThroughPoses"), there);
    actions_.allow(QStringLiteral("avatar.moveBack"), back);
    const QString stays = workbench_.whyMethodStays();
    for (const dynamics::Method method : dynamics::allMethods())
        actions_.allow(methodId(method), method == workbench_.method() ? QString() : stays);
}

void MainWindow::drapeWith(dynamics::Method method) {
    QAction* action = actions_[methodId(method)];
    action->setChecked(true);
    QSettings().setValue(drapingMethodKey, QString::fromUtf8(dynamics::nameOf(method).data()));
    workbench_.drapeWith(method);
    status_->showMethod(method == dynamics::Method::xpbd ? QString() : action->iconText());
    showMotion();
}

void MainWindow::showTitle() {
    const QString name = workbench_.path().isEmpty() ? tr("Untitled") : QFileInfo(workbench_.path()).fileName();
    setWindowTitle(tr("%1[*] – Toile").arg(name));
    setWindowModified(workbench_.isModified());
}

void MainWindow::showHistory() {
    const document::History& history = workbench_.history();
    const auto show = [this](const char* id, const QString& whyNot, const QString& text, const std::string& step) {
        actions_.allow(QLatin1String(id), whyNot);
        actions_[QLatin1String(id)]->setText(step.empty() ? text
                                                          : tr("%1 “%2”").arg(text, QString::fromStdString(step)));
    };
    show("edit.undo", history.canUndo() ? QString() : tr("There is nothing to undo."), tr("&Undo"), history.undoName());
    show("edit.redo", history.canRedo() ? QString() : tr("There is nothing to redo."), tr("&Redo"), history.redoName());
    actions_.allow(QStringLiteral("avatar.remove"),
                   workbench_.document().avatarFile.empty() ? tr("There is no avatar.") : QString());
}

void MainWindow::about() {
    QMessageBox box(QMessageBox::NoIcon, tr("About Toile"), tr("Toile – garment pattern editor and simulation viewer"),
                    QMessageBox::Ok, this);
    box.setIconPixmap(QIcon(QStringLiteral(":/icons/toile.svg")).pixmap(64, 64));
    const QString device = view3D_->deviceName();
    box.setInformativeText(parts_.aboutText +
                           (device.isEmpty() ? QString() : QStringLiteral("\n") + tr("Graphics: %1").arg(device)));
    box.exec();
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (!isPressOfAField(*event)) return QMainWindow::eventFilter(watched, event);
    event->accept(); // no shortcut, but a key for the field
    return true;
}

/// Of keys that nothing below and no shortcut took: Qt passes over shortcuts of what is disabled.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    const QString why = actions_.whyNot(QKeySequence(event->keyCombination()));
    if (why.isEmpty()) QMainWindow::keyPressEvent(event);
    else status_->hint(why);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->mayDiscard()) return event->ignore();
    keepLook();
    if (Journal* journal = workbench_.journal()) journal->clear();
    event->accept();
}

} // namespace toile::ui
