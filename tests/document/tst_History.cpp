// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/History.h"
#include "tests/Suite.h"

#include "core/document/DocumentEdits.h"

#include <QTest>

using namespace toile;
using document::Document;
using document::History;

class tst_History : public QObject {
    Q_OBJECT
private slots:
    void undoGivesBackTheValueBefore();
    void aNewStepForgetsWhatWasUndone();
    void stepsOfADragAreOneStep();
    void theNextDragIsAStepOfItsOwn();
    void anEqualValueIsNoStep();
    void itIsModifiedUntilTheSavedValueIsBack();
    void whatLiesInNoFileIsModifiedAndHasNoPast();
    void onlySoManyStepsAreKept();
};

namespace {
Document withNumber(int n) {
    Document document;
    document.nextId = n;
    return document;
}
} // namespace

void tst_History::undoGivesBackTheValueBefore() {
    History history(withNumber(1));
    QVERIFY(!history.canUndo());
    history.push("Two", withNumber(2));
    history.push("Three", withNumber(3));
    QCOMPARE(history.undoName(), std::string("Three"));
    history.undo();
    QVERIFY(history.current() == withNumber(2));
    QCOMPARE(history.undoName(), std::string("Two"));
    QCOMPARE(history.redoName(), std::string("Three"));
    history.undo();
    QVERIFY(history.current() == withNumber(1));
    history.redo();
    history.redo();
    QVERIFY(history.current() == withNumber(3));
    QVERIFY(!history.canRedo());
}

void tst_History::aNewStepForgetsWhatWasUndone() {
    History history(withNumber(1));
    history.push("Two", withNumber(2));
    history.undo();
    history.push("Four", withNumber(4));
    QVERIFY(!history.canRedo());
    history.undo();
    QVERIFY(history.current() == withNumber(1));
}

void tst_History::stepsOfADragAreOneStep() {
    History history(withNumber(1));
    for (int n = 2; n < 10; ++n) history.push("Move point", withNumber(n), "move v1");
    QVERIFY(history.current() == withNumber(9));
    history.undo();
    QVERIFY(history.current() == withNumber(1));
}

void tst_History::theNextDragIsAStepOfItsOwn() {
    History history(withNumber(1));
    history.push("Move point", withNumber(2), "move v1");
    history.endMerge();
    history.push("Move point", withNumber(3), "move v1");
    history.push("Move point", withNumber(4), "move v2");
    history.undo();
    QVERIFY(history.current() == withNumber(3));
    history.undo();
    QVERIFY(history.current() == withNumber(2));
    history.push("Move point", withNumber(5), "move v1"); // after an undo nothing is merged into the past
    history.undo();
    QVERIFY(history.current() == withNumber(2));
}

void tst_History::anEqualValueIsNoStep() {
    History history(withNumber(1));
    history.push("Nothing", withNumber(1));
    QVERIFY(!history.canUndo());
}

void tst_History::itIsModifiedUntilTheSavedValueIsBack() {
    History history(withNumber(1));
    QVERIFY(!history.isModified());
    history.push("Two", withNumber(2));
    QVERIFY(history.isModified());
    history.markSaved();
    QVERIFY(!history.isModified());
    history.undo();
    QVERIFY(history.isModified());
    history.redo();
    QVERIFY(!history.isModified());
}

void tst_History::whatLiesInNoFileIsModifiedAndHasNoPast() {
    History history = History::unsaved(withNumber(1));
    QVERIFY(history.isModified());
    QVERIFY(!history.canUndo());
    history.push("Two", withNumber(2));
    history.undo();
    QVERIFY(history.current() == withNumber(1));
    QVERIFY(history.isModified()); // back at its beginning, which is in no file either
    history.markSaved();
    QVERIFY(!history.isModified());
}

void tst_History::onlySoManyStepsAreKept() {
    History history(withNumber(1), {.steps = 3});
    for (int n = 2; n < 10; ++n) history.push("More", withNumber(n));
    int undone = 0;
    for (; history.canUndo(); ++undone) history.undo();
    QCOMPARE(undone, 3);
    QVERIFY(history.current() == withNumber(6));
}

TOILE_TEST(tst_History)
#include "tst_History.moc"
