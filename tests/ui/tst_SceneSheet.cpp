// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/panels/PropertySheet.h"

#include <QTest>
#include <cmath>

using namespace toile;
using namespace toile::ui;

namespace {

const PropertyRow* rowNamed(const PropertySheet& sheet, const QString& name) {
    const auto found = std::ranges::find(sheet.rows, name, &PropertyRow::name);
    return found == sheet.rows.end() ? nullptr : &*found;
}

/// What is shown of a setting, to be compared.
QString shown(const PropertyRow& row) {
    if (const auto* number = std::get_if<NumberRow>(&row.content)) return QString::number(number->value, 'g', 15);
    if (const auto* flag = std::get_if<FlagRow>(&row.content)) return flag->on ? "on" : "off";
    return {};
}

/// With every row that there can be.
document::Document windy() {
    document::Document document;
    document.scene.air = simulation::Air{.wind = {1, 2, 3}, .drag = 0.8};
    return document;
}

} // namespace

class tst_SceneSheet : public QObject {
    Q_OBJECT
private slots:
    void everyNumberIsTakenAsItIsTyped_data();
    void everyNumberIsTakenAsItIsTyped();
    void everyFlagIsTurned();
    void substepsAreWholeAndNoneLeavesThemToTheCloth();
};

void tst_SceneSheet::everyNumberIsTakenAsItIsTyped_data() {
    QTest::addColumn<QString>("name");
    for (const PropertyRow& row : sceneSheet(windy()).rows)
        if (std::holds_alternative<NumberRow>(row.content)) QTest::newRow(qPrintable(row.name)) << row.name;
}

void tst_SceneSheet::everyNumberIsTakenAsItIsTyped() {
    QFETCH(QString, name);
    const document::Document before = windy();
    const PropertySheet sheet = sceneSheet(before);
    const auto& number = std::get<NumberRow>(rowNamed(sheet, name)->content);
    QVERIFY(number.low <= number.value && number.value <= number.high);
    const double between = 0.25 * number.low + 0.75 * number.high;
    const double wanted = number.quantity == Quantity::count ? std::round(between) : between;
    const DocumentResult after = number.set(before, wanted);
    QVERIFY2(after, after ? "" : toString(after.error()).c_str());
    for (const PropertyRow& row : sceneSheet(*after).rows) {
        if (row.name == name) QCOMPARE(std::get<NumberRow>(row.content).value, wanted);
        else QCOMPARE(shown(row), shown(*rowNamed(sheet, row.name)));
    }
    QVERIFY(!(after->scene == before.scene));
}

void tst_SceneSheet::everyFlagIsTurned() {
    document::Document document;
    for (const char* name : {"air", "selfContact"}) {
        const PropertySheet sheet = sceneSheet(document);
        const auto& flag = std::get<FlagRow>(rowNamed(sheet, name)->content);
        document = *flag.set(document, !flag.on);
        const PropertySheet after = sceneSheet(document);
        QCOMPARE(std::get<FlagRow>(rowNamed(after, name)->content).on, !flag.on);
    }
    QVERIFY(document.scene.air && document.scene.selfContact != document::Document{}.scene.selfContact);
    const PropertySheet windySheet = sceneSheet(document);
    QVERIFY(rowNamed(windySheet, "drag"));
}

void tst_SceneSheet::substepsAreWholeAndNoneLeavesThemToTheCloth() {
    const document::Document document;
    const PropertySheet sheet = sceneSheet(document);
    const auto& row = std::get<NumberRow>(rowNamed(sheet, "substeps")->content);
    QCOMPARE(row.value, 0.0);
    QCOMPARE(row.set(document, 24)->scene.substeps, 24);
}

TOILE_TEST(tst_SceneSheet)
#include "tst_SceneSheet.moc"
