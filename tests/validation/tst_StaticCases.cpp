// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_StaticCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(staticCases()); }
    void passes() { checkRow(staticCases()); }
};

TOILE_TEST(tst_StaticCases)
#include "tst_StaticCases.moc"
