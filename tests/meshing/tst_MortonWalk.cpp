// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#ifndef Q_MOC_RUN // moc stumbles over the library's concepts
#include "core/meshing/IntegerLines.h"
#include "core/meshing/MortonWalk.h"
#include "tests/Suite.h"

#include <random>
#endif

using namespace toile::meshing;

class tst_MortonWalk : public QObject {
    Q_OBJECT
private slots:
    void itVisitsInTheOrderOfTheKeys();
    void keysAreSorted();
    void anAxisFindsWhatASearchFinds();
};

void tst_MortonWalk::itVisitsInTheOrderOfTheKeys() {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        const int columns = 1 + static_cast<int>(random() % 50), rows = 1 + static_cast<int>(random() % 50);
        const MortonSquare square(columns, rows, static_cast<int>(random() % columns),
                                  static_cast<int>(random() % rows));
        std::vector<KeyedNode> others, all, buffer;
        for (int i = 0; i < static_cast<int>(random() % 100); ++i)
            others.emplace_back(
                square.key(static_cast<int>(random() % (256 * columns)) | 1, static_cast<int>(random() % (256 * rows))),
                1000000 + i);
        sortByKey(others, buffer);
        all = others;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                all.emplace_back(square.key(256 * column, 256 * row), row * columns + column);
        std::sort(all.begin(), all.end());
        std::vector<int> visited;
        const auto visit = [&](int number, int node) {
            visited.push_back(node);
            return number + 1;
        };
        const auto visitCorner = [&](int number, int column, int row) { return visit(number, row * columns + column); };
        const auto visitBlock = [&](int number, int column, int row) {
            for (const auto [x, y] : orderInBlock) number = visitCorner(number, column + x, row + y);
            return number;
        };
        const int count = MortonWalk(square, columns, rows, others, visitBlock, visitCorner, visit).run();
        QCOMPARE(count, static_cast<int>(all.size()));
        QCOMPARE(visited.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) QCOMPARE(visited[i], all[i].second);
    }
}

void tst_MortonWalk::keysAreSorted() {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<KeyedNode> nodes, buffer;
        for (int i = 0; i < static_cast<int>(random() % 3000); ++i)
            nodes.emplace_back(random() >> (seed % 60), static_cast<int>(random() % 100000));
        std::vector<KeyedNode> expected = nodes;
        std::sort(expected.begin(), expected.end());
        sortByKey(nodes, buffer);
        QVERIFY(nodes == expected);
    }
}

void tst_MortonWalk::anAxisFindsWhatASearchFinds() {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        std::mt19937 random(seed);
        std::vector<std::int32_t> lines;
        const int spread = seed % 2 == 0 ? 1000 : 100000000; // with doubled lines, and far apart
        for (int i = 0; i < 2 + static_cast<int>(random() % 300); ++i)
            lines.push_back(static_cast<std::int32_t>(random() % static_cast<unsigned>(spread)) - spread / 2);
        if (seed % 5 == 0) // many close together
            for (std::int32_t& line : lines) line /= random() % 4 == 0 ? 1 : 1000;
        std::sort(lines.begin(), lines.end());
        if (lines.front() == lines.back()) continue;
        IntegerAxis axis;
        axis.assign(lines);
        for (int i = 0; i < 400; ++i) {
            const std::int64_t value = i < 200 ? lines[random() % lines.size()] + static_cast<int>(random() % 3) - 1
                                               : static_cast<std::int64_t>(random() % (2u * spread)) - spread;
            const auto above = std::upper_bound(lines.begin(), lines.end(), value);
            const int last = static_cast<int>(lines.size()) - 2;
            const int expected = std::clamp(static_cast<int>(above - lines.begin()) - 1, 0, last);
            if (value > lines.front()) QCOMPARE(axis.interval(value), expected);
            else QCOMPARE(axis.interval(value), value < lines.front() ? 0 : axis.interval(lines.front()));
            QCOMPARE(axis.firstFrom(value),
                     static_cast<int>(std::lower_bound(lines.begin(), lines.end(), value) - lines.begin()));
        }
    }
}

TOILE_TEST(tst_MortonWalk)
#include "tst_MortonWalk.moc"
