// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_ContactCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(contactCases()); }
    void passes() { checkRow(contactCases()); }
};

TOILE_TEST(tst_ContactCases)
#include "tst_ContactCases.moc"
