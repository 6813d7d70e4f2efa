// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_DrapeCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(drapeCases()); }
    void passes() { checkRow(drapeCases()); }
};

TOILE_TEST(tst_DrapeCases)
#include "tst_DrapeCases.moc"
