// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#ifndef Q_MOC_RUN // moc stumbles over the library's concepts
#include "core/meshing/MonotoneChains.h"
#include "tests/Suite.h"

#include <cmath>
#include <random>
#endif

using namespace toile::meshing;

class tst_MonotoneChains : public QObject {
    Q_OBJECT
private slots:
    void chainsCoverTheRingsAndTurnNowhere();
    void theyCrossWhereAnyTwoSegmentsDo();
};

namespace {

/// One or two rings on a coarse grid, so that touching and folding back are common.
std::pmr::vector<RingSegment> randomSegments(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::vector<GridPoint>> rings(1 + random() % 2);
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const int n = 3 + static_cast<int>(random() % 12), size = 6 + static_cast<int>(random() % 200);
        for (int i = 0; i < n; ++i) {
            const GridPoint p =
                seed % 2 == 0 // round a centre, which seldom crosses; or anywhere
                    ? GridPoint{static_cast<int>(400 * r + (100 + random() % size) * std::cos(6.2 * i / n)),
                                static_cast<int>((100 + random() % size) * std::sin(6.2 * i / n))}
                    : GridPoint{static_cast<int>(random() % size), static_cast<int>(random() % size)};
            if (rings[r].empty() || (rings[r].back() != p && rings[r].front() != p)) rings[r].push_back(p);
        }
    }
    std::erase_if(rings, [](const auto& ring) { return ring.size() < 3; });
    std::pmr::vector<RingSegment> segments;
    for (std::size_t r = 0; r < rings.size(); ++r) appendSegments(rings[r], static_cast<int>(r), segments);
    return segments;
}

} // namespace

void tst_MonotoneChains::chainsCoverTheRingsAndTurnNowhere() {
    toile::Arena arena;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        const auto segments = randomSegments(seed);
        int next = 0;
        for (const MonotoneChain& chain : monotoneChains(segments, arena)) {
            QCOMPARE(chain.first, next);
            QVERIFY(chain.last > chain.first);
            next = chain.last;
            for (int i = chain.first; i < chain.last; ++i)
                for (int j = i + 1; j < chain.last; ++j) {
                    const RingSegment &s = segments[static_cast<std::size_t>(i)],
                                      &t = segments[static_cast<std::size_t>(j)];
                    QCOMPARE(s.ring, t.ring);
                    QVERIFY((s.b.x - s.a.x) * (t.b.x - t.a.x) >= 0 && (s.b.y - s.a.y) * (t.b.y - t.a.y) >= 0);
                }
        }
        QCOMPARE(next, static_cast<int>(segments.size()));
    }
}

void tst_MonotoneChains::theyCrossWhereAnyTwoSegmentsDo() {
    toile::Arena arena;
    int crossing = 0;
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        const auto segments = randomSegments(seed);
        bool expected = false;
        for (std::size_t i = 0; i < segments.size(); ++i)
            for (std::size_t j = i + 1; j < segments.size(); ++j) expected |= segmentsClash(segments[i], segments[j]);
        const auto found = chainsCross(segments, arena);
        QVERIFY(found);
        QVERIFY2(*found == expected, qPrintable(QString::number(seed)));
        QCOMPARE(allCrossings(segments, arena).empty(), !expected);
        crossing += expected;
    }
    QVERIFY(crossing > 400 && crossing < 1600); // both kinds
}

TOILE_TEST(tst_MonotoneChains)
#include "tst_MonotoneChains.moc"
