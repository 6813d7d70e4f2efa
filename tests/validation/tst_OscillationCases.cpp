// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_OscillationCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(oscillationCases()); }
    void passes() { checkRow(oscillationCases()); }
};

TOILE_TEST(tst_OscillationCases)
#include "tst_OscillationCases.moc"
