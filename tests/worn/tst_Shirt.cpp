// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "core/body/ArmLift.h"
#include "core/simulation/FrameTally.h"
#include "core/simulation/Wearing.h"
#include "samples/Shirt.h"
#include "tests/Suite.h"

#include <memory>
#include <numbers>
#include <set>

using namespace toile;
using namespace toile::simulation;
using geometry::distance;

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

int pieceCalled(const std::string& id, const Simulation& simulation) {
    const auto& pieces = simulation.scene().pattern.pieces;
    return static_cast<int>(std::ranges::find(pieces, id, [](const auto& p) { return p->id.value; }) - pieces.begin());
}

std::set<int> particlesOf(int piece, const Simulation& simulation) {
    std::set<int> particles;
    for (int node = 0; node < std::ssize(simulation.garment().mesh->pieces[piece].nodes); ++node)
        particles.insert(simulation.garment().particles.particle({piece, node}));
    return particles;
}

/// How a collar lies that is folded over its stand, away from the fold.
struct FoldedOver {
    double leastDrop = 1;   ///< below the fold, to the way to it in the flat [–]
    double meanOutside = 0; ///< how much farther from the middle of the neck than the fold, level [m]
    std::ptrdiff_t nodes = 0;
};

FoldedOver foldedOver(const Simulation& simulation) {
    constexpr double beside = 0.015; // [m]
    const int collar = pieceCalled("collar", simulation);
    const Garment& garment = simulation.garment();
    const std::vector<Vec3>& x = simulation.state().positions;
    std::set<int> stand = particlesOf(pieceCalled("stand-left", simulation), simulation);
    stand.merge(particlesOf(pieceCalled("stand-right", simulation), simulation));
    const std::vector<Vec2>& flat = garment.mesh->pieces[collar].nodes;
    const auto particle = [&](std::size_t node) {
        return garment.particles.particle({collar, static_cast<int>(node)});
    };
    Vec3 middle;
    for (const int p : stand) middle += x[p] / static_cast<double>(stand.size());
    const auto fromMiddle = [&](const Vec3& p) { return std::hypot(p.x - middle.x, p.z - middle.z); };
    FoldedOver lies;
    for (std::size_t node = 0; node < flat.size(); ++node) {
        double way = 1;
        int fold = -1;
        for (std::size_t other = 0; other < flat.size(); ++other)
            if (const double far = distance(flat[node], flat[other]); stand.contains(particle(other)) && far < way) {
                way = far;
                fold = particle(other);
            }
        if (way < beside) continue;
        const Vec3& at = x[particle(node)];
        ++lies.nodes;
        lies.leastDrop = std::min(lies.leastDrop, (x[fold].y - at.y) / way);
        lies.meanOutside += fromMiddle(at) - fromMiddle(x[fold]);
    }
    lies.meanOutside /= static_cast<double>(lies.nodes);
    return lies;
}

std::vector<Vec3> cuffsOf(const Simulation& simulation) {
    std::vector<Vec3> places;
    for (const char* cuff : {"cuff-left", "cuff-right"})
        for (const int p : particlesOf(pieceCalled(cuff, simulation), simulation))
            places.push_back(simulation.state().positions[p]);
    return places;
}

} // namespace

/// Fronts that lie one over the other and are buttoned: the sample shirt, from where its pieces are placed.
class tst_Shirt : public QObject {
    Q_OBJECT
private slots:
    void isWornWithRightOverLeftAndItsCollarTurnedDown();
    void isWornWhereLayersHoldASeamOpen();
    void noFrameShowsClothInTheBodyOrInItself();
    void liftedArmsDoNotComeThroughWhatIsCrumpledOnThem();
};

void tst_Shirt::isWornWithRightOverLeftAndItsCollarTurnedDown() {
    const auto document = samples::shirt(blouseWearer().measurements, blouseWearer().body);
    QVERIFY(document);
    Simulation simulation = simulationOf({document->pattern, Shared<body::Body>(blouseWearer().body), document->scene});
    static_cast<void>(sewn(simulation, {.seconds = 3.3})); // friction with the body has just come
    QCOMPARE(simulation.phase(), Phase::draping);
    const std::vector<Vec3> before = cuffsOf(simulation);
    static_cast<void>(sewn(simulation, {.seconds = 0.7}));
    const std::vector<Vec3> after = cuffsOf(simulation);
    for (std::size_t i = 0; i < before.size(); ++i) QVERIFY(distance(before[i], after[i]) < 0.001);

    const SewReport report = sewn(simulation);
    QVERIFY2(report.worn->worn, reasonsOf(report).c_str());
    QVERIFY(report.atRest);
    QCOMPARE(openingsOf(report), (std::vector<std::string>{"left arm", "neck", "right arm", "torso"}));
    QCOMPARE(report.contact.selfIntersections, 0);
    QCOMPARE(report.contact.bodyIntersections, 0);
    QCOMPARE(report.contact.nodesInWrongOrder, 0);
    QVERIFY(report.contact.guarantee);

    const FoldedOver collar = foldedOver(simulation);
    QVERIFY(collar.nodes > 50);
    QVERIFY(collar.leastDrop > 0.3);
    QVERIFY(collar.meanOutside > 0.005);

    QCOMPARE(simulation.tacks().size(), std::size_t(6));
    for (const TackState& button : simulation.tacks()) { // sewn to the left front, which lies behind the right one
        QVERIFY2(gapBetween(button, simulation.garment().particles, simulation.state().positions) < 1e-3,
                 button.name.c_str());
        const Vec3 way = wayBetween(button, simulation.garment().particles, simulation.state().positions);
        QVERIFY2(dot(way, rightSideAt(button.ends[0], simulation)) > 0, button.name.c_str());
    }
}

/// On a coarser mesh and with its collar 20 mm nearer the layers beside the collar's seam hold it open by some tenths
/// of a millimetre.
void tst_Shirt::isWornWhereLayersHoldASeamOpen() {
    const auto document = samples::shirt(blouseWearer().measurements, blouseWearer().body);
    QVERIFY(document);
    Scene scene{document->pattern, Shared<body::Body>(blouseWearer().body), document->scene};
    const auto at = std::ranges::find(scene.pattern.pieces, "collar", [](const auto& p) { return p->id.value; });
    pattern::Piece collar = **at;
    collar.placement->transform.origin.z += 0.02;
    *at = std::move(collar);
    auto simulation = Simulation::create(scene, {.spacing = 0.028});
    QVERIFY(simulation);
    const SewReport report = sewn(*simulation);
    QVERIFY2(report.worn->worn, reasonsOf(report).c_str());
    QCOMPARE(report.contact.selfIntersections, 0);
    QVERIFY(std::ranges::any_of(report.seams, [](const auto& seam) { return seam.state.gapAtMerge > 0.5e-3; }));
}

/// Not while it is sewn either, but for the sides of seams that close. Its collar's seam is the last, after 1.2 s.
void tst_Shirt::noFrameShowsClothInTheBodyOrInItself() {
    const auto document = samples::shirt(blouseWearer().measurements, blouseWearer().body);
    QVERIFY(document);
    Simulation simulation = simulationOf({document->pattern, Shared<body::Body>(blouseWearer().body), document->scene});
    FrameTally tally;
    const auto look = [&](const Simulation& now) { tally.add(now.state().time, intersectionsOf(now)); };
    QVERIFY(sew(simulation, {.seconds = 1.5}, {}, {}, look));
    QVERIFY(simulation.allSeamsMerged());
    QCOMPARE(tally.frames, 90);
    QVERIFY2(tally.withBody.frames == 0 && tally.withItself.frames == 0, describe(tally).c_str());
    QVERIFY(tally.atOpenSeams.last && *tally.atOpenSeams.last < 1.25);
}

/// The caps of the sleeves are jammed between shoulder and arm, layer on layer.
void tst_Shirt::liftedArmsDoNotComeThroughWhatIsCrumpledOnThem() {
    const auto document = samples::shirt(blouseWearer().measurements, blouseWearer().body);
    QVERIFY(document);
    Simulation simulation = simulationOf({document->pattern, Shared<body::Body>(blouseWearer().body), document->scene});
    static_cast<void>(sewn(simulation));
    auto lifted = body::armLift(blouseWearer().body, std::numbers::pi / 3, 1);
    QVERIFY(lifted);
    const SewSettings noLonger{.limit = 0.1, .finish = false};
    const auto report = wear(simulation, std::make_shared<geometry::VertexMotion>(std::move(*lifted)), noLonger);
    QVERIFY(report);
    QVERIFY(report->contact.outsideBody);
    QVERIFY(report->contact.bodyClearanceMinimum);
    QVERIFY2(*report->contact.bodyClearanceMinimum > 0.0025,
             qPrintable(QString::number(*report->contact.bodyClearanceMinimum)));
    QCOMPARE(report->contact.selfIntersections, 0);
}

TOILE_TEST(tst_Shirt)
#include "tst_Shirt.moc"
