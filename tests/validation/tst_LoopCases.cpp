// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_LoopCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(loopCases()); }
    void passes() { checkRow(loopCases()); }
};

TOILE_TEST(tst_LoopCases)
#include "tst_LoopCases.moc"
