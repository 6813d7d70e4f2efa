// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_SkirtCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(skirtCases()); }
    void passes() { checkRow(skirtCases()); }
};

TOILE_TEST(tst_SkirtCases)
#include "tst_SkirtCases.moc"
