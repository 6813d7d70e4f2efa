// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/values/Units.h"

#include <QTest>

#include <numbers>

using namespace toile::ui;

class tst_Units : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void lengthsAreShownInMillimetres() { QCOMPARE(textOf(Quantity::length, 0.0125), QStringLiteral("12.5 mm")); }
    void aFlatSeamIsShownAs180Degrees() { QCOMPARE(textOf(Quantity::foldAngle, 0), QStringLiteral("180°")); }
    void aRightAngledFoldIsShownAs90Degrees() {
        QCOMPARE(textOf(Quantity::foldAngle, std::numbers::pi / 2), QStringLiteral("90°"));
    }
    void noMinusBeforeZero() { QCOMPARE(textOf(Quantity::length, -1e-9), QStringLiteral("0.0 mm")); }
    void differencesCarryTheirSign() {
        QCOMPARE(differenceTextOf(Quantity::length, 0.002), QStringLiteral("+2.0 mm"));
        QCOMPARE(differenceTextOf(Quantity::length, -0.002), QStringLiteral("−2.0 mm"));
    }
    void whatIsShownReadsBackAsTheSameValue_data();
    void whatIsShownReadsBackAsTheSameValue();
};

void tst_Units::whatIsShownReadsBackAsTheSameValue_data() {
    QTest::addColumn<int>("quantity");
    for (int i = 0; i <= static_cast<int>(Quantity::count); ++i) QTest::addRow("quantity %d", i) << i;
}

void tst_Units::whatIsShownReadsBackAsTheSameValue() {
    QFETCH(int, quantity);
    const auto q = static_cast<Quantity>(quantity);
    QVERIFY(std::abs(fromShown(q, shown(q, 0.37)) - 0.37) < 1e-14); // rounding of a product and a sum
}

TOILE_TEST(tst_Units)
#include "tst_Units.moc"
