// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

class tst_ElasticityCases : public QObject {
    Q_OBJECT
private slots:
    void passes_data() { addRowsFor(elasticityCases()); }
    void passes() { checkRow(elasticityCases()); }
};

TOILE_TEST(tst_ElasticityCases)
#include "tst_ElasticityCases.moc"
