// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/Intersections.h"
#include "core/collision/SelfProximity.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <random>
#include <set>

using namespace toile;
using namespace toile::collision;
using geometry::TriangleIndices;

namespace {

/// A square sheet of n×n vertices, triangles of either diagonal.
std::vector<TriangleIndices> sheetTriangles(int n) {
    std::vector<TriangleIndices> triangles;
    for (int r = 0; r + 1 < n; ++r)
        for (int c = 0; c + 1 < n; ++c) {
            const int i = r * n + c;
            if ((r + c) % 2) triangles.insert(triangles.end(), {{i, i + 1, i + n}, {i + 1, i + n + 1, i + n}});
            else triangles.insert(triangles.end(), {{i, i + 1, i + n + 1}, {i, i + n + 1, i + n}});
        }
    return triangles;
}

std::vector<Vec3> flatSheet(int n, double spacing) {
    std::vector<Vec3> points;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) points.push_back({c * spacing, 0, r * spacing});
    return points;
}

std::vector<Vec3> scattered(std::size_t count, double size, std::mt19937& random) {
    std::uniform_real_distribution<double> somewhere(-size, size);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({somewhere(random), somewhere(random), somewhere(random)});
    return points;
}

/// A sheet of 10 mm cells pressed into a third of its size, and shaken.
std::vector<Vec3> crumpled(int n, std::mt19937& random) {
    std::vector<Vec3> points = flatSheet(n, 0.01);
    const std::vector<Vec3> noise = scattered(points.size(), 0.004, random);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec3& p = points[i];
        p = Vec3{0.3 * p.x, 0.02 * std::sin(90 * p.x + 40 * p.z), 0.3 * p.z} + noise[i];
    }
    return points;
}

bool apart(const std::vector<int>& a, const std::vector<int>& b) {
    return std::ranges::none_of(a, [&](int v) { return std::ranges::count(b, v) > 0; });
}

/// All pairs of elements, by looking at each.
std::vector<ElementPair> allPairs(const std::vector<TriangleIndices>& triangles, int vertices) {
    std::set<std::array<int, 2>> edgeSet;
    std::vector<ElementPair> pairs;
    for (const auto& [a, b, c] : triangles) {
        edgeSet.insert({std::minmax(a, b).first, std::minmax(a, b).second});
        edgeSet.insert({std::minmax(b, c).first, std::minmax(b, c).second});
        edgeSet.insert({std::minmax(c, a).first, std::minmax(c, a).second});
        for (int v = 0; v < vertices; ++v)
            if (apart({v}, {a, b, c})) pairs.push_back({{v, a, b, c}, 1});
    }
    const std::vector<std::array<int, 2>> edges(edgeSet.begin(), edgeSet.end());
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (std::size_t f = e + 1; f < edges.size(); ++f)
            if (apart({edges[e][0], edges[e][1]}, {edges[f][0], edges[f][1]}))
                pairs.push_back({{edges[e][0], edges[e][1], edges[f][0], edges[f][1]}, 2});
    return pairs;
}

/// The same pair whichever element is named first and where its corners begin.
ElementPair canonical(ElementPair pair) {
    if (pair.firstCount == 1) {
        std::sort(pair.vertices.begin() + 1, pair.vertices.end());
        return pair;
    }
    auto& [a, b, c, d] = pair.vertices;
    if (a > b) std::swap(a, b);
    if (c > d) std::swap(c, d);
    if (a > c) pair.vertices = {c, d, a, b};
    return pair;
}

std::vector<ElementPair> canonical(const std::vector<SelfProximity::Near>& found) {
    std::vector<ElementPair> pairs;
    for (const auto& near : found) pairs.push_back(canonical(near.pair));
    std::ranges::sort(pairs);
    return pairs;
}

double leastDistanceOnGrid(const ElementPair& pair, const std::vector<Vec3>& x) {
    double least = 1e300;
    const auto& [a, b, c, d] = pair.vertices;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i)
        for (int k = 0; k <= steps; ++k) {
            const double s = double(i) / steps, t = double(k) / steps;
            if (pair.firstCount == 2) least = std::min(least, distance(lerp(x[a], x[b], s), lerp(x[c], x[d], t)));
            else if (s + t <= 1) least = std::min(least, distance(x[a], x[b] * (1 - s - t) + x[c] * s + x[d] * t));
        }
    return least;
}

} // namespace

/// The broad phase and its pairs against looking at every pair.
class tst_SelfProximity : public QObject {
    Q_OBJECT
private slots:
    void separationIsTheShortestWay_data();
    void separationIsTheShortestWay();
    void alongTheShortestWayTheGapIsTheDistance();
    void findsWhatBruteForceFinds_data();
    void findsWhatBruteForceFinds();
    void findsEveryPairThatMeetsOnTheWay();
    void findsEveryPairThatBoxesLetMeet();
    void whatFliesTogetherIsNoNearer();
    void aTeamFindsTheSameInTheSameOrder();
    void whatIsFlaggedIsFoundAsInAWholeSearch();
    void morePairsThanAskedForAreNone();
    void elementsWithACommonCornerAreNoPair();
    void piercingsAreThoseOfTheReferee();
    void aFlatSheetDoesNotPierceItselfHoweverItLies();
    void aFlatSheetHasNothingWithinHalfACell();
};

void tst_SelfProximity::separationIsTheShortestWay_data() {
    QTest::addColumn<int>("firstCount");
    QTest::newRow("corner and triangle") << 1;
    QTest::newRow("edge and edge") << 2;
}

void tst_SelfProximity::separationIsTheShortestWay() {
    QFETCH(int, firstCount);
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        const std::vector<Vec3> x = scattered(4, 1, random);
        const ElementPair pair{{0, 1, 2, 3}, firstCount};
        const Separation found = separationOf(pair, x);
        double first = 0, second = 0;
        for (int i = 0; i < 4; ++i) (i < firstCount ? first : second) += found.weights[i];
        QVERIFY(std::abs(first - 1) < 1e-12 && std::abs(second + 1) < 1e-12);
        const double onGrid = leastDistanceOnGrid(pair, x);
        QVERIFY(found.distance <= onGrid + 1e-12);
        QVERIFY(found.distance >= onGrid - 0.1); // edges of at most 3.5 m, walked in 40 steps
    }
}

void tst_SelfProximity::alongTheShortestWayTheGapIsTheDistance() {
    std::mt19937 random(8);
    for (int trial = 0; trial < 1000; ++trial) {
        const std::vector<Vec3> x = scattered(4, 1, random);
        const ElementPair pair{{0, 1, 2, 3}, 1 + trial % 2};
        const Separation found = separationOf(pair, x);
        QVERIFY(std::abs(gapAlong(found.way / found.distance, pair, x) - found.distance) < 1e-9);
    }
}

void tst_SelfProximity::findsWhatBruteForceFinds_data() {
    QTest::addColumn<double>("reach");
    for (const double reach : {0.0005, 0.002, 0.006}) QTest::addRow("within %g mm", 1000 * reach) << reach;
}

void tst_SelfProximity::findsWhatBruteForceFinds() {
    QFETCH(double, reach);
    const int n = 12;
    const auto triangles = sheetTriangles(n);
    const auto pairs = allPairs(triangles, n * n);
    SelfProximity proximity(triangles, flatSheet(n, 0.01));
    for (unsigned seed = 1; seed <= 5; ++seed) {
        std::mt19937 random(seed);
        const std::vector<Vec3> x = crumpled(n, random);
        std::vector<ElementPair> expected;
        for (const ElementPair& pair : pairs)
            if (separationOf(pair, x).distance <= reach) expected.push_back(canonical(pair));
        std::ranges::sort(expected);
        QVERIFY(!expected.empty());
        QVERIFY2(canonical(*proximity.pairsWithin(reach, x)) == expected, qPrintable(QString("seed %1").arg(seed)));
    }
}

void tst_SelfProximity::findsEveryPairThatMeetsOnTheWay() {
    const int n = 9;
    const auto triangles = sheetTriangles(n);
    const auto pairs = allPairs(triangles, n * n);
    SelfProximity proximity(triangles, flatSheet(n, 0.01));
    constexpr double reach = 0.001;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        std::mt19937 random(seed);
        const std::vector<Vec3> x = crumpled(n, random);
        std::vector<Vec3> moves = scattered(x.size(), 0.005, random);
        for (Vec3& move : moves) move += {0.1, 0, 0}; // together, ten cells far
        const auto found = canonical(*proximity.pairsInStep(reach, x, moves));
        std::set<ElementPair> meeting;
        for (int step = 0; step <= 10; ++step) {
            std::vector<Vec3> there = x;
            for (std::size_t v = 0; v < x.size(); ++v) there[v] += 0.1 * step * moves[v];
            for (const ElementPair& pair : pairs)
                if (separationOf(pair, there).distance <= reach) meeting.insert(canonical(pair));
        }
        QVERIFY(std::ranges::includes(found, meeting));
        QVERIFY(found.size() < pairs.size() / 2); // and not simply all: what they do together brings nothing nearer
    }
}

void tst_SelfProximity::findsEveryPairThatBoxesLetMeet() {
    const int n = 8;
    const auto triangles = sheetTriangles(n);
    const auto pairs = allPairs(triangles, n * n);
    SelfProximity proximity(triangles, flatSheet(n, 0.01));
    constexpr double reach = 0.001;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(0, 1);
        const std::vector<Vec3> x = crumpled(n, random);
        std::vector<geometry::Box3> boxes;
        for (std::size_t v = 0; v < x.size(); ++v) { // most are small, and a few reach far
            const std::vector<Vec3> ends = scattered(2, random() % 8 == 0 ? 0.02 : 0.0005, random);
            boxes.push_back(
                {{std::min(ends[0].x, ends[1].x), std::min(ends[0].y, ends[1].y), std::min(ends[0].z, ends[1].z)},
                 {std::max(ends[0].x, ends[1].x), std::max(ends[0].y, ends[1].y), std::max(ends[0].z, ends[1].z)}});
        }
        const auto found = canonical(*proximity.pairsInBoxes(reach, x, boxes));
        std::set<ElementPair> meeting;
        for (int trial = 0; trial < 200; ++trial) { // corners of boxes, and anywhere
            std::vector<Vec3> there = x;
            for (std::size_t v = 0; v < x.size(); ++v)
                for (int axis = 0; axis < 3; ++axis) {
                    const double t = trial % 2 ? part(random) : static_cast<double>(random() % 2);
                    there[v][axis] += (1 - t) * boxes[v].low[axis] + t * boxes[v].high[axis];
                }
            for (const ElementPair& pair : pairs)
                if (separationOf(pair, there).distance <= reach) meeting.insert(canonical(pair));
        }
        QVERIFY(!meeting.empty() && std::ranges::includes(found, meeting));
        QVERIFY(found.size() < pairs.size() / 2);
    }
}

void tst_SelfProximity::whatFliesTogetherIsNoNearer() {
    const int n = 12;
    SelfProximity proximity(sheetTriangles(n), flatSheet(n, 0.01));
    std::mt19937 random(3);
    const std::vector<Vec3> x = crumpled(n, random);
    const std::vector<Vec3> moves(x.size(), {0.3, 0.2, -0.1});
    QVERIFY(canonical(*proximity.pairsInStep(0.002, x, moves)) == canonical(*proximity.pairsWithin(0.002, x)));
}

void tst_SelfProximity::aTeamFindsTheSameInTheSameOrder() {
    const int n = 30;
    SelfProximity proximity(sheetTriangles(n), flatSheet(n, 0.01));
    std::mt19937 random(5);
    const std::vector<Vec3> x = crumpled(n, random), moves = scattered(x.size(), 0.005, random);
    const auto alone = *proximity.pairsInStep(0.002, x, moves);
    QVERIFY(alone.size() > 1000);
    for (const int members : {1, 2, 3}) {
        Team team(members);
        const auto shared = proximity.pairsInStep(0.002, x, moves, alone.size(), &team);
        QVERIFY(shared && std::ranges::equal(alone, *shared, [](const auto& a, const auto& b) {
                    return a.pair == b.pair && a.distance == b.distance;
                }));
        QVERIFY(!proximity.pairsInStep(0.002, x, moves, alone.size() - 1, &team));
    }
}

/// Some vertices go other ways than in the search before: pairs that have one of them are those of a search for all.
void tst_SelfProximity::whatIsFlaggedIsFoundAsInAWholeSearch() {
    const int n = 20;
    const double reach = 0.002;
    const auto isSame = [](const auto& a, const auto& b) {
        return a.pair == b.pair && a.distance == b.distance && a.order == b.order;
    };
    for (const unsigned one : {2U, 7U, 25U, 1U}) { // of so many is flagged
        std::mt19937 random(one);
        SelfProximity proximity(sheetTriangles(n), flatSheet(n, 0.01)), whole(sheetTriangles(n), flatSheet(n, 0.01));
        std::vector<Vec3> x = crumpled(n, random), moves = scattered(x.size(), 0.003, random);
        QVERIFY(proximity.pairsInStep(reach, x, moves));
        std::vector<char> flagged(x.size(), 0);
        for (std::size_t v = 0; v < x.size(); ++v)
            if (random() % one == 0) {
                flagged[v] = 1;
                x[v] += scattered(1, 0.004, random)[0];
                moves[v] = scattered(1, 0.02, random)[0];
            }
        auto all = *whole.pairsInStep(reach, x, moves);
        QVERIFY(std::ranges::is_sorted(all, std::ranges::less{}, &SelfProximity::Near::order));
        QVERIFY(std::ranges::adjacent_find(all, {}, &SelfProximity::Near::order) == all.end());
        std::erase_if(all, [&](const auto& near) {
            return std::ranges::none_of(near.pair.vertices, [&](int v) { return flagged[v] != 0; });
        });
        const auto found = proximity.pairsOfFlagged(flagged, x, moves);
        QVERIFY(found && found->size() > 50 && std::ranges::equal(*found, all, isSame));
        Team team(2);
        const auto shared = proximity.pairsOfFlagged(flagged, x, moves, all.size(), &team);
        QVERIFY(shared && std::ranges::equal(*shared, all, isSame));
        QVERIFY(!proximity.pairsOfFlagged(flagged, x, moves, all.size() - 1));
    }
}

void tst_SelfProximity::morePairsThanAskedForAreNone() {
    const int n = 12;
    SelfProximity proximity(sheetTriangles(n), flatSheet(n, 0.01));
    std::mt19937 random(4);
    const std::vector<Vec3> x = crumpled(n, random), moves(x.size());
    const std::vector<geometry::Box3> boxes(x.size());
    const std::size_t all = proximity.pairsWithin(0.004, x)->size();
    QVERIFY(proximity.pairsWithin(0.004, x, all) && !proximity.pairsWithin(0.004, x, all - 1));
    QVERIFY(proximity.pairsInStep(0.004, x, moves, all) && !proximity.pairsInStep(0.004, x, moves, all - 1));
    QVERIFY(proximity.pairsInBoxes(0.004, x, boxes, all) && !proximity.pairsInBoxes(0.004, x, boxes, all - 1));
}

void tst_SelfProximity::elementsWithACommonCornerAreNoPair() {
    const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    SelfProximity proximity({{0, 1, 2}, {1, 3, 2}}, x);
    const auto found = canonical(*proximity.pairsWithin(10, x));
    // Corner 0 and the far triangle, corner 3 and the near one, and the two pairs of opposite sides.
    QCOMPARE(found.size(), std::size_t(4));
    QCOMPARE(std::ranges::count(found, 1, &ElementPair::firstCount), 2);
}

void tst_SelfProximity::piercingsAreThoseOfTheReferee() {
    const int n = 12;
    const auto triangles = sheetTriangles(n);
    SelfProximity proximity(triangles, flatSheet(n, 0.01));
    for (unsigned seed = 1; seed <= 5; ++seed) {
        std::mt19937 random(seed);
        const std::vector<Vec3> x = crumpled(n, random);
        // Two triangles without a common corner meet where an edge of one passes through the other.
        std::set<std::pair<int, int>> met;
        for (const auto& [edge, triangle] : proximity.piercings(x))
            for (std::size_t t = 0; t < triangles.size(); ++t) {
                const auto& [p, q] = proximity.edges()[edge].vertices;
                const auto& corners = triangles[t];
                if (std::ranges::count(corners, p) && std::ranges::count(corners, q) &&
                    apart({corners.begin(), corners.end()}, {triangles[triangle].begin(), triangles[triangle].end()}))
                    met.insert(std::minmax(static_cast<int>(t), triangle));
            }
        const auto expected = selfIntersectingTriangles({x, triangles});
        QVERIFY(!expected.empty());
        QVERIFY(std::ranges::equal(met, expected));
    }
}

void tst_SelfProximity::aFlatSheetDoesNotPierceItselfHoweverItLies() {
    const auto triangles = sheetTriangles(20);
    for (int k = 0; k < 60; ++k) { // edges lie in the planes of triangles beside them but for rounding
        const double lean = 0.05 * k, c = std::cos(lean), s = std::sin(lean);
        std::vector<Vec3> sheet = flatSheet(20, 0.0234);
        for (Vec3& p : sheet) p = Vec3{c * p.x, -s * p.x, p.z} + Vec3{0.119641, 1.013571, -0.0553};
        SelfProximity proximity(triangles, sheet);
        QVERIFY2(proximity.piercings(sheet).empty(), qPrintable(QString("leaning by %1").arg(lean)));
    }
}

void tst_SelfProximity::aFlatSheetHasNothingWithinHalfACell() {
    SelfProximity proximity(sheetTriangles(20), flatSheet(20, 0.01));
    QVERIFY(proximity.pairsWithin(0.005, flatSheet(20, 0.01))->empty());
    QVERIFY(proximity.piercings(flatSheet(20, 0.01)).empty());
}

TOILE_TEST(tst_SelfProximity)
#include "tst_SelfProximity.moc"
