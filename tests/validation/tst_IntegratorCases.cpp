// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_IntegratorCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(integratorCases()); }
    void passes() { checkRow(integratorCases()); }
};

TOILE_TEST(tst_IntegratorCases)
#include "tst_IntegratorCases.moc"
