// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/DocumentEdits.h"
#include "tests/Suite.h"

#include "core/pattern/PatternPieces.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>

using namespace toile;
using namespace toile::document;

class tst_DocumentEdits : public QObject {
    Q_OBJECT
private slots:
    void anEditTakesItsIdsFromTheDocument();
    void anEditThatFailsChangesNothing();
    void idsAreNotReusedAfterADeletion();
    void theSceneIsMadeOfPatternBodyAndSettings();
    void aSceneThatCannotRunIsRefused();
};

namespace {

Document sample() {
    Document document;
    document.pattern = tests::twoPanels();
    document.nextId = 30;
    return document;
}

Result<Document> withImage(const Document& document) {
    return edited(document, [](const Pattern& pattern, IdSource& ids) {
        return pattern::addMirrorPiece(pattern, pattern::PieceId("back"), {0, 0}, {0, 1}, "new", ids);
    });
}

} // namespace

void tst_DocumentEdits::anEditTakesItsIdsFromTheDocument() {
    const Document next = *withImage(sample());
    QCOMPARE(next.pattern.pieces.back()->id, pattern::PieceId("p30"));
    QCOMPARE(next.nextId, 31);
}

void tst_DocumentEdits::anEditThatFailsChangesNothing() {
    const Document before = sample();
    const auto failed = edited(before, [](const Pattern& pattern, IdSource& ids) -> Result<Pattern> {
        return pattern::addMirrorPiece(pattern, pattern::PieceId("nobody"), {0, 0}, {0, 1}, "new", ids);
    });
    QVERIFY(!failed);
    QVERIFY(before == sample());
}

void tst_DocumentEdits::idsAreNotReusedAfterADeletion() {
    const Document once = *withImage(sample());
    const Document without = *edited(once, [](const Pattern& pattern, IdSource&) -> Result<Pattern> {
        return pattern::deletePiece(pattern, pattern::PieceId("p30")).map([](const pattern::Edited& e) {
            return e.pattern;
        });
    });
    QCOMPARE(withImage(without)->pattern.pieces.back()->id, pattern::PieceId("p31"));
}

void tst_DocumentEdits::theSceneIsMadeOfPatternBodyAndSettings() {
    Document document = *withScene(sample(), {.damping = 2});
    const auto scene = sceneOf(document, Shared<body::Body>(body::Body{.name = "woman"}));
    QVERIFY(scene.pattern == document.pattern);
    QCOMPARE(scene.settings.damping, 2.0);
    QCOMPARE((*scene.body)->name, std::string("woman"));
    QVERIFY(!sceneOf(document, std::nullopt).body);
    QCOMPARE(withAvatar(document, "a.glb").avatarFile, std::string("a.glb"));
}

void tst_DocumentEdits::aSceneThatCannotRunIsRefused() {
    QVERIFY(!withScene(sample(), {.frameStep = 0}));
    QVERIFY(!withScene(sample(), {.damping = -1}));
    QVERIFY(!withScene(sample(), {.gravity = {0, std::nan(""), 0}}));
    QVERIFY(withScene(sample(), {.air = simulation::Air{.wind = {3, 0, 0}}}));
    QCOMPARE(withScene(sample(), {.air = simulation::Air{.wind = {300, 0, 0}}}).error().place.path,
             std::string("scene.air.wind"));
    QCOMPARE(withScene(sample(), {.air = simulation::Air{.drag = -1}}).error().place.path,
             std::string("scene.air.drag"));
    QCOMPARE(withScene(sample(), {.seamTime = -1}).error().place.path, std::string("scene.seamTime"));
}

TOILE_TEST(tst_DocumentEdits)
#include "tst_DocumentEdits.moc"
