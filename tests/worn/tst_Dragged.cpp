// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "core/simulation/Inspect.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::simulation;

namespace {

/// Of the time that it runs on [–].
double largestStrainDuring(Simulation& simulation, double seconds) {
    double most = 0;
    for (double t = 0; t < seconds; t += simulation.scene().settings.frameStep) {
        if (const auto done = simulation.advance(); !done) qFatal("%s", toString(done.error()).c_str());
        const StrainSummary strain = strainOf(simulation);
        most = std::max({most, strain.warpMaximum, strain.weftMaximum});
    }
    return most;
}

} // namespace

/// A garment that hands drag about while it is worn.
class tst_Dragged : public QObject {
    Q_OBJECT
private slots:
    void aBlouseDraggedByTheHemRestsInTheHandAndGoesBackAfterwards();
};

void tst_Dragged::aBlouseDraggedByTheHemRestsInTheHandAndGoesBackAfterwards() {
    auto simulation = Simulation::create(onBlouseWearer(blouseAt(0.02)));
    QVERIFY(simulation);
    largestStrainDuring(*simulation, 5);
    const meshing::PieceMesh& front = simulation->garment().mesh->pieces[0];
    const auto lowest =
        static_cast<std::size_t>(std::ranges::min_element(front.material, {}, &Vec2::y) - front.material.begin());
    const auto place = [&] { return simulation->nodePositions()[lowest]; };
    const Vec3 before = place();

    simulation->hold({{.piece = simulation->topology()->pieces[0].id,
                       .material = front.material[lowest],
                       .target = before + Vec3{0.25, -0.1, 0.1}}});
    const double strain = largestStrainDuring(*simulation, 4);
    QVERIFY2(strain < 0.3, qPrintable(QString::number(strain)));
    QVERIFY2(distance(place(), before) > 0.1, qPrintable(QString::number(distance(place(), before))));
    QVERIFY2(simulation->largestSpeed() < 0.005, qPrintable(QString::number(simulation->largestSpeed())));

    simulation->hold({});
    const auto report = sew(*simulation, {});
    QVERIFY(report && report->worn);
    QVERIFY(report->reachedItsGoal({}));
    for (const std::string& why : report->worn->why) // friction may keep it where the hand has left it
        QVERIFY2(why.starts_with("Left and right differ"), why.c_str());
}

TOILE_TEST(tst_Dragged, QCoreApplication)
#include "tst_Dragged.moc"
