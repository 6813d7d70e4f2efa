// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/dynamics/SelfContact.h"
#include "core/simulation/Inspect.h"
#include "core/simulation/MeetingPieces.h"
#include "core/simulation/Topology.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double side = 0.2, spacing = 0.02; // of a square [m]

/// A square in front of the observer whose left lower corner lies there, turned about its left side [rad].
Shared<pattern::Piece> square(const char* id, const Vec3& corner, double turn = 0) {
    pattern::Piece piece = polygonPiece(id, {{0, 0}, {side, 0}, {side, side}, {0, side}}, spacing);
    piece.placement = pattern::Placement{};
    piece.placement->transform = {
        {std::cos(turn), 0, -std::sin(turn)}, {0, 1, 0}, {std::sin(turn), 0, std::cos(turn)}, corner};
    return piece;
}

Scene twoPlaced(const Vec3& first, const Vec3& second, double turnOfSecond = 0) {
    Scene scene;
    scene.settings.gravity = {};
    scene.settings.selfContact = true;
    scene.pattern.fabrics.push_back(plainCloth());
    scene.pattern.pieces = {square("first", first), square("second", second, turnOfSecond)};
    return scene;
}

} // namespace

/// Pieces that are placed through each other.
class tst_MeetingPieces : public QObject {
    Q_OBJECT
private slots:
    void whoMeetsIsFound_data();
    void whoMeetsIsFound();
    void whatLiesInOnePlaneStartsApart();
    void whatLiesOnEachOtherFalls();
    void piecesThatOverlapAreSewnAndDrawnApart();
    void whatIsSewnPassesNoMore();
    void whoPassesIsKnownToWhatIsResumed();
};

void tst_MeetingPieces::whoMeetsIsFound_data() {
    QTest::addColumn<Vec3>("at");
    QTest::addColumn<double>("turn");
    QTest::addColumn<bool>("meet");
    QTest::newRow("apart") << Vec3{0.3, 0, 0} << 0.0 << false;
    QTest::newRow("one behind the other") << Vec3{0, 0, -0.01} << 0.0 << false;
    QTest::newRow("node to node along a side") << Vec3{side, 0, 0} << 0.0 << false;
    QTest::newRow("along a side, half a cell lower") << Vec3{side, -spacing / 2, 0} << 0.0 << true;
    QTest::newRow("overlapping in one plane") << Vec3{0.15, 0.03, 0} << 0.0 << true;
    QTest::newRow("in one place") << Vec3{} << 0.0 << true;
    QTest::newRow("through each other") << Vec3{0.1, 0.03, 0.05} << 1.0 << true;
}

void tst_MeetingPieces::whoMeetsIsFound() {
    QFETCH(Vec3, at);
    QFETCH(double, turn);
    QFETCH(bool, meet);
    const Scene scene = twoPlaced({}, at, turn);
    const meshing::GarmentMesh mesh = meshOf(scene.pattern);
    const std::vector<PiecePair> meeting = meetingPieces(mesh, placedNodes(scene.pattern, mesh));
    QVERIFY(meeting == (meet ? std::vector<PiecePair>{{0, 1}} : std::vector<PiecePair>{}));
}

/// The third lies on the second alone.
void tst_MeetingPieces::whatLiesInOnePlaneStartsApart() {
    Scene scene = twoPlaced({}, {0.15, 0, 0});
    scene.pattern.pieces.push_back(square("third", {0.3, 0, 0}));
    scene.pattern.pieces.push_back(square("fourth", {0.25, 0.1, 0}));
    scene.pattern.pieces.push_back(square("through", {0.1, 0.03, 0.05}, 1.0));
    const meshing::GarmentMesh mesh = meshOf(scene.pattern);
    const auto meeting = meetingPieces(mesh, placedNodes(scene.pattern, mesh));
    const pattern::Pattern apart = offEachOther(scene.pattern, meeting);
    const auto z = [&](int piece) { return apart.pieces[piece]->placement->transform.origin.z; };
    QCOMPARE(z(0), 0.0);
    QCOMPARE(z(1), 0.005);
    QCOMPARE(z(2), 0.0);  // beyond the second, which lies off it by now
    QCOMPARE(z(3), 0.01); // over both
    QVERIFY(*apart.pieces[4] == *scene.pattern.pieces[4]);
    const Scene clear = twoPlaced({}, {0.3, 0, 0});
    QVERIFY(offEachOther(clear.pattern, {}) == clear.pattern);
}

/// Two level squares that overlap in one plane and reach beyond the rim of a table hang down there.
void tst_MeetingPieces::whatLiesOnEachOtherFalls() {
    Scene scene = sheetOnTable();
    scene.settings.selfContact = true;
    pattern::Piece first = *scene.pattern.pieces[0];
    first.placement->transform.origin.x = 0.35; // as far on the table as beyond it
    pattern::Piece second = polygonPiece("second", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}, 0.03);
    second.placement = first.placement;
    second.placement->transform.origin += Vec3{0.035, 0, 0.08};
    scene.pattern.pieces = {first, second};
    Simulation simulation = simulationOf(scene);
    run(simulation, 60);
    for (const std::size_t piece : {0, 1}) {
        double lowest = 1;
        for (const Vec3& node : nodesOf(simulation, piece)) lowest = std::min(lowest, node.y);
        QVERIFY2(lowest < 0.45, qPrintable(QString::number(lowest)));
    }
    QCOMPARE(contactOf(simulation).selfIntersections, 0);
}

/// As the fronts of trousers at the crotch, drawn beside each other: the side that is sewn of each lies beyond that of
/// the other, and no way is known to part them.
void tst_MeetingPieces::piecesThatOverlapAreSewnAndDrawnApart() {
    Scene scene = twoPlaced({}, {0.15, 0, 0});
    scene.pattern.seams = {seamBetween("middle", "first", "e1", "second", "e3")};
    Simulation simulation = simulationOf(scene);
    const SewReport report = sewn(simulation);
    QVERIFY(simulation.allSeamsMerged() && report.atRest);
    QCOMPARE(report.contact.selfIntersections, 0);
}

/// Layers are not kept apart before the last seam is closed, and are from then on.
void tst_MeetingPieces::whatIsSewnPassesNoMore() {
    const auto guaranteed = [](const Simulation& simulation) {
        const auto* contact = dynamic_cast<const dynamics::SelfContact*>(simulation.plan().find("self-contact"));
        return contact && contact->guaranteed();
    };
    Scene scene = twoPlaced({}, {0.15, 0, 0});
    scene.pattern.seams = {seamBetween("middle", "first", "e1", "second", "e3")};
    Simulation simulation = simulationOf(scene);
    QVERIFY(simulation.meeting() == std::vector<PiecePair>({{0, 1}}) && !guaranteed(simulation));
    run(simulation, 60);
    QVERIFY(simulation.allSeamsMerged() && guaranteed(simulation));
}

/// While it is sewn, to the same bits.
void tst_MeetingPieces::whoPassesIsKnownToWhatIsResumed() {
    Scene scene = twoPlaced({}, {0.15, 0, 0});
    scene.pattern.seams = {seamBetween("middle", "first", "e1", "second", "e3")};
    scene.settings.seamTime = 0.6;
    Simulation goesOn = simulationOf(scene);
    run(goesOn, 5);
    const Checkpoint point = goesOn.checkpoint();
    auto resumed = Simulation::resumed(scene, {}, point);
    QVERIFY(resumed && goesOn.phase() == Phase::sewing && resumed->meeting() == goesOn.meeting());
    run(goesOn, 60);
    run(*resumed, 60);
    QVERIFY(goesOn.allSeamsMerged() && goesOn.nodePositions() == resumed->nodePositions());
}

TOILE_TEST(tst_MeetingPieces, QCoreApplication)
#include "tst_MeetingPieces.moc"
