// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "core/io/ToileFile.h"
#include "core/pattern/PatternPlacement.h"
#include "ui/panels/ObjectList.h"
#include "ui/window/MainWindow.h"
#include "ui/window/Theme.h"
#include "ui/workbench/RealParts.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace toile;
using namespace toile::ui;

namespace {

/// A window as the program makes it, and a hand on its pattern.
struct Bench {
    Workbench workbench{realParts({})};
    MainWindow window{workbench, {writeDrapeOf, {QStringLiteral("/nowhere")}, {}}};

    Bench() {
        window.resize(1400, 860);
        window.show();
        (void)QTest::qWaitForWindowExposed(&window);
        QApplication::setActiveWindow(&window); // without a window manager nobody else does, and only it gets shortcuts
        PatternView& view = window.patternView();
        view.setView({{0.5, 0.3}, 500, view.size()});
    }
    QPoint pixel(Vec2 at) { return window.patternView().view().toScreen(at).toPoint(); }
    void tool(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&window, key, modifiers); }
    void click(Vec2 at) {
        QTest::mouseMove(&window.patternView(), pixel(at));
        QTest::mouseClick(&window.patternView(), Qt::LeftButton, {}, pixel(at));
    }
    void drag(Vec2 from, Vec2 to, const std::function<void()>& beforeTheEnd = {}) {
        PatternView* view = &window.patternView();
        QTest::mouseMove(view, pixel(from));
        QTest::mousePress(view, Qt::LeftButton, {}, pixel(from));
        for (int i = 1; i <= 8; ++i) { // QTest::mouseMove does not say that the button is held
            const QPoint at = pixel(lerp(from, to, i / 8.0));
            QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(view, &event);
        }
        if (beforeTheEnd) beforeTheEnd();
        QTest::mouseRelease(view, Qt::LeftButton, {}, pixel(to));
    }
    /// Keeps a picture of the window where TOILE_PICTURES names a folder: to be looked at.
    void picture(const char* name) {
        const QString folder = qEnvironmentVariable("TOILE_PICTURES");
        if (folder.isEmpty()) return;
        QTest::qWait(300);
        QVERIFY(window.grab().save(folder + QLatin1Char('/') + QLatin1String(name)));
    }
    const pattern::Pattern& pattern() { return workbench.document().pattern; }
    template <class Widget>
    Widget* find(const char* name) { return window.findChild<Widget*>(QLatin1String(name)); }
};

} // namespace

class tst_MainWindow : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QApplication::setOrganizationName(QStringLiteral("toile-tests"));
        applyTheme(*qApp);
    }
    void aSkirtIsDrawnPaintedSewnSavedAndReloaded();
    void propertiesChangeTheDocument();
    void undoIsOneKeyPerStep();
    void unsavedChangesAskBeforeTheyAreLost();
    void noShortcutIsUsedTwiceOrClosesTheWindow();
};

void tst_MainWindow::aSkirtIsDrawnPaintedSewnSavedAndReloaded() {
    Bench bench;
    bench.tool(Qt::Key_D, Qt::ShiftModifier);
    for (const double left : {0.0, 0.7}) { // front and back: a trapezium each
        for (const Vec2 at : {Vec2{left, 0}, {left + 0.5, 0}, {left + 0.45, 0.55}, {left + 0.05, 0.55}}) bench.click(at);
        QTest::keyClick(&bench.window.patternView(), Qt::Key_Return);
    }
    QCOMPARE(bench.pattern().pieces.size(), std::size_t(2));

    bench.tool(Qt::Key_B, Qt::ShiftModifier);
    bench.drag({0.15, 0.2}, {0.35, 0.2}, [&] { bench.picture("painting-a-region.png"); });
    QCOMPARE(bench.pattern().pieces[0]->regions.size(), std::size_t(1));

    bench.tool(Qt::Key_N);
    bench.click({0.49, 0.11}); // right side of the front, near the hem
    QTest::mouseMove(&bench.window.patternView(), bench.pixel({0.71, 0.11}));
    bench.picture("setting-a-seam.png");
    bench.click({0.71, 0.11}); // left side of the back
    bench.click({0.01, 0.11});
    bench.click({1.19, 0.11});
    QCOMPARE(bench.pattern().seams.size(), std::size_t(2));

    QTRY_COMPARE(bench.workbench.mesh().size(), std::size_t(2)); // meshed on its own thread
    QVERIFY(!bench.workbench.mesh()[0].lines.empty());
    QVERIFY(bench.workbench.mesh()[0].lines.size() > bench.workbench.mesh()[1].lines.size()); // the region is finer

    for (int i = 0; i < 2; ++i) { // one in front of nothing, one behind
        bench.workbench.select({bench.pattern().pieces[i]->id});
        bench.find<QDoubleSpinBox>("placement2")->setValue(i == 0 ? 150 : -150);
        if (i == 1) bench.find<QDoubleSpinBox>("placementTurn")->setValue(180);
    }
    bench.workbench.select({SceneItem{}});
    bench.find<QDoubleSpinBox>("gravity")->setValue(0); // nothing would hold the skirt
    QTest::keyClick(&bench.window, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.workbench.frame() && bench.workbench.frame()->time > 0.1 &&
                                 bench.workbench.frame()->largestSeamGap < 0.1, // they began 300 mm apart
                             60000);
    bench.picture("sewing.png");
    QTest::keyClick(&bench.window, Qt::Key_Space);
    QVERIFY(!bench.workbench.isPlaying());

    QTemporaryDir folder;
    QVERIFY(bench.workbench.saveAs(folder.filePath(QStringLiteral("skirt.toile"))));
    const document::Document drawn = *io::asWritten(bench.workbench.document());
    bench.workbench.startNew();
    QVERIFY(bench.window.files().openFile(folder.filePath(QStringLiteral("skirt.toile"))));
    QVERIFY(bench.workbench.document() == drawn);
}

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
    bench.tool(Qt::Key_Z);
    bench.drag({0.1, 0.15}, {0.12, 0.17});
    QVERIFY(!(bench.workbench.document() == twoRectangles()));
    QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.workbench.document() == twoRectangles());
    QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!(bench.workbench.document() == twoRectangles()));
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

QTEST_MAIN(tst_MainWindow)
#include "tst_MainWindow.moc"
