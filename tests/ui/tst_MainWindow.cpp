// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"

#include <QDoubleSpinBox>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>

using namespace toile;
using namespace toile::ui;

class tst_MainWindow : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void propertiesChangeTheDocument();
    void undoIsOneKeyPerStep();
    void unsavedChangesAskBeforeTheyAreLost();
    void noShortcutIsUsedTwiceOrClosesTheWindow();
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
