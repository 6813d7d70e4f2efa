// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QWheelEvent>

using namespace toile;
using namespace toile::ui;

/// What is selected, in fields: with wheel and keys.
class tst_PropertyEditor : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void theWheelScrollsTheSheetAndChangesNoValueUnderIt();
};

namespace {

/// The window with the sheet of the first of two rectangles.
struct Sheet {
    Bench bench;

    Sheet() {
        bench.workbench.startFrom(twoRectangles(), {}, false);
        bench.workbench.select({bench.pattern().pieces[0]->id});
        QApplication::setActiveWindow(&bench.window); // only there have fields the focus
    }
    QScrollArea& editor() { return *bench.find<QScrollArea>("propertyEditor"); }
    QScrollBar& scrollBar() { return *editor().verticalScrollBar(); }
    template <class Widget>
    Widget* find(const char* name) {
        return editor().widget()->findChild<Widget*>(QLatin1String(name));
    }
    template <class Widget>
    Widget& field(const char* name) {
        return *find<Widget>(name);
    }
    const pattern::Piece& piece() { return *bench.pattern().pieces[0]; }
};

/// One notch towards the user, as from the mouse: what the program makes itself, Qt does not hand on to parents.
void turnWheel(QWidget& under) {
    const QPointF at = under.rect().center();
    QWheelEvent event(at, under.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&under, &event);
}

} // namespace

void tst_PropertyEditor::theWheelScrollsTheSheetAndChangesNoValueUnderIt() {
    Sheet sheet;
    for (const char* name : {"seamAllowance", "rule"}) {
        auto& field = sheet.field<QWidget>(name);
        sheet.scrollBar().setValue(0);
        turnWheel(field);
        QVERIFY2(sheet.bench.workbench.document() == twoRectangles(), name);
        QVERIFY2(sheet.scrollBar().value() > 0, name);
    }
    auto& chosen = sheet.field<QWidget>("spacing");
    chosen.setFocus();
    turnWheel(chosen);
    QCOMPARE(sheet.piece().spacing, 0.019);
}

QTEST_MAIN(tst_PropertyEditor)
#include "tst_PropertyEditor.moc"
