// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_SewingCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(sewingCases()); }
    void passes() { checkRow(sewingCases()); }
};

TOILE_TEST(tst_SewingCases)
#include "tst_SewingCases.moc"
