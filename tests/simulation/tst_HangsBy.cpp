// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/HangsBy.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>
#include <array>

using namespace toile;
using namespace toile::simulation;

class tst_HangsBy : public QObject {
    Q_OBJECT
private slots:
    void withoutABodyNothingIsABand() {
        const Simulation squares = simulationOf(twoSquares(0.05));
        QVERIFY(nodesItHangsBy(squares, squares).empty());
    }

    /// k ≤ m/(2 h²) for a spring between two equal ends: with inertia 2 k h²/m it is just as stiff as it is.
    void inertiaIsWhatTheStiffestElementNeeds() {
        const Simulation squares = simulationOf(twoSquares(0.05));
        const Garment& garment = squares.garment();
        const double h = 0.01;
        const std::vector<double> inertia = inertiaOf(garment, std::array{0, 7}, h);
        for (std::size_t p = 0; p < inertia.size(); ++p) {
            if (p != static_cast<std::size_t>(garment.particles.particleOf[0]) &&
                p != static_cast<std::size_t>(garment.particles.particleOf[7])) {
                QCOMPARE(inertia[p], 1.0);
                continue;
            }
            double stiffest = 0;
            for (const cloth::Spring& s : garment.model.structural)
                if (s.a == static_cast<int>(p) || s.b == static_cast<int>(p))
                    stiffest = std::max(stiffest, s.stiffness);
            QVERIFY(stiffest > 0);
            QVERIFY(inertia[p] > 1);
            QVERIFY(std::abs(inertia[p] / (2 * stiffest * h * h / garment.model.mass[p]) - 1) < 1e-12);
        }
        for (const double scale : inertiaOf(garment, std::array{0, 7}, 1e-7)) QCOMPARE(scale, 1.0); // none is capped
    }
};

TOILE_TEST(tst_HangsBy)
#include "tst_HangsBy.moc"
