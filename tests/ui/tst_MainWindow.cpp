// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "tests/Suite.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>

using namespace toile;
using namespace toile::ui;

class tst_MainWindow : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        prepareApplication();
        QSettings().clear();
    }
    void propertiesChangeTheDocument();
    void undoIsOneKeyPerStep();
    void keysOfWhatCannotBeDoneSayWhy();
    void unsavedChangesAskBeforeTheyAreLost();
    void noShortcutIsUsedTwiceOrClosesTheWindow();
    void shortcutsAreTheUsers();
    void deleteTakesOutWhatIsSelectedWhateverTheTool();
    void theMouseInSpaceFollowsTheUsersHabits();
    void detailsDrawnByHandAreMeshedAndSewn();
    void fabricsAreAddedDuplicatedAndDeleted();
    void deleteTakesOutWhatIsSelectedWhereverTheFocusIs();
    void theHintFollowsWhatDeleteTakesBack();
    void whatIsHalfDrawnEndsWithItsDocument();
    void theNextWindowHasTheSizesOfTheLastOne();
    void theNextWindowShowsWhatTheLastOneDid();
    void theMethodIsChosenAtThePlayButtonAndKept();
};

void tst_MainWindow::propertiesChangeTheDocument() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    bench.workbench.select({bench.pattern().pieces[0]->id});
    bench.find<QDoubleSpinBox>("spacing")->setValue(12.5);
    QCOMPARE(bench.pattern().pieces[0]->spacing, 0.0125);
    QVERIFY(bench.workbench.history().undoName() == "Particle distance");
    bench.workbench.undo();
    QCOMPARE(bench.find<QDoubleSpinBox>("spacing")->value(), 20.0);
}

void tst_MainWindow::undoIsOneKeyPerStep() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    bench.window.patternView().setView({{0.15, 0}, 1500, bench.window.patternView().size()});
    bench.key(Qt::Key_Z);
    bench.drag({0.1, 0.15}, {0.12, 0.17});
    QVERIFY(!(bench.workbench.document() == twoRectangles()));
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.workbench.document() == twoRectangles());
    bench.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!(bench.workbench.document() == twoRectangles()));
}

void tst_MainWindow::keysOfWhatCannotBeDoneSayWhy() {
    Bench bench;
    const QLabel& said = *bench.find<QLabel>("statusMessage");
    const auto undo = [&] { QTest::keyClick(&bench.window.patternView(), Qt::Key_Z, Qt::ControlModifier); };
    bench.key(Qt::Key_L, Qt::ControlModifier);
    QCOMPARE(said.text(), QStringLiteral("Lift the arms: There is no avatar that could move."));
    undo();
    QCOMPARE(said.text(), QStringLiteral("Undo: There is nothing to undo."));
    bench.workbench.startFrom(twoRectangles(), {}, false);
    bench.key(Qt::Key_Z);
    bench.drag({0.1, 0.15}, {0.12, 0.17});
    bench.workbench.tell({});
    undo();
    QVERIFY(bench.workbench.document() == twoRectangles());
    QVERIFY2(said.text().isEmpty(), qPrintable(said.text()));
}

void tst_MainWindow::unsavedChangesAskBeforeTheyAreLost() {
    Bench bench;
    bench.workbench.apply({QStringLiteral("Draw"), twoRectangles()});
    QVERIFY(bench.window.isWindowModified());
    QTimer::singleShot(0, [] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        QVERIFY(box);
        box->button(QMessageBox::Cancel)->click();
    });
    QVERIFY(!bench.window.close());
    QVERIFY(bench.window.isVisible());
    QTimer::singleShot(0, [] {
        qobject_cast<QMessageBox*>(QApplication::activeModalWidget())->button(QMessageBox::Discard)->click();
    });
    QVERIFY(bench.window.close());
}

void tst_MainWindow::noShortcutIsUsedTwiceOrClosesTheWindow() {
    Bench bench;
    QStringList used;
    for (const QAction* action : bench.window.actions().all()) {
        const QString shortcut = action->shortcut().toString();
        if (shortcut.isEmpty()) continue;
        QVERIFY2(!used.contains(shortcut), qPrintable(shortcut));
        used << shortcut;
    }
    QVERIFY(!used.contains(QStringLiteral("Ctrl+W")));
    const QStringList singleLetters = used.filter(QRegularExpression(QStringLiteral("^[A-Z]$")));
    QCOMPARE(QSet<QString>(singleLetters.begin(), singleLetters.end()), (QSet<QString>{"A", "Z", "N", "M", "B", "D"}));
}

void tst_MainWindow::shortcutsAreTheUsers() {
    const auto choose = [](Bench& bench, const char* id, const std::function<void(QDialog&)>& answer) {
        Bench::whenAsked<QDialog>([&](QDialog& dialog) {
            auto* list = dialog.findChild<QTreeWidget*>(QStringLiteral("shortcutList"));
            for (int i = 0; i < list->topLevelItemCount(); ++i)
                if (list->topLevelItem(i)->data(0, Qt::UserRole).toString() == QLatin1String(id))
                    list->setCurrentItem(list->topLevelItem(i));
            answer(dialog);
        });
        bench.action("edit.shortcuts")->trigger();
    };
    const auto press = [](QDialog& dialog, Qt::Key key, QDialogButtonBox::StandardButton button) {
        auto* keys = dialog.findChild<QKeySequenceEdit*>(QStringLiteral("shortcutKeys"));
        keys->setKeySequence(QKeySequence(key));
        Q_EMIT keys->editingFinished();
        dialog.findChild<QDialogButtonBox*>()->button(button)->click();
    };
    {
        Bench bench;
        choose(bench, "tool.editSewing", [&](QDialog& dialog) { press(dialog, Qt::Key_N, QDialogButtonBox::Cancel); });
        QCOMPARE(bench.action("tool.editSewing")->shortcut(), QKeySequence(Qt::Key_B));
        choose(bench, "tool.editSewing", [&](QDialog& dialog) { press(dialog, Qt::Key_N, QDialogButtonBox::Ok); });
        QCOMPARE(bench.action("tool.editSewing")->shortcut(), QKeySequence(Qt::Key_N));
        QVERIFY(bench.action("tool.sewSegments")->shortcut().isEmpty()); // nobody shares keys
        bench.key(Qt::Key_N);
        QVERIFY(bench.action("tool.editSewing")->isChecked());
    }
    Bench bench; // the next window knows
    QCOMPARE(bench.action("tool.editSewing")->shortcut(), QKeySequence(Qt::Key_N));
    Bench::whenAsked<QDialog>([](QDialog& dialog) {
        auto* buttons = dialog.findChild<QDialogButtonBox*>();
        buttons->button(QDialogButtonBox::RestoreDefaults)->click();
        buttons->button(QDialogButtonBox::Ok)->click();
    });
    bench.action("edit.shortcuts")->trigger();
    QCOMPARE(bench.action("tool.editSewing")->shortcut(), QKeySequence(Qt::Key_B));
    QCOMPARE(bench.action("tool.sewSegments")->shortcut(), QKeySequence(Qt::Key_N));
    QVERIFY(QSettings().childGroups().filter(QStringLiteral("shortcuts")).isEmpty());
}

void tst_MainWindow::deleteTakesOutWhatIsSelectedWhateverTheTool() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    for (const ToolBox tools; const ToolBox::Entry& entry : tools.entries()) {
        bench.window.useTool(entry.id);
        bench.workbench.select({bench.pattern().pieces[1]->id});
        bench.toolKey(Qt::Key_Delete);
        QVERIFY2(bench.pattern().pieces.size() == 1, qPrintable(entry.id));
        bench.workbench.undo();
    }
}

void tst_MainWindow::theMouseInSpaceFollowsTheUsersHabits() {
    const auto orbits = [](Bench& bench, Qt::MouseButton button) {
        View3D& view = bench.window.view3D();
        const double before = view.camera().yaw;
        QTest::mousePress(&view, button, {}, {100, 100});
        QMouseEvent move(QEvent::MouseMove, QPointF(150, 100), view.mapToGlobal(QPointF(150, 100)), Qt::NoButton,
                         button, Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
        QTest::mouseRelease(&view, button, {}, {150, 100});
        return view.camera().yaw != before;
    };
    {
        Bench bench;
        QVERIFY(orbits(bench, Qt::RightButton) && !orbits(bench, Qt::MiddleButton));
        bench.action("habits.blender")->trigger();
    }
    Bench bench; // the next window knows
    QVERIFY(!orbits(bench, Qt::RightButton) && orbits(bench, Qt::MiddleButton));
    QVERIFY(bench.action("habits.blender")->isChecked());
    bench.action("habits.clo")->trigger();
}

void tst_MainWindow::detailsDrawnByHandAreMeshedAndSewn() {
    Bench bench;
    bench.look({0.3, 0.25}, 1000);
    bench.key(Qt::Key_D, Qt::ShiftModifier);
    for (const Vec2 at : {Vec2{0, 0}, {0.5, 0}, {0.46, 0.5}, {0.04, 0.5}}) bench.click(at);
    bench.toolKey(Qt::Key_Return);
    bench.key(Qt::Key_T, Qt::ShiftModifier); // two darts in the waist
    for (const double x : {0.15, 0.35}) {
        bench.click({x, 0.5});
        bench.click({x, 0.38});
    }
    bench.key(Qt::Key_H, Qt::ShiftModifier);
    for (const Vec2 at : {Vec2{0.2, 0.15}, {0.3, 0.15}, {0.3, 0.25}, {0.2, 0.25}}) bench.click(at);
    bench.toolKey(Qt::Key_Return);
    bench.key(Qt::Key_N, Qt::ShiftModifier);
    bench.click({0.25, 0});
    bench.key(Qt::Key_Z);
    for (const Vec2 corner : {Vec2{0.04, 0.5}, {0.46, 0.5}}) { // it hangs from its upper corners
        bench.click(corner);
        bench.find<QCheckBox>("pinned")->click();
    }
    const pattern::Piece& piece = *bench.pattern().pieces[0];
    QCOMPARE(bench.pattern().seams.size(), std::size_t(2));
    QCOMPARE(piece.holes.size(), std::size_t(1));
    QCOMPARE(piece.notches.size(), std::size_t(1));
    QCOMPARE(bench.pattern().pins.size(), std::size_t(2));
    QTRY_VERIFY(bench.workbench.mesh().size() == 1 && !bench.workbench.mesh()[0].lines.empty());
    bench.picture("details.png");
    QTRY_VERIFY(bench.workbench.frame() && bench.workbench.frame()->largestSeamGap > 0.02); // the mouths are open
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.workbench.frame()->time > 1.5 && bench.workbench.frame()->largestSeamGap == 0,
                             120000);
    bench.picture("details-sewn.png");
    bench.key(Qt::Key_Space);
}

void tst_MainWindow::fabricsAreAddedDuplicatedAndDeleted() {
    Bench bench;
    const auto fabrics = [&]() -> auto& {
        return bench.pattern().fabrics;
    };
    QCOMPARE(fabrics().size(), std::size_t(1)); // a new document has one
    QAction* first = bench.find<QMenu>("fabricMenu")->actions().front();
    first->trigger();
    first->trigger(); // the same again is another fabric
    QCOMPARE(fabrics().size(), std::size_t(3));
    QVERIFY(fabrics()[1]->id != fabrics()[2]->id);
    QCOMPARE(QString::fromStdString(fabrics()[2]->name), first->text());
    QVERIFY(bench.workbench.selection() == Selection{fabrics()[2]->id});
    bench.find<QPushButton>("duplicate")->click();
    QCOMPARE(fabrics().size(), std::size_t(4));
    QCOMPARE(fabrics()[3]->warpStiffness, fabrics()[2]->warpStiffness);
    bench.find<QPushButton>("remove")->click();
    QCOMPARE(fabrics().size(), std::size_t(3));
    bench.workbench.undo();
    QCOMPARE(fabrics().size(), std::size_t(4));
}

void tst_MainWindow::deleteTakesOutWhatIsSelectedWhereverTheFocusIs() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    QApplication::setActiveWindow(&bench.window);
    for (QWidget* place : std::initializer_list<QWidget*>{bench.find<QTreeWidget>("objectList"), &bench.window.view3D(),
                                                          &bench.window.patternView()}) {
        bench.workbench.select({bench.pattern().pieces[1]->id});
        place->setFocus();
        QTest::keyClick(place, Qt::Key_Delete);
        QVERIFY2(bench.pattern().pieces.size() == 1, qPrintable(place->objectName()));
        bench.workbench.undo();
    }
    bench.workbench.select({bench.pattern().pieces[0]->id});
    for (const char* name : {"name", "spacing"}) { // what is written there can be deleted as anywhere
        auto* field = bench.find<QWidget>(name);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Home);
        QTest::keyClick(field, Qt::Key_Delete);
        QVERIFY2(bench.pattern().pieces.size() == 2, name);
    }
    QCOMPARE(bench.find<QLineEdit>("name")->text(), QStringLiteral("ront"));
}

void tst_MainWindow::theHintFollowsWhatDeleteTakesBack() {
    Bench bench;
    bench.workbench.startFrom(twoRectangles(), {}, false);
    bench.look({0.15, 0}, 1000);
    bench.window.useTool(QStringLiteral("tool.sewSegments"));
    const QString hint = bench.find<QLabel>("toolHint")->text();
    bench.click({0.1, -0.1});
    QVERIFY(bench.find<QLabel>("toolHint")->text() != hint);
    bench.action("edit.delete")->trigger();
    QCOMPARE(bench.find<QLabel>("toolHint")->text(), hint);
}

void tst_MainWindow::whatIsHalfDrawnEndsWithItsDocument() {
    Bench bench;
    bench.window.useTool(QStringLiteral("tool.drawPiece"));
    const QString hint = bench.find<QLabel>("toolHint")->text();
    for (const Vec2 at : {Vec2{0.4, 0.2}, {0.6, 0.2}, {0.6, 0.4}}) bench.click(at);
    const Tool& tool = *bench.window.patternView().tool();
    QVERIFY(!tool.overlay(bench.workbench.desk()).lines.empty());
    bench.workbench.startFrom(twoRectangles(), {}, false);
    QVERIFY(tool.overlay(bench.workbench.desk()).lines.empty());
    QCOMPARE(bench.find<QLabel>("toolHint")->text(), hint);
}

void tst_MainWindow::theNextWindowHasTheSizesOfTheLastOne() {
    int height = 0;
    QList<int> heights;
    {
        Bench bench;
        bench.window.resize(860, 700); // the screen of the tests is 800 pixels high
        auto* panels = bench.find<QSplitter>("panels");
        panels->setSizes({200, 400});
        QVERIFY(bench.window.close());
        height = bench.window.height();
        heights = panels->sizes();
    }
    Workbench workbench(realParts({}));
    MainWindow next(workbench, {writeDrapeOf, {}, {}});
    next.show();
    QVERIFY(QTest::qWaitForWindowExposed(&next));
    QCOMPARE(next.height(), height);
    QCOMPARE(next.findChild<QSplitter*>(QStringLiteral("panels"))->sizes(), heights);
    QSettings().clear(); // the windows of other tests begin anew
}

void tst_MainWindow::theNextWindowShowsWhatTheLastOneDid() {
    {
        Bench bench;
        bench.action("look.grid")->trigger();
        bench.action("look3d.seams")->trigger();
        bench.action("simulation.accuracy")->trigger();
        QVERIFY(bench.window.close());
    }
    Bench next;
    QVERIFY(!next.window.patternView().look().grid && !next.action("look.grid")->isChecked());
    QVERIFY(!next.window.view3D().scene().options.seams && !next.action("look3d.seams")->isChecked());
    QVERIFY(next.window.patternView().look().seams);
    QVERIFY(next.find<QDockWidget>("accuracyDock")->isVisible());
    QVERIFY(next.action("simulation.accuracy")->isChecked());
    QSettings().clear();
}

void tst_MainWindow::theMethodIsChosenAtThePlayButtonAndKept() {
    {
        Bench bench;
        auto* shown = bench.find<QLabel>("statusMethod");
        QVERIFY(bench.action("method.xpbd")->isChecked());
        QVERIFY(!shown->isVisible());
        QMenu* menu = nullptr;
        for (auto* button : bench.window.findChildren<QToolButton*>())
            if (button->defaultAction() == bench.action("simulation.play")) menu = button->menu();
        QVERIFY(menu);
        for (const dynamics::Method method : dynamics::allMethods())
            QVERIFY2(menu->actions().contains(bench.action(qPrintable(methodId(method)))),
                     dynamics::nameOf(method).data());
        menu->popup(bench.window.mapToGlobal(QPoint(50, 50)));
        QVERIFY(QTest::qWaitForWindowExposed(menu));
        QTest::keyClick(menu, Qt::Key_A); // its mnemonic
        QVERIFY(bench.workbench.method() == dynamics::Method::trBdf2);
        QVERIFY(!bench.action("method.xpbd")->isChecked());
        QVERIFY(shown->isVisible());
        QCOMPARE(shown->text(), QStringLiteral("TR-BDF2"));
    }
    Bench next;
    QVERIFY(next.workbench.method() == dynamics::Method::trBdf2);
    QVERIFY(next.action("method.trbdf2")->isChecked());
    next.action("method.xpbd")->trigger();
    QVERIFY(next.workbench.method() == dynamics::Method::xpbd);
}

TOILE_TEST(tst_MainWindow, QApplication)
#include "tst_MainWindow.moc"
