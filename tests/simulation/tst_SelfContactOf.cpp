// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/MeshInputOf.h"
#include "core/simulation/SelfContactOf.h"

#include <QTest>
#include <map>

using namespace toile;
using namespace toile::simulation;

namespace {

Garment garmentOf(const pattern::Pattern& pattern, const MeshOverrides& overrides, bool merged) {
    const auto input = meshInputOf(pattern, overrides);
    auto mesh = meshing::meshGarment(*input);
    std::vector<bool> seams(mesh->seams.size(), merged);
    return *makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), std::move(seams));
}

} // namespace

/// The cloth of a garment as a surface that keeps its layers apart.
class tst_SelfContactOf : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatAnOpenSeamJoinsBecomesOne() {
        const Scene scene = twoSquares(0.02);
        const Garment garment = garmentOf(scene.pattern, {}, false);
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
        QVERIFY(clothSurfaceOf(scene, garmentOf(scene.pattern, {}, true)).becomes.empty());
    }
};

QTEST_GUILESS_MAIN(tst_SelfContactOf)
#include "tst_SelfContactOf.moc"
