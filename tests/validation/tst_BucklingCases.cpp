// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_BucklingCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(bucklingCases()); }
    void passes() { checkRow(bucklingCases()); }
};

TOILE_TEST(tst_BucklingCases)
#include "tst_BucklingCases.moc"
