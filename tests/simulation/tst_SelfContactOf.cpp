// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/MeshInputOf.h"
#include "core/simulation/SelfContactOf.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;

namespace {

Garment garmentOf(const pattern::Pattern& pattern, const MeshOverrides& overrides, bool merged) {
    const auto input = meshInputOf(pattern, overrides);
    auto mesh = meshing::meshGarment(*input);
    std::vector<bool> seams(mesh->seams.size(), merged);
    return *makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), std::move(seams));
}

/// How far each particle of two squares is from the edge that is sewn [m].
std::vector<double> distancesFromTheSeam(const Garment& garment) {
    std::vector<double> distances(garment.particles.particleCount);
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece)
        for (std::size_t node = 0; node < garment.mesh->pieces[piece].nodes.size(); ++node) {
            const double x = garment.mesh->pieces[piece].nodes[node].x;
            distances[garment.particles.particleOf[garment.particles.firstNode[piece] + node]] =
                piece == 0 ? 0.2 - x : x;
        }
    return distances;
}

} // namespace

/// The cloth of a garment as a surface that keeps its layers apart.
class tst_SelfContactOf : public QObject {
    Q_OBJECT
private slots:
    void sidesOfAnOpenSeamAreIgnoredWithinTwoSpacingsOfTheMesh_data() {
        QTest::addColumn<double>("spacing"); // [m]; 0 = the document's own, 20 mm
        QTest::addRow("as drawn") << 0.0;
        QTest::addRow("finer than drawn") << 0.005;
        QTest::addRow("coarser than drawn") << 0.04;
    }
    void sidesOfAnOpenSeamAreIgnoredWithinTwoSpacingsOfTheMesh() {
        QFETCH(const double, spacing);
        const Scene scene = twoSquares(0.02);
        const double used = spacing > 0 ? spacing : 0.02;
        MeshOverrides overrides;
        if (spacing > 0) overrides.spacing = spacing;
        const Garment garment = garmentOf(scene.pattern, overrides, false);
        const auto surface = clothSurfaceOf(scene, garment);
        const std::vector<double> distances = distancesFromTheSeam(garment);
        double farthest = 0;
        for (std::size_t p = 0; p < surface.ignored.size(); ++p)
            for (const int q : surface.ignored[p]) {
                QVERIFY(std::ranges::count(surface.ignored[q], static_cast<int>(p)) == 1); // each ignores the other
                farthest = std::max(farthest, distances[p] + distances[q]);
            }
        QCOMPARE(farthest, 2 * used);
    }

    void nothingIsIgnoredInWhatIsSewn() {
        const Scene scene = twoSquares(0.02);
        QVERIFY(clothSurfaceOf(scene, garmentOf(scene.pattern, {}, true)).ignored.empty());
    }
};

QTEST_GUILESS_MAIN(tst_SelfContactOf)
#include "tst_SelfContactOf.moc"
