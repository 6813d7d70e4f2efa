// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/dynamics/SelfContact.h"
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
    void piecesThatOverlapAreSewnAndDrawnApart();
    void whatIsSewnPassesNoMore();
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

TOILE_TEST(tst_MeetingPieces, QCoreApplication)
#include "tst_MeetingPieces.moc"
