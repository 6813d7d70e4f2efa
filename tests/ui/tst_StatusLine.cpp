// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "tests/Suite.h"
#include "ui/window/StatusLine.h"

#include <QLabel>

using namespace toile::ui;

namespace {

/// What it says, as if a message's time were over at once.
class SaidLine {
public:
    SaidLine() { line.findChild<QTimer*>()->setInterval(0); }
    [[nodiscard]] QString says() const { return line.findChild<QLabel*>("statusMessage")->text(); }
    [[nodiscard]] QString saysLater() const {
        QTest::qWait(10);
        return says();
    }

    StatusLine line;
};

const QString standingProblem = "The file cannot be written.", passingMessage = "Saved",
              keyHint = "There is nothing to undo.";

} // namespace

class tst_StatusLine : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void messagesGoAndProblemsStay();
    void aProblemIsSeenAgainAfterAHint();
    void aMessageEndsAProblem();
    void aProblemThatIsTakenBackUnderAHintDoesNotReturn();
};

void tst_StatusLine::messagesGoAndProblemsStay() {
    SaidLine line;
    line.line.tell(passingMessage, false);
    QCOMPARE(line.says(), passingMessage);
    QCOMPARE(line.saysLater(), QString());
    line.line.tell(standingProblem, true);
    QCOMPARE(line.saysLater(), standingProblem);
}

void tst_StatusLine::aProblemIsSeenAgainAfterAHint() {
    SaidLine line;
    line.line.tell(standingProblem, true);
    line.line.hint(keyHint);
    line.line.hint(keyHint); // tried again
    QCOMPARE(line.says(), keyHint);
    QCOMPARE(line.saysLater(), standingProblem);
    QCOMPARE(line.saysLater(), standingProblem);
}

void tst_StatusLine::aMessageEndsAProblem() {
    SaidLine line;
    line.line.tell(standingProblem, true);
    line.line.tell(passingMessage, false);
    line.line.hint(keyHint);
    QCOMPARE(line.says(), keyHint);
    QCOMPARE(line.saysLater(), QString());
}

void tst_StatusLine::aProblemThatIsTakenBackUnderAHintDoesNotReturn() {
    SaidLine line;
    line.line.tell(standingProblem, true);
    line.line.hint(keyHint);
    line.line.tell({}, false);
    QCOMPARE(line.says(), QString());
    QCOMPARE(line.saysLater(), QString());
}

TOILE_TEST(tst_StatusLine, QApplication)
#include "tst_StatusLine.moc"
