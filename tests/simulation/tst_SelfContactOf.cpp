// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/SelfContactOf.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"

#include <QTest>
#include <map>

using namespace toile;
using namespace toile::simulation;

/// The cloth of a garment as a surface that keeps its layers apart.
class tst_SelfContactOf : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatAnOpenSeamJoinsBecomesOne() {
        const Scene scene = twoSquares(0.02);
        const Garment garment = garmentOf(scene.pattern);
        const std::vector<int> becomes = clothSurfaceOf(scene, garment).becomes;
        QCOMPARE(static_cast<int>(becomes.size()), garment.particles.particleCount);
        std::map<int, std::vector<int>> joined;
        for (std::size_t p = 0; p < becomes.size(); ++p) joined[becomes[p]].push_back(static_cast<int>(p));
        std::erase_if(joined, [](const auto& one) { return one.second.size() == 1; });
        const auto& pairs = garment.mesh->seams[0].pairs;
        QCOMPARE(joined.size(), pairs.size());
        for (const auto& [a, b] : pairs)
            QCOMPARE(becomes[garment.particles.particle(a)], becomes[garment.particles.particle(b)]);
    }

    void nothingIsLetThroughInWhatIsSewn() {
        const Scene scene = twoSquares(0.02);
        QVERIFY(clothSurfaceOf(scene, garmentOf(scene.pattern, true)).becomes.empty());
    }
};

TOILE_TEST(tst_SelfContactOf, QCoreApplication)
#include "tst_SelfContactOf.moc"
