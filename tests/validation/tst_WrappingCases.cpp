// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_WrappingCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(wrappingCases()); }
    void passes() { checkRow(wrappingCases()); }
};

TOILE_TEST(tst_WrappingCases)
#include "tst_WrappingCases.moc"
