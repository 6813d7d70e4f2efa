// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "samples/Shirt.h"

using namespace toile;
using namespace toile::simulation;

namespace {

/// Where a tack begins, towards the right side of the cloth; not of unit length.
Vec3 rightSideAt(const MeshPoint& point, const Simulation& simulation) {
    const auto at = [&](int corner) {
        const meshing::NodeRef node{point.piece, point.nodes[corner]};
        return simulation.state().positions[simulation.garment().particles.particle(node)];
    };
    const std::vector<Vec2>& flat = simulation.garment().mesh->pieces[point.piece].nodes;
    const Vec2 origin = flat[point.nodes[0]];
    const double turn = geometry::cross(flat[point.nodes[1]] - origin, flat[point.nodes[2]] - origin);
    return cross(at(1) - at(0), at(2) - at(0)) * (turn > 0 ? 1.0 : -1.0);
}

} // namespace

/// Fronts that lie one over the other and are buttoned: the sample shirt, from where its pieces are placed.
class tst_Shirt : public QObject {
    Q_OBJECT
private slots:
    void isWornWithRightOverLeft();
};

void tst_Shirt::isWornWithRightOverLeft() {
    const auto document = samples::shirt(blouseWearer().measurements, blouseWearer().body);
    QVERIFY(document);
    Simulation simulation = simulationOf({document->pattern, Shared<body::Body>(blouseWearer().body), document->scene});
    const SewReport report = sewn(simulation);
    QVERIFY2(report.worn->worn, reasonsOf(report).c_str());
    QVERIFY(report.atRest);
    QCOMPARE(openingsOf(report), (std::vector<std::string>{"left arm", "neck", "right arm", "torso"}));
    QCOMPARE(report.contact.selfIntersections, 0);
    QCOMPARE(report.contact.bodyIntersections, 0);
    QCOMPARE(report.contact.nodesInWrongOrder, 0);
    QVERIFY(report.contact.guarantee);

    QCOMPARE(simulation.tacks().size(), std::size_t(6));
    for (const TackState& button : simulation.tacks()) { // sewn to the left front, which lies behind the right one
        QVERIFY2(gapBetween(button, simulation.garment().particles, simulation.state().positions) < 1e-3,
                 button.name.c_str());
        const Vec3 way = wayBetween(button, simulation.garment().particles, simulation.state().positions);
        QVERIFY2(dot(way, rightSideAt(button.ends[0], simulation)) > 0, button.name.c_str());
    }
}

QTEST_APPLESS_MAIN(tst_Shirt)
#include "tst_Shirt.moc"
