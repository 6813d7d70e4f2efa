// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/UnionFind.h"
#include "tests/Suite.h"

#include <QTest>
#include <random>

using toile::UnionFind;

/// Sets that grow together.
class tst_UnionFind : public QObject {
    Q_OBJECT
private slots:
    void theLeastStandsForItsSet();
};

/// Against flags that are carried over, whatever the order of joining.
void tst_UnionFind::theLeastStandsForItsSet() {
    std::mt19937 random(7);
    for (int trial = 0; trial < 20; ++trial) {
        constexpr int count = 30;
        UnionFind sets(count);
        std::vector<int> least(count);
        for (int i = 0; i < count; ++i) least[i] = i;
        for (int joins = 0; joins < 25; ++joins) {
            const int a = static_cast<int>(random() % count), b = static_cast<int>(random() % count);
            sets.join(a, b);
            const auto [low, high] = std::minmax({least[a], least[b]});
            std::ranges::replace(least, high, low);
            for (int i = 0; i < count; ++i) QCOMPARE(sets.rootOf(i), least[i]);
        }
    }
}

TOILE_TEST(tst_UnionFind, QCoreApplication)
#include "tst_UnionFind.moc"
