// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/pattern/PatternFabrics.h"
#include "core/simulation/DrawnUp.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

/// 0.3 m of the left piece gathered into 0.2 m of the right one.
pattern::Pattern gathered() {
    pattern::Pattern pattern = twoSquares(0.02).pattern;
    pattern::Piece left = *pattern.pieces[0];
    left.outline.vertices[2].position.y = left.outline.vertices[3].position.y = 0.3;
    pattern.pieces[0] = left;
    pattern.seams[0].sections = {{.ease = 0, .gatherRatio = 1.5}};
    return pattern;
}

/// The same as 0.1 m of ease.
pattern::Pattern eased() {
    pattern::Pattern pattern = gathered();
    pattern.seams[0].sections = {{.ease = 0.1, .gatherRatio = {}}};
    return pattern;
}

} // namespace

class tst_DrawnUp : public QObject {
    Q_OBJECT
private slots:
    void everyStitchOfTheLongerSideIsDrawnToTheShorterOne() {
        const pattern::Pattern pattern = gathered();
        const auto mesh = meshOf(pattern);
        const auto drawn = drawnUp(pattern, mesh, {true});
        QCOMPARE(drawn[0].size(), mesh.seams[0].pairs.size() - 1);
        QVERIFY(drawn[1].empty());
        double length = 0;
        for (const auto& [ends, factor] : drawn[0]) {
            QVERIFY(std::abs(factor - 2.0 / 3) < 1e-9);
            length +=
                factor * geometry::distance(mesh.pieces[0].material[ends.first], mesh.pieces[0].material[ends.second]);
        }
        QVERIFY(std::abs(length - 0.2) < 1e-9);
    }
    void anOpenSeamDrawsNothing() {
        const pattern::Pattern pattern = gathered();
        const auto drawn = drawnUp(pattern, meshOf(pattern), {false});
        QVERIFY(drawn[0].empty() && drawn[1].empty());
    }
    void easeIsDrawnUpAsGathersAre() {
        const auto drawn = drawnUp(eased(), meshOf(eased()), {true});
        QCOMPARE(drawn, drawnUp(gathered(), meshOf(gathered()), {true}));
    }
    void aShorterSideOfKnitIsStretchedInstead() {
        pattern::Pattern pattern = eased();
        material::Fabric knit = *pattern.fabrics[0];
        knit.id = material::FabricId("knit");
        knit.kind = material::FabricKind::knit;
        pattern.fabrics.push_back(knit);
        const auto cutFrom = [&](int piece) {
            return *pattern::setPieceFabric(pattern, pattern.pieces[piece]->id, knit.id);
        };
        const auto longer = cutFrom(0), shorter = cutFrom(1);
        QVERIFY(!drawnUp(longer, meshOf(longer), {true})[0].empty());
        QVERIFY(drawnUp(shorter, meshOf(shorter), {true})[0].empty());
    }
    void aDifferenceThatIsNotDeclaredIsShared() {
        pattern::Pattern pattern = eased();
        pattern.seams[0].sections = {};
        QVERIFY(drawnUp(pattern, meshOf(eased()), {true})[0].empty());
    }
    /// Both sides of the merged row want the length of the shorter one.
    void theGarmentsRowIsAsLongAsTheShorterSide() {
        const pattern::Pattern pattern = gathered();
        const auto garment = makeGarment(pattern, Shared<meshing::GarmentMesh>(meshOf(pattern)), {true});
        QVERIFY(garment);
        const auto& pairs = garment->mesh->seams[0].pairs;
        double sum = 0;
        int sides = 0;
        for (std::size_t i = 1; i < pairs.size(); ++i) {
            const int a = garment->particles.particle(pairs[i - 1][0]), b = garment->particles.particle(pairs[i][0]);
            for (const cloth::Spring& spring : garment->model.structural)
                if (std::minmax(spring.a, spring.b) == std::minmax(a, b)) {
                    sum += spring.restLength;
                    ++sides;
                }
        }
        QCOMPARE(sides, 2 * static_cast<int>(pairs.size() - 1));
        QVERIFY(std::abs(sum - 2 * 0.2) < 1e-9);
    }
};

TOILE_TEST(tst_DrawnUp, QCoreApplication)
#include "tst_DrawnUp.moc"
