// SPDX-License-Identifier: GPL-3.0-or-later
#include "PostScenes.h" // first: moc 6.4 stumbles over <compare> as the first header
#include "core/simulation/HangsBy.h"
#include "core/simulation/Refine.h"
#include "samples/GatheredSkirt.h"
#include "samples/Trousers.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::simulation;

namespace {

Simulation sewnTube(double shoulderHeight) {
    Simulation tube = simulationOf(tubeRoundPost(shoulderHeight));
    while (!tube.allSeamsMerged())
        if (!tube.advance()) qFatal("the tube flew away");
    return tube;
}

} // namespace

/// What a garment hangs by, and that it goes on hanging by it on a finer mesh.
class tst_MadeFiner : public QObject {
    Q_OBJECT
private slots:
    void aTubeHangsByItsUpperRim();
    void aClothThatIsAllHemHangsByNoBand();
    void whatHangsOnShouldersHangsByNoBand();
    void trousersHangByTheirWaistband();
    void whatIsMadeFinerKeepsItsHold_data();
    void whatIsMadeFinerKeepsItsHold();
    void freeFoldsOfAVeryFineMeshAreNotLeftSoft_data();
    void freeFoldsOfAVeryFineMeshAreNotLeftSoft();
    void whatMadeFinerHangsByIsKept();
    void whatMovesHasItsOwnMass();
};

void tst_MadeFiner::aTubeHangsByItsUpperRim() {
    const Simulation tube = sewnTube(farAbove);
    const std::vector<Vec3> places = tube.nodePositions();
    const double top = std::ranges::max(places, {}, &Vec3::y).y;
    const std::vector<int> nodes = nodesItHangsBy(tube, tube);
    for (std::size_t node = 0; node < places.size(); ++node) {
        const bool isHeld = std::ranges::binary_search(nodes, static_cast<int>(node));
        if (std::abs(top - 0.04 - places[node].y) > 0.005) QCOMPARE(isHeld, places[node].y > top - 0.04);
    }
}

/// The same cloth, not sewn.
void tst_MadeFiner::aClothThatIsAllHemHangsByNoBand() {
    Scene scene = tubeRoundPost(farAbove);
    scene.pattern.seams.clear();
    const Simulation cloth = simulationOf(scene);
    QVERIFY(hangsOnItsWaistband(cloth));
    QVERIFY(nodesItHangsBy(cloth, cloth).empty());
}

void tst_MadeFiner::whatHangsOnShouldersHangsByNoBand() {
    const Simulation coarse = sewnTube(farBelow);
    QVERIFY(!hangsOnItsWaistband(coarse));
    QVERIFY(nodesItHangsBy(coarse, coarse).empty());
}

namespace {

/// Sewn at 40 mm, as it goes on at 20.
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

document::Document coarseTrousers() {
    auto trousers = samples::trousers(mannequin().measurements, mannequin().body, {.spacing = 0.040});
    if (!trousers) qFatal("%s", toString(trousers.error()).c_str());
    return std::move(*trousers);
}

document::Document coarseSkirt() {
    return samples::gatheredSkirt(mannequin().measurements, mannequin().body, {.spacing = 0.040});
}

/// With a third opening: a hole of 80 × 40 mm in the middle of its front.
document::Document coarseSkirtWithAHole() {
    document::Document skirt = coarseSkirt();
    pattern::Piece front = *skirt.pattern.pieces[0];
    Vec2 middle;
    for (const pattern::Vertex& vertex : front.outline.vertices) middle += vertex.position;
    middle = middle / static_cast<double>(front.outline.vertices.size());
    const std::array corners{Vec2{-0.04, -0.02}, Vec2{-0.04, 0.02}, Vec2{0.04, 0.02}, Vec2{0.04, -0.02}}; // clockwise
    pattern::Contour hole;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::string name = std::to_string(k);
        hole.vertices.push_back({pattern::VertexId("hole " + name), middle + corners[k]});
        hole.edges.push_back({pattern::EdgeId("rim " + name), {}, {}});
    }
    front.holes = {hole};
    skirt.pattern.pieces[0] = std::move(front);
    return skirt;
}

MadeFiner madeFiner(const document::Document& garment, StiffBand stiff, int substeps = 60) {
    Scene scene = onMannequin(garment.pattern);
    scene.settings = garment.scene;
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
        if (!simulation.advance()) qFatal("the garment flew away");
}

} // namespace

/// As far down as 40 mm and little farther: all of the band and the first rows of what is sewn to it.
void tst_MadeFiner::trousersHangByTheirWaistband() {
    const MadeFiner trousers = madeFiner(coarseTrousers(), StiffBand::byInertia);
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

void tst_MadeFiner::whatIsMadeFinerKeepsItsHold_data() {
    QTest::addColumn<bool>("hasLegs");
    QTest::addColumn<double>("moves"); // its band, at most [m]
    QTest::newRow("trousers") << true << 0.002;
    QTest::newRow("gathered skirt") << false << 0.005; // up, where the waist is narrower
}

void tst_MadeFiner::whatIsMadeFinerKeepsItsHold() {
    QFETCH(bool, hasLegs);
    QFETCH(double, moves);
    const document::Document garment = hasLegs ? coarseTrousers() : coarseSkirt();
    MadeFiner held = madeFiner(garment, StiffBand::byInertia), soft = madeFiner(garment, StiffBand::bySubsteps);
    for (MadeFiner* made : {&held, &soft}) goOnFor(made->fine, 60);
    const double heldBy = heightOfBand(held.coarse) - heightOfBand(held.fine),
                 softBy = heightOfBand(soft.coarse) - heightOfBand(soft.fine);
    QVERIFY2(std::abs(heldBy) < moves, qPrintable(QString("%1 mm").arg(1000 * heldBy)));
    QVERIFY2(softBy > 0.01, qPrintable(QString("%1 mm").arg(1000 * softBy)));
}

void tst_MadeFiner::freeFoldsOfAVeryFineMeshAreNotLeftSoft_data() {
    QTest::addColumn<bool>("hasLegs");
    QTest::addColumn<bool>("hasHole");
    QTest::newRow("trousers") << true << false;
    QTest::newRow("gathered skirt") << false << false;
    QTest::newRow("gathered skirt with a hole") << false << true;
}

/// By more than two coarse levels: trousers have none.
void tst_MadeFiner::freeFoldsOfAVeryFineMeshAreNotLeftSoft() {
    QFETCH(bool, hasLegs);
    QFETCH(bool, hasHole);
    const document::Document garment = hasLegs ? coarseTrousers() : hasHole ? coarseSkirtWithAHole() : coarseSkirt();
    MadeFiner made = madeFiner(garment, StiffBand::byInertia, 0);
    auto veryFine = Simulation::continued(made.scene, made.coarse, {.spacing = 0.004});
    QVERIFY(veryFine);
    veryFine->hangBy(nodesItHangsBy(made.coarse, *veryFine));
    goOnFor(*veryFine, 1);
    QVERIFY(veryFine->allSeamsMerged());
    QCOMPARE(hangsInFreeFolds(*veryFine), !hasLegs);
    const int levels = hasLegs ? 3 : 2, full = veryFine->fullSubsteps();
    QCOMPARE(veryFine->substeps(), (full + (1 << levels) - 1) >> levels);
}

void tst_MadeFiner::whatMadeFinerHangsByIsKept() {
    MadeFiner trousers = madeFiner(coarseTrousers(), StiffBand::byInertia);
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
void tst_MadeFiner::whatMovesHasItsOwnMass() {
    MadeFiner trousers = madeFiner(coarseTrousers(), StiffBand::byInertia, 200);
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

TOILE_TEST(tst_MadeFiner)
#include "tst_MadeFiner.moc"
