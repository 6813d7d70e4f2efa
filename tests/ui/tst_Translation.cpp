// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternFabrics.h"
#include "core/pattern/PatternFolds.h"
#include "core/pattern/PatternRegions.h"
#include "core/pattern/PatternSeams.h"
#include "core/pattern/PatternTacks.h"
#include "tests/Suite.h"
#include "ui/panels/ObjectList.h"
#include "ui/panels/PropertySheet.h"
#include "ui/window/Translation.h"

#include <QMenuBar>
#include <QRegularExpression>

using namespace toile;
using namespace toile::ui;

/// The window in Chinese.
class tst_Translation : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void thereIsATableForSimplifiedChinese();
    void placeholdersAreKept();
    void everyCommandIsTranslated();
    void everyHintIsTranslated();
    void everyPropertyIsTranslated();

private:
    void install() {
        translation_ = Translation::of(QLocale(QLocale::Chinese, QLocale::China));
        QCoreApplication::installTranslator(translation_.get());
    }
    std::unique_ptr<Translation> translation_;
};

namespace {

bool isChinese(const QString& text) {
    return std::ranges::any_of(text, [](QChar c) { return c.unicode() >= 0x2E80; });
}

/// Things of all kinds: a piece with a region and notch, its edge, vertex, and a seam.
document::Document garmentOfAllKinds() {
    return *document::edited(twoRectangles(), [](const pattern::Pattern& p, pattern::IdSource& ids) {
        const pattern::Piece &front = *p.pieces[0], &back = *p.pieces[1];
        return addRegion(p, front.id, {{-0.05, -0.05}, {0.05, -0.05}, {0, 0.05}}, "1", 1, ids)
            .and_then([&](const pattern::Pattern& next) {
                return addSeam(next, {front.id, front.outline.edges[1].id}, {back.id, back.outline.edges[3].id}, ids);
            })
            .and_then([&](const pattern::Pattern& next) {
                return addNotch(next, front.id, {front.outline.edges[1].id, 0.5});
            })
            .and_then([&](const pattern::Pattern& next) {
                return addTack(next, {{{front.id, {0, 0}}, {back.id, {0, 0}}}}, "1", ids);
            })
            .and_then([&](const pattern::Pattern& next) {
                return addFold(next, front.id, {{{front.outline.edges[1].id, 0.5}, {front.outline.edges[3].id, 0.5}}},
                               {}, 1, "1", ids);
            })
            .and_then([&](const pattern::Pattern& next) { return setButtonDiameter(next, next.tacks[0].id, 0.011); })
            .and_then(
                [&](const pattern::Pattern& next) { return setInterfacing(next, front.id, pattern::Interfacing{}); });
    });
}

} // namespace

void tst_Translation::thereIsATableForSimplifiedChinese() {
    QVERIFY(Translation::of(QLocale(QLocale::Chinese, QLocale::China)));
    QVERIFY(!Translation::of(QLocale(QLocale::English, QLocale::UnitedKingdom)));
    install();
    QCOMPARE(QCoreApplication::translate("anywhere", "Dart"), QStringLiteral("省"));
    QCOMPARE(QCoreApplication::translate("anywhere", "not in the table"), QStringLiteral("not in the table"));
}

void tst_Translation::placeholdersAreKept() {
    const QRegularExpression placeholder(QStringLiteral("%\\d|\\[\\*\\]|\\*\\.\\w+"));
    const auto all = [&](const QString& text) {
        QStringList found;
        for (auto match = placeholder.globalMatch(text); match.hasNext();) found << match.next().captured();
        found.sort();
        return found;
    };
    install();
    for (auto pair = translation_->table().begin(); pair != translation_->table().end(); ++pair)
        QVERIFY2(all(pair.key()) == all(pair.value()), qPrintable(pair.key()));
}

void tst_Translation::everyCommandIsTranslated() {
    install();
    Bench bench;
    for (const QAction* action : bench.window.actions().all()) {
        QVERIFY2(isChinese(action->text()), qPrintable(action->objectName()));
        QVERIFY2(isChinese(action->toolTip()), qPrintable(action->objectName()));
        QVERIFY2(isChinese(action->iconText()), qPrintable(action->objectName()));
    }
    for (const QAction* menu : bench.window.menuBar()->actions())
        QVERIFY2(isChinese(menu->text()), qPrintable(menu->text()));
    bench.workbench.startFrom(garmentOfAllKinds(), {}, false);
    bench.picture("chinese.png");
}

void tst_Translation::everyHintIsTranslated() {
    install();
    const ToolBox tools;
    for (const ToolBox::Entry& entry : tools.entries()) QVERIFY2(isChinese(entry.tool->hint()), qPrintable(entry.id));
}

void tst_Translation::everyPropertyIsTranslated() {
    install();
    document::Document document = garmentOfAllKinds();
    material::Fabric fabric;
    fabric.id = material::FabricId("cloth");
    document.pattern.fabrics.push_back(Shared<material::Fabric>(fabric));
    const FlatPattern flat = flattened(document.pattern);
    const pattern::Piece& front = *document.pattern.pieces[0];
    for (const Item& item : Selection{
             front.id, EdgeRef{front.id, front.outline.edges[1].id}, VertexRef{front.id, front.outline.vertices[0].id},
             RegionRef{front.id, front.regions[0].id}, FoldRef{front.id, front.folds[0].id},
             document.pattern.seams[0].id, document.pattern.tacks[0].id, fabric.id, SceneItem{}}) {
        const PropertySheet sheet = sheetOf({document, flat, {item}}, {});
        QVERIFY2(isChinese(sheet.title), qPrintable(sheet.title));
        for (const PropertyRow& row : sheet.rows) {
            QVERIFY2(row.label.isEmpty() || isChinese(row.label), qPrintable(row.label));
            QVERIFY2(row.tip.isEmpty() || isChinese(row.tip), qPrintable(row.tip));
            if (const auto* choice = std::get_if<ChoiceRow>(&row.content);
                choice && row.name != QLatin1String("fabric"))
                for (const QString& text : choice->choices) QVERIFY2(isChinese(text), qPrintable(text));
        }
    }
    for (const ObjectGroup& group : objectsOf(document)) QVERIFY2(isChinese(group.title), qPrintable(group.title));
}

TOILE_TEST(tst_Translation, QApplication)
#include "tst_Translation.moc"
