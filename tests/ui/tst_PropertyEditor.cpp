// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "tests/Suite.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
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
    void aMeshThatArrivesLeavesWhatIsBeingTyped();
    void spacePressesTheFieldThatHasTheFocus();
    void theSheetStaysWhereItWasScrolledTo();
    void anAvatarIsNamedByItsFile();
    void substepsThatAreLeftToTheClothAreCalledAutomatic();
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
    void press(QWidget& widget, Qt::Key key) {
        widget.setFocus();
        QTest::keyClick(&widget, key);
    }
};

/// One notch towards the user, as from the mouse: what the program makes itself, Qt does not hand on to parents.
void turnWheel(QWidget& under) {
    const QPointF at = under.rect().center();
    QWheelEvent event(at, under.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&under, &event);
}

/// Instead of what stands there, without leaving the field.
void type(QWidget& field, const QString& text) {
    field.setFocus();
    QTest::keySequence(&field, QKeySequence::SelectAll);
    QTest::keyClicks(&field, text);
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

void tst_PropertyEditor::aMeshThatArrivesLeavesWhatIsBeingTyped() {
    Sheet sheet;
    type(sheet.field<QWidget>("seamAllowance"), "25"); // the first mesh is still on its way
    QTRY_VERIFY(!sheet.bench.workbench.mesh().empty());
    QTRY_VERIFY(sheet.field<QLabel>("meshNodes").text().toInt() > 0); // it is shown all the same
    QVERIFY(sheet.field<QDoubleSpinBox>("seamAllowance").text().contains(QStringLiteral("25")));
    type(sheet.field<QWidget>("name"), "Sleeve");
    Q_EMIT sheet.bench.workbench.meshChanged();
    QCOMPARE(sheet.field<QLineEdit>("name").text(), QStringLiteral("Sleeve"));
    QCOMPARE(sheet.piece().seamAllowance, 0.025);
}

void tst_PropertyEditor::spacePressesTheFieldThatHasTheFocus() {
    Sheet sheet;
    sheet.press(sheet.field<QWidget>("curled"), Qt::Key_Space);
    QVERIFY(sheet.piece().placement && sheet.piece().placement->curl);
    sheet.press(sheet.field<QWidget>("duplicate"), Qt::Key_Space);
    QCOMPARE(sheet.bench.pattern().pieces.size(), std::size_t(3));
    auto& rule = sheet.field<QComboBox>("rule");
    sheet.press(rule, Qt::Key_Space);
    QVERIFY(rule.view()->isVisible());
    rule.hidePopup();
    QTRY_VERIFY(!rule.view()->isVisible());
    QVERIFY(QTest::qWaitForWindowActive(&sheet.bench.window));
    QVERIFY(!sheet.bench.workbench.isPlaying());
    sheet.press(sheet.bench.window.patternView(), Qt::Key_Space); // elsewhere it simulates
    QVERIFY(sheet.bench.workbench.isPlaying());
}

void tst_PropertyEditor::theSheetStaysWhereItWasScrolledTo() {
    Sheet sheet;
    auto& curled = sheet.field<QCheckBox>("curled");
    sheet.editor().ensureWidgetVisible(&curled);
    const int before = sheet.scrollBar().value();
    QVERIFY(before > 0);
    curled.setFocus();
    curled.click(); // the sheet has a row more
    QVERIFY(sheet.find<QWidget>("curlRadius"));
    QVERIFY(sheet.field<QWidget>("curled").hasFocus());
    QCOMPARE(sheet.scrollBar().value(), before);
    QCoreApplication::sendPostedEvents();
    QCOMPARE(sheet.scrollBar().value(), before);
    sheet.bench.workbench.select({SceneItem{}}); // of another thing it begins anew
    QCOMPARE(sheet.scrollBar().value(), 0);
}

void tst_PropertyEditor::anAvatarIsNamedByItsFile() {
    Sheet sheet;
    document::Document document = sheet.bench.workbench.document();
    document.avatarFile = "/somewhere/far/away/body.glb";
    sheet.bench.workbench.startFrom(document, {}, false);
    sheet.bench.workbench.select({SceneItem{}});
    const QLabel& avatar = sheet.field<QLabel>("avatar");
    QCOMPARE(avatar.text(), QStringLiteral("body.glb"));
    QCOMPARE(avatar.toolTip(), QStringLiteral("/somewhere/far/away/body.glb"));
}

void tst_PropertyEditor::substepsThatAreLeftToTheClothAreCalledAutomatic() {
    Sheet sheet;
    sheet.bench.workbench.select({});
    auto& substeps = sheet.field<QDoubleSpinBox>("substeps");
    QCOMPARE(substeps.text(), QStringLiteral("automatic"));
    type(substeps, "24");
    sheet.press(substeps, Qt::Key_Return);
    QCOMPARE(sheet.bench.workbench.document().scene.substeps, 24);
    QCOMPARE(sheet.field<QDoubleSpinBox>("substeps").text(), QStringLiteral("24"));
    type(sheet.field<QDoubleSpinBox>("substeps"), "0");
    sheet.press(sheet.field<QDoubleSpinBox>("substeps"), Qt::Key_Return);
    QCOMPARE(sheet.bench.workbench.document().scene.substeps, 0);
    QCOMPARE(sheet.field<QDoubleSpinBox>("substeps").text(), QStringLiteral("automatic"));
}

TOILE_TEST(tst_PropertyEditor, QApplication)
#include "tst_PropertyEditor.moc"
