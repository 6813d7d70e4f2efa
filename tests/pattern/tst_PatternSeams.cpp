// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternSeams.h"
#include "tests/Suite.h"

#include "core/pattern/PatternMeasures.h"
#include "tests/pattern/ErrorsOf.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>

using namespace toile;
using namespace toile::pattern;
using tests::back;
using tests::front;
using tests::image;

class tst_PatternSeams : public QObject {
    Q_OBJECT
private slots:
    void rightSideMeetsRightSide();
    void aMirrorImageIsWalkedAgainstItsSource();
    void inSpaceTheNearerEndsMeet();
    void aDartClosesFromItsMouthToItsTip();
    void aChainIsWalkedBackwardsAsAWhole();
    void walkedChainsAreSewnAsTheyAre();
    void aStretchWalkedBackwardsIsFound();
    void aSewnStretchIsRefused();
    void anEdgeIsNotSewnToItself();
    void reversingTwiceChangesNothing();
    void easeBelongsToASectionBetweenNotches();
    void easeAwayLeavesNoMismatch();
    void aGatherRatioCountsAsEase();
    void gatherAwayTakesTheDifferenceAsGathers();
    void anElasticIsShorterThanItsSeam();
    void aSeamIsRemoved();
};

namespace {

Pattern unplaced() {
    Pattern pattern = tests::unsewnPanels();
    for (auto& shared : pattern.pieces) {
        Piece piece = *shared;
        piece.placement.reset();
        shared = std::move(piece);
    }
    return pattern;
}

std::array<std::vector<Vec2>, 2> sidePoints(const Pattern& pattern, const Seam& seam) {
    std::array<std::vector<Vec2>, 2> points;
    for (std::size_t side = 0; side < 2; ++side)
        for (const SeamPart& part : seam.sides[side])
            for (const Vec2 p : partPoints(pattern, part, 1e-4)) points[side].push_back(p);
    return points;
}

} // namespace

void tst_PatternSeams::rightSideMeetsRightSide() {
    IdSource ids{50};
    const Pattern pattern = *addSeam(unplaced(), {front, EdgeId("right")}, {back, EdgeId("left")}, ids);
    const auto points = sidePoints(pattern, pattern.seams[0]);
    // Both sides run from the hem upwards.
    QCOMPARE(points[0].front(), (Vec2{0.3, 0}));
    QCOMPARE(points[1].front(), (Vec2{0, 0}));
    QCOMPARE(pattern.seams[0].id, SeamId("s50"));
    QCOMPARE(ids.next, 51);
}

void tst_PatternSeams::aMirrorImageIsWalkedAgainstItsSource() {
    // Front and its image meet at the centre front (left edge, x = 0): both must run the same way up or down.
    IdSource ids{50};
    const Pattern pattern = *addSeam(unplaced(), {front, EdgeId("left")}, {image, EdgeId("left")}, ids);
    const auto points = sidePoints(pattern, pattern.seams[0]);
    QCOMPARE(points[0].front(), points[1].front());
    QCOMPARE(points[0].back(), points[1].back());
}

void tst_PatternSeams::inSpaceTheNearerEndsMeet() {
    // The back stands on its head: its left edge, still at the front's right one, now runs upwards.
    Pattern pattern = tests::unsewnPanels();
    Piece turned = *pattern.pieces[1];
    turned.placement = Placement{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0.15, 1.0, -0.2}}, {}};
    pattern.pieces[1] = turned;
    IdSource ids{50};
    const Pattern sewn = *addSeam(pattern, {front, EdgeId("right")}, {back, EdgeId("left")}, ids);
    const auto points = sidePoints(sewn, sewn.seams[0]);
    QCOMPARE(placed(*sewn.pieces[0]->placement, points[0].front()).y,
             placed(*sewn.pieces[1]->placement, points[1].front()).y);
    QVERIFY(!isTwisted(sewn, sewn.seams[0]));
    QVERIFY(isTwisted(*reverseSeam(sewn, sewn.seams[0].id), reverseSeam(sewn, sewn.seams[0].id)->seams[0]));
}

void tst_PatternSeams::aDartClosesFromItsMouthToItsTip() {
    Pattern pattern = tests::unsewnPanels();
    Piece piece = *pattern.pieces[1];
    auto& v = piece.outline.vertices;
    auto& e = piece.outline.edges;
    v.insert(v.begin() + 1, {{VertexId("a"), {0.14, 0}}, {VertexId("tip"), {0.15, 0.1}}, {VertexId("b"), {0.16, 0}}});
    e.insert(e.begin() + 1, {{EdgeId("legA"), {}, {}}, {EdgeId("legB"), {}, {}}, {EdgeId("rest"), {}, {}}});
    pattern.pieces[1] = piece;
    IdSource ids{50};
    const Pattern sewn = *addSeam(pattern, {back, EdgeId("legA")}, {back, EdgeId("legB")}, ids);
    const auto points = sidePoints(sewn, sewn.seams[0]);
    QCOMPARE(points[0].back(), (Vec2{0.15, 0.1}));
    QCOMPARE(points[1].back(), (Vec2{0.15, 0.1}));
    QCOMPARE(points[1].front(), (Vec2{0.16, 0}));
}

void tst_PatternSeams::aChainIsWalkedBackwardsAsAWhole() {
    IdSource ids{50};
    const std::vector<EdgePick> a{{front, EdgeId("bottom")}, {front, EdgeId("right")}},
        b{{back, EdgeId("bottom")}, {back, EdgeId("right")}};
    const Pattern sewn = *addSeam(unplaced(), a, b, "chain", ids);
    QCOMPARE(sewn.seams[0].sides[1][0].edge, EdgeId("right"));
    QVERIFY(sewn.seams[0].sides[1][0].reversed && sewn.seams[0].sides[1][1].reversed);
    QCOMPARE(sewn.seams[0].name, std::string("chain"));
}

void tst_PatternSeams::walkedChainsAreSewnAsTheyAre() {
    IdSource ids{50};
    const Pattern pattern = tests::unsewnPanels();
    const auto edge = [&](std::size_t piece, std::size_t i) { return pattern.pieces[piece]->outline.edges[i].id; };
    const std::array<std::vector<SeamPart>, 2> sides{
        {{{front, edge(0, 1), 0, 1, true}, {front, edge(0, 0), 0, 1, true}}, {{back, edge(1, 3), 0, 1, false}}}};
    const auto sewn = addSeam(pattern, sides, "", ids);
    QVERIFY(sewn);
    QVERIFY(sewn->seams.back().sides == sides);
    QVERIFY(!sewn->seams.back().name.empty());
    QVERIFY(!addSeam(*sewn, sides, "", ids)); // sewn already
    QVERIFY(!addSeam(pattern, std::array<std::vector<SeamPart>, 2>{sides[0], sides[0]}, "", ids));
    QVERIFY(!addSeam(pattern, std::array<std::vector<SeamPart>, 2>{}, "", ids));
}

void tst_PatternSeams::aStretchWalkedBackwardsIsFound() {
    IdSource ids{50};
    const std::vector<EdgePick> a{{front, EdgeId("bottom")}, {front, EdgeId("right")}},
        b{{back, EdgeId("bottom")}, {back, EdgeId("right")}};
    Pattern pattern = *addSeam(unplaced(), a, b, "chain", ids);
    const auto complaints = [&] {
        std::vector<std::string> of;
        for (const std::string& text : tests::errorsOf(pattern))
            if (text.find("wrong direction") != std::string::npos) of.push_back(text);
        return of;
    };
    QVERIFY(complaints().empty());
    auto& sides = pattern.seams[0].sides; // A goes on from bottom to right, B from right to bottom
    for (const auto& [side, part, other] : {std::tuple{0, 0, 1}, {0, 1, 0}, {1, 0, 1}, {1, 1, 0}}) {
        bool& reversed = sides[side][part].reversed;
        reversed = !reversed;
        QCOMPARE(complaints().size(), std::size_t(1));
        QVERIFY(complaints()[0].find(part == 0 ? "[0].reversed" : "[1].reversed") != std::string::npos);
        reversed = !reversed;
    }
    std::swap(sides[0][0], sides[0][1]); // both ends of one touch: nothing follows as it is walked
    QCOMPARE(complaints().size(), std::size_t(1));
    sides[0][0] = {back, EdgeId("top"), 0, 1, false}; // of another piece: a jump is no turn
    QVERIFY(complaints().empty());
}

void tst_PatternSeams::aSewnStretchIsRefused() {
    IdSource ids{50};
    const auto twice = addSeam(tests::twoPanels(), {front, EdgeId("right"), 0.9, 1}, {back, EdgeId("top")}, ids);
    QVERIFY(!twice);
    QVERIFY(twice.error().text.find("right side") != std::string::npos); // names the other seam
    QCOMPARE(ids.next, 50);
}

void tst_PatternSeams::anEdgeIsNotSewnToItself() {
    IdSource ids{50};
    QVERIFY(!addSeam(tests::unsewnPanels(), {front, EdgeId("top"), 0, 0.6}, {front, EdgeId("top"), 0.5, 1}, ids));
    QVERIFY(addSeam(tests::unsewnPanels(), {front, EdgeId("top"), 0, 0.5}, {front, EdgeId("top"), 0.5, 1}, ids));
}

void tst_PatternSeams::reversingTwiceChangesNothing() {
    const Pattern pattern = tests::twoPanels();
    const Pattern once = *reverseSeam(pattern, SeamId("s1"));
    QVERIFY(!(once == pattern));
    QVERIFY(*reverseSeam(once, SeamId("s1")) == pattern);
}

void tst_PatternSeams::easeBelongsToASectionBetweenNotches() {
    // Two notches on the front only: the sides do not pair, the seam is one section.
    Pattern pattern = tests::twoPanels();
    QCOMPARE(sectionCount(pattern, pattern.seams[0]), std::size_t(1));
    Piece notched = *pattern.pieces[1];
    notched.notches = {{EdgeId("left"), 0.25}, {EdgeId("left"), 0.75}};
    pattern.pieces[1] = notched;
    QCOMPARE(sectionCount(pattern, pattern.seams[0]), std::size_t(3));
    const Pattern eased = *setSeamEase(pattern, SeamId("s1"), 1, 0.005);
    QCOMPARE(eased.seams[0].sections.size(), std::size_t(3));
    QCOMPARE(eased.seams[0].sections[1].ease, 0.005);
    QVERIFY(!setSeamEase(pattern, SeamId("s1"), 3, 0.005));
    const auto sections = *sectionsOf(pattern, pattern.seams[0]);
    const double front0 = edgeLength(*pattern.pieces[0], EdgeId("right"));
    QVERIFY(std::abs(sections[0].a - 0.25 * front0) < 1e-12);
    QVERIFY(std::abs(sections[1].a - 0.50 * front0) < 1e-12);
    QVERIFY(std::abs(sections[2].b - 0.1) < 1e-12);
}

void tst_PatternSeams::easeAwayLeavesNoMismatch() {
    const Pattern pattern = tests::twoPanels();
    QVERIFY(std::abs((*sectionsOf(pattern, pattern.seams[0]))[0].mismatch()) > 1e-4);
    const Pattern eased = *easeAway(pattern, SeamId("s1"));
    QVERIFY(std::abs((*sectionsOf(eased, eased.seams[0]))[0].mismatch()) < 1e-15);
}

void tst_PatternSeams::gatherAwayTakesTheDifferenceAsGathers() {
    const Pattern pattern = tests::twoPanels();
    QVERIFY(!isGathered(pattern.seams[0]));
    const Pattern gathered = *gatherAway(pattern, SeamId("s1"));
    QVERIFY(isGathered(gathered.seams[0]));
    const SectionLengths lengths = (*sectionsOf(gathered, gathered.seams[0]))[0];
    QVERIFY(std::abs(lengths.mismatch()) < 1e-15);
    QCOMPARE(*gathered.seams[0].sections[0].gatherRatio, lengths.a / lengths.b);
    QVERIFY(!isGathered(easeAway(gathered, SeamId("s1"))->seams[0]));
    QVERIFY(!gatherAway(pattern, SeamId("nobody")));
}

void tst_PatternSeams::aGatherRatioCountsAsEase() {
    Pattern pattern = tests::twoPanels();
    pattern.pieces[0] = tests::rectangle("front", 0.3, 0.6);
    const Pattern gathered = *setGatherRatio(pattern, SeamId("s1"), 0, 1.5); // 0.6 m onto 0.4 m
    QVERIFY(std::abs((*sectionsOf(gathered, gathered.seams[0]))[0].mismatch()) < 1e-12);
}

void tst_PatternSeams::anElasticIsShorterThanItsSeam() {
    const Pattern pattern = tests::twoPanels();
    const SeamId seam("s1");
    const Pattern drawn = *setElastic(pattern, seam, Elastic{.ratio = 0.6, .stiffness = 30});
    QVERIFY(findSeam(drawn, seam)->elastic == (Elastic{.ratio = 0.6, .stiffness = 30}));
    QVERIFY(*setElastic(drawn, seam, std::nullopt) == pattern);
    for (const double ratio : {0.0, 1.0, -0.5, std::nan("")}) QVERIFY(!setElastic(pattern, seam, Elastic{ratio, 30}));
    for (const double stiffness : {0.0, -1.0, std::nan("")})
        QVERIFY(!setElastic(pattern, seam, Elastic{0.6, stiffness}));
    QVERIFY(!setElastic(pattern, SeamId("nobody"), Elastic{}));
}

void tst_PatternSeams::aSeamIsRemoved() {
    const Pattern after = *removeSeam(tests::twoPanels(), SeamId("s1"));
    QCOMPARE(after.seams.size(), std::size_t(1));
    QVERIFY(!removeSeam(after, SeamId("s1")));
}

TOILE_TEST(tst_PatternSeams)
#include "tst_PatternSeams.moc"
