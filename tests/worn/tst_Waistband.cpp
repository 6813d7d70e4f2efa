// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h" // first: moc 6.4 stumbles over <compare> as the first header
#include "tests/Suite.h"

#include "core/material/FabricPresets.h"
#include "core/simulation/HangsBy.h"
#include "core/simulation/Refine.h"
#include "samples/CircleSkirt.h"
#include "samples/GatheredSkirt.h"
#include "samples/SmallScenes.h"
#include "samples/Trousers.h"
#include "samples/Waistband.h"

using namespace toile;
using namespace toile::simulation;

namespace {

/// A tube that fits tightly round a post with or without shoulders below its upper opening.
Scene tubeRoundPost(double shoulderHeight) {
    const document::Document tube = samples::tubeRoundCylinder();
    body::Body post{"post", samples::cylinderMesh(), {}, {{body::Limb::torso, {{0, 1, 0}, {0, -0.2, 0}}}}};
    post.landmarks.acromionLeft.y = post.landmarks.acromionRight.y = shoulderHeight;
    return {tube.pattern, Shared<body::Body>(post), tube.scene};
}

constexpr double farAbove = 2, farBelow = 0; // [m]

Simulation sewnTube(double shoulderHeight) {
    Simulation tube = simulationOf(tubeRoundPost(shoulderHeight));
    while (!tube.allSeamsMerged())
        if (!tube.advance()) qFatal("the tube flew away");
    return tube;
}

} // namespace

/// A garment that only its waistband keeps up goes on after rest, and is judged then.
class tst_Waistband : public QObject {
    Q_OBJECT
private slots:
    void withoutANeckItGoesOnAfterRest();
    void theTimeCanBeChosen();
    void withANeckItEndsAtRest();
    void aRunOfSomeSecondsIsNotProlonged();
    void aTightBandDoesNotCreepRoundTheBody();
    void aSkirtInDeepFoldsIsPutOnRight();
    void gathersDoNotStretchTheBandTheyHangOn();
    void aTubeFallsFree();
    void whatHangsOnShouldersHangsByNoBand();
    void trousersHangByTheirWaistband();
    void trousersMadeFinerKeepTheirHold();
    void whatMadeFinerHangsByIsKept();
    void whatMovesHasItsOwnMass();
};

void tst_Waistband::withoutANeckItGoesOnAfterRest() {
    const SewReport report = sewn(tubeRoundPost(farAbove));
    QVERIFY(report.atRest);
    QVERIFY(std::abs(report.heldSeconds - 10) < 1e-6);
    QVERIFY(report.simulatedSeconds > 10);
    QVERIFY(report.worn->waistDrop);
}

void tst_Waistband::theTimeCanBeChosen() {
    const SewReport held = sewn(tubeRoundPost(farAbove), {.hold = 1}),
                    notHeld = sewn(tubeRoundPost(farAbove), {.hold = 0});
    QVERIFY(std::abs(held.heldSeconds - 1) < 1e-6);
    QCOMPARE(notHeld.heldSeconds, 0.0);
    QVERIFY(std::abs(held.simulatedSeconds - notHeld.simulatedSeconds - 1) < 1e-6); // it still rests, and waits no more
}

void tst_Waistband::withANeckItEndsAtRest() {
    const SewReport report = sewn(tubeRoundPost(farBelow));
    QVERIFY(report.atRest);
    QCOMPARE(report.heldSeconds, 0.0);
    QVERIFY(!report.worn->waistDrop);
}

void tst_Waistband::aRunOfSomeSecondsIsNotProlonged() {
    const SewReport report = sewn(tubeRoundPost(farAbove), {.seconds = 1});
    QCOMPARE(report.heldSeconds, 0.0);
    QVERIFY(std::abs(report.simulatedSeconds - 1) < 1e-9);
}

/// Hoop tension presses the band on with ten times the friction that its weight needs, and no force turns it.
void tst_Waistband::aTightBandDoesNotCreepRoundTheBody() {
    const material::Fabric fabric = samples::interlined(material::poplin());
    pattern::Pattern pattern;
    pattern.fabrics = {fabric};
    const pattern::Piece band =
        samples::draftWaistband(fabric, mannequin().body, {mannequin().measurements.waist, 0.035, 0.025}, 0.0175);
    pattern.pieces = {band};
    pattern.seams = {samples::waistbandSeam(band)};
    Scene scene = onMannequin(pattern);
    scene.settings.substeps = samples::waistbandSubsteps;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    const auto goOnTo = [&](double time) {
        while (simulation->state().time < time)
            if (!simulation->advance()) qFatal("the band flew away");
        return simulation->state().positions;
    };
    const std::vector<Vec3> before = goOnTo(5), after = goOnTo(7);
    QVERIFY(simulation->allSeamsMerged());
    double farthest = 0;
    for (std::size_t p = 0; p < before.size(); ++p) farthest = std::max(farthest, distance(before[p], after[p]));
    QVERIFY2(farthest < 0.0005, qPrintable(QString("%1 mm").arg(1000 * farthest)));
}

/// Coarse, and looked at before it rests: how it lies is right, how far it is stretched is not asked yet.
void tst_Waistband::aSkirtInDeepFoldsIsPutOnRight() {
    const document::Document skirt =
        samples::circleSkirt(mannequin().measurements, mannequin().body, {.spacing = 0.040});
    Scene scene = onMannequin(skirt.pattern);
    scene.settings = skirt.scene;
    const SewReport report = sewnFor(4, scene);
    QVERIFY(report.allClosed());
    for (const char* words :
         {"wrong side", "right side out", "is crossed", "No limb", "the level it was placed", "Left and right"})
        QVERIFY2(!says(report, words), reasonsOf(report).c_str());
    QCOMPARE(report.contact.selfIntersections, 0);
    QCOMPARE(report.worn->rightSideOut, 1.0);
    QVERIFY(report.worn->symmetryDifference); // of the waist, not of the hem
}

/// 1.17 m of cloth in 0.73 m of band. Were the gathers not drawn up, the band's edge would be 0.9 m long.
void tst_Waistband::gathersDoNotStretchTheBandTheyHangOn() {
    const document::Document skirt = samples::gatheredSkirt(mannequin().measurements, mannequin().body);
    Scene scene = onMannequin(skirt.pattern);
    scene.settings = skirt.scene;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    while (simulation->state().time < 3)
        if (!simulation->advance()) qFatal("the skirt flew away");
    QVERIFY(simulation->allSeamsMerged());
    const auto& garment = simulation->garment();
    double length = 0;
    for (const int seam : {2, 3}) {
        const auto& pairs = garment.mesh->seams[seam].pairs;
        for (std::size_t i = 1; i < pairs.size(); ++i)
            length += distance(simulation->state().positions[garment.particles.particle(pairs[i - 1][1])],
                               simulation->state().positions[garment.particles.particle(pairs[i][1])]);
    }
    const double band = mannequin().measurements.waist + samples::GatheredSkirtSettings{}.waistEase;
    QVERIFY2(std::abs(length / band - 1) < 0.03, qPrintable(QString("%1 m").arg(length)));
}

/// Two rims: it has no legs.
void tst_Waistband::aTubeFallsFree() {
    const Simulation tube = sewnTube(farAbove);
    QVERIFY(hangsOnItsWaistband(tube));
    QVERIFY(nodesItHangsBy(tube, tube).empty());
}

void tst_Waistband::whatHangsOnShouldersHangsByNoBand() {
    const Simulation coarse = sewnTube(farBelow);
    QVERIFY(!hangsOnItsWaistband(coarse));
    QVERIFY(nodesItHangsBy(coarse, coarse).empty());
}

namespace {

/// Trousers sewn at 40 mm, as they go on at 20.
struct MadeFiner {
    Scene scene;
    Simulation coarse, fine;
};

int bandOf(const Simulation& simulation) {
    const auto& pieces = simulation.scene().pattern.pieces;
    const auto band = std::ranges::find_if(pieces, [](const auto& piece) { return piece->id.value == "waistband"; });
    return static_cast<int>(band - pieces.begin());
}

/// Mean of its nodes [m].
double heightOfBand(const Simulation& simulation) {
    const ParticleMap& map = simulation.garment().particles;
    const int piece = bandOf(simulation);
    const auto nodes = static_cast<int>(simulation.garment().mesh->pieces[piece].nodes.size());
    double sum = 0;
    for (int node = 0; node < nodes; ++node) sum += simulation.state().positions[map.particle({piece, node})].y;
    return sum / nodes;
}

MadeFiner madeFiner(StiffBand stiff, int substeps = 60) {
    const auto trousers = samples::trousers(mannequin().measurements, mannequin().body, {.spacing = 0.040});
    if (!trousers) qFatal("%s", toString(trousers.error()).c_str());
    Scene scene = onMannequin(trousers->pattern);
    scene.settings = trousers->scene;
    scene.settings.selfContact = false;
    Simulation coarse = simulationOf(scene);
    static_cast<void>(sewn(coarse, {.hold = 0, .finish = false}));
    scene.settings.substeps = substeps;
    auto fine = Simulation::continued(scene, coarse, {.spacing = 0.02});
    if (!fine) qFatal("%s", toString(fine.error()).c_str());
    if (stiff == StiffBand::byInertia) fine->hangBy(nodesItHangsBy(coarse, *fine));
    return {scene, std::move(coarse), std::move(*fine)};
}

void goOnFor(Simulation& simulation, int frames) {
    for (int frame = 0; frame < frames; ++frame)
        if (!simulation.advance()) qFatal("the trousers flew away");
}

} // namespace

/// As far down as 40 mm and little farther: all of the band and the first rows of what is sewn to it.
void tst_Waistband::trousersHangByTheirWaistband() {
    const MadeFiner trousers = madeFiner(StiffBand::byInertia);
    const std::vector<int> nodes = nodesItHangsBy(trousers.coarse, trousers.fine);
    const std::vector<Vec3> places = trousers.fine.nodePositions();
    const auto piece = bandOf(trousers.fine);
    const ParticleMap& map = trousers.fine.garment().particles;
    const auto ofBand = static_cast<int>(trousers.fine.garment().mesh->pieces[piece].nodes.size());
    for (int node = 0; node < ofBand; ++node) QVERIFY(std::ranges::binary_search(nodes, map.node({piece, node})));
    for (const int node : nodes) {
        double toBand = std::numeric_limits<double>::infinity();
        for (int i = 0; i < ofBand; ++i)
            toBand = std::min(toBand, distance(places[node], places[map.node({piece, i})]));
        QVERIFY2(toBand < 0.015, qPrintable(QString("%1 mm").arg(1000 * toBand)));
    }
    QVERIFY(static_cast<int>(nodes.size()) > ofBand && nodes.size() < places.size() / 4);
}

void tst_Waistband::trousersMadeFinerKeepTheirHold() {
    MadeFiner held = madeFiner(StiffBand::byInertia), soft = madeFiner(StiffBand::bySubsteps);
    for (MadeFiner* trousers : {&held, &soft}) goOnFor(trousers->fine, 60);
    const double heldBy = heightOfBand(held.coarse) - heightOfBand(held.fine),
                 softBy = heightOfBand(soft.coarse) - heightOfBand(soft.fine);
    QVERIFY2(std::abs(heldBy) < 0.002, qPrintable(QString("%1 mm").arg(1000 * heldBy)));
    QVERIFY2(softBy > 0.01, qPrintable(QString("%1 mm").arg(1000 * softBy)));
}

void tst_Waistband::whatMadeFinerHangsByIsKept() {
    MadeFiner trousers = madeFiner(StiffBand::byInertia);
    goOnFor(trousers.fine, 5);
    Checkpoint point = trousers.fine.checkpoint();
    QVERIFY(!point.hangsBy.empty());
    auto resumed = Simulation::resumed(trousers.scene, {.spacing = 0.02}, point);
    QVERIFY2(resumed, resumed ? "" : toString(resumed.error()).c_str());
    goOnFor(trousers.fine, 3);
    goOnFor(*resumed, 3);
    QVERIFY(resumed->checkpoint() == trousers.fine.checkpoint());
    point.hangsBy.push_back(1 << 30);
    const auto refused = Simulation::resumed(trousers.scene, {.spacing = 0.02}, point);
    QVERIFY(!refused && toString(refused.error()).find("hangs by") != std::string::npos);
}

namespace {

bool namesSparedSubsteps(const Simulation& simulation) {
    return std::ranges::any_of(simulation.plan().leftOut(),
                               [](const LeftOut& part) { return part.stage == "substeps"; });
}

} // namespace

/// Hands and a body that moves would have to drag the inertia along.
void tst_Waistband::whatMovesHasItsOwnMass() {
    MadeFiner trousers = madeFiner(StiffBand::byInertia, 200);
    while (trousers.fine.phase() != Phase::draping) goOnFor(trousers.fine, 1);
    QVERIFY(!trousers.fine.checkpoint().hangsBy.empty());
    QVERIFY(namesSparedSubsteps(trousers.fine));
    const std::vector<Vec3>& vertices = (*trousers.scene.body)->mesh.vertices;
    QVERIFY(trousers.fine.moveBody(
        std::make_shared<const geometry::VertexMotion>(geometry::VertexMotion{1, {vertices, vertices}})));
    QVERIFY(trousers.fine.checkpoint().hangsBy.empty());
    QCOMPARE(trousers.fine.substeps(), trousers.scene.settings.substeps);
    QVERIFY(!namesSparedSubsteps(trousers.fine));

    trousers.fine.hangBy(nodesItHangsBy(trousers.coarse, trousers.fine));
    const auto& piece = trousers.fine.topology()->pieces[0];
    trousers.fine.hold({{.piece = piece.id, .material = {}, .target = {0, 1, 1}}});
    QVERIFY(trousers.fine.checkpoint().hangsBy.empty());
}

TOILE_TEST(tst_Waistband)
#include "tst_Waistband.moc"
