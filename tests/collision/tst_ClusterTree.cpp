// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ClusterTree.h"
#include "tests/Suite.h"

#include <QTest>
#include <optional>
#include <random>
#include <set>
#include <utility>

using namespace toile;
using namespace toile::collision;

namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Triangles that share no corner, anywhere in a cube.
struct Scattered {
    std::vector<geometry::Vec3> positions;
    std::vector<geometry::TriangleIndices> triangles;

    explicit Scattered(int count) {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> place(0, 1);
        for (int t = 0; t < count; ++t) {
            const geometry::Vec3 at{place(random), place(random), place(random)};
            for (const geometry::Vec3& corner : {at, at + geometry::Vec3{0.1, 0, 0}, at + geometry::Vec3{0, 0.1, 0}})
                positions.push_back(corner);
            triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
    }
    [[nodiscard]] SweptBox boxOf(const ClusterTree& tree, int cluster) const {
        std::optional<SweptBox> all;
        for (const int t : tree.trianglesOf(cluster))
            for (const int v : triangles[t]) {
                const SweptBox box({positions[v], positions[v]}, 0.02);
                all = all ? around(*all, box) : box;
            }
        return *all;
    }
};

Pairs visited(const ClusterTree& tree, std::size_t shares) {
    Pairs pairs;
    for (const auto& share : tree.sharesOfSearch(shares))
        tree.forNearClusters(share, [&](const ClusterTree::Pair& pair) {
            pairs.emplace_back(tree.clusterAt(pair.first), tree.clusterAt(pair.second));
            return true;
        });
    return pairs;
}

} // namespace

class tst_ClusterTree : public QObject {
    Q_OBJECT
private slots:
    void eachTriangleIsInOneClusterAndTheyAreFull();
    void visitsEachNearPairOnceInOneOrder();
    void visitsOnlyPairsThatCount();
};

void tst_ClusterTree::eachTriangleIsInOneClusterAndTheyAreFull() {
    for (const int count : {0, 1, 4, 5, 7, 64, 333}) {
        const Scattered scattered(count);
        const ClusterTree tree(scattered.triangles, scattered.positions);
        QCOMPARE(tree.clusters(), (count + ClusterTree::most - 1) / ClusterTree::most);
        std::set<int> seen;
        for (int c = 0; c < tree.clusters(); ++c)
            for (const int t : tree.trianglesOf(c)) QVERIFY(seen.insert(t).second);
        QCOMPARE(std::ssize(seen), count);
    }
}

void tst_ClusterTree::visitsEachNearPairOnceInOneOrder() {
    const Scattered scattered(333);
    ClusterTree tree(scattered.triangles, scattered.positions);
    tree.fit(nullptr, [&](int cluster) { return scattered.boxOf(tree, cluster); });
    std::set<std::pair<int, int>> expected;
    for (int a = 0; a < tree.clusters(); ++a)
        for (int b = a; b < tree.clusters(); ++b)
            if (meet(scattered.boxOf(tree, a), scattered.boxOf(tree, b))) expected.emplace(a, b);
    const Pairs pairs = visited(tree, 1);
    std::set<std::pair<int, int>> found;
    for (const auto& [a, b] : pairs) QVERIFY(found.insert(std::minmax(a, b)).second);
    QVERIFY(expected.size() > 200 && found == expected);
    QCOMPARE(visited(tree, 50), pairs);
}

void tst_ClusterTree::visitsOnlyPairsThatCount() {
    const Scattered scattered(333);
    ClusterTree tree(scattered.triangles, scattered.positions);
    const auto counts = [](int cluster) { return cluster % 7 == 0; };
    tree.fit(nullptr, [&](int cluster) { return scattered.boxOf(tree, cluster); });
    Pairs expected = visited(tree, 1);
    std::erase_if(expected, [&](const auto& pair) { return !counts(pair.first) && !counts(pair.second); });
    tree.countOnly(counts);
    QVERIFY(expected.size() > 20);
    QCOMPARE(visited(tree, 1), expected);
    tree.countAll();
    QVERIFY(visited(tree, 1).size() > expected.size());
}

TOILE_TEST(tst_ClusterTree)
#include "tst_ClusterTree.moc"
