// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_ImpactCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(impactCases()); }
    void passes() { checkRow(impactCases()); }
};

TOILE_TEST(tst_ImpactCases)
#include "tst_ImpactCases.moc"
