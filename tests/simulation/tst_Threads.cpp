// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Simulation.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace toile;
using namespace toile::simulation;

namespace {

/// Two sheets close above a table, a third of one over the other and both beyond its edge: in the first frame they fall
/// on it and on each other. Some 10 000 particles, so that the work of every stage is shared out.
Scene fallingSheets(material::FabricKind kind) {
    Scene scene;
    scene.body = Shared<body::Body>(box());
    scene.settings.selfContact = true;
    material::Fabric fabric = plainCloth();
    fabric.kind = kind;
    scene.pattern.fabrics.push_back(fabric);
    for (const bool isUpper : {false, true}) {
        pattern::Piece piece =
            polygonPiece(isUpper ? "upper" : "lower", {{0, 0}, {0.72, 0}, {0.72, 0.72}, {0, 0.72}}, 0.01);
        piece.placement = pattern::Placement{};
        const Vec3 corner = isUpper ? Vec3{-0.6, 0.5045, 0.4} : Vec3{-0.1, 0.5035, 0.4};
        piece.placement->transform = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, corner};
        scene.pattern.pieces.push_back(std::move(piece));
    }
    return scene;
}

std::vector<Vec3> after(int frames, const Scene& scene, std::shared_ptr<Team> team, Sharing sharing = Sharing::always) {
    auto simulation = Simulation::create(scene);
    if (!simulation) qFatal("%s", toString(simulation.error()).c_str());
    if (std::ranges::any_of(simulation->plan().leftOut(), [](const LeftOut& p) { return p.stage == "coarse levels"; }))
        qFatal("coarse levels are to be shared out as well");
    simulation->workWith(std::move(team), sharing);
    for (int frame = 0; frame < frames; ++frame)
        if (const auto done = simulation->advance(); !done) qFatal("%s", toString(done.error()).c_str());
    return simulation->state().positions;
}

/// Height of the uppermost particle within 20 mm of a vertical line [m].
double highestAbove(const std::vector<Vec3>& positions, const Vec2& place) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : positions)
        if (std::hypot(p.x - place.x, p.z - place.y) < 0.02) highest = std::max(highest, p.y);
    return highest;
}

} // namespace

/// A garment computed by several threads is the same to the bit as by one.
class tst_Threads : public QObject {
    Q_OBJECT
private slots:
    void severalGiveTheBitsOfOne_data() {
        QTest::addColumn<bool>("isKnit");
        QTest::newRow("springs") << false;
        QTest::newRow("membrane cells") << true;
    }
    void severalGiveTheBitsOfOne() {
        QFETCH(bool, isKnit);
        constexpr int frames = 1;
        Scene scene = fallingSheets(isKnit ? material::FabricKind::knit : material::FabricKind::woven);
        scene.settings.frameStep = 1.0 / 30; // in which free cloth falls by 5 mm
        const std::vector<Vec3> alone = after(frames, scene, nullptr);
        QVERIFY(alone.size() > 10000);                          // small cloth is not shared out
        QVERIFY(std::ranges::min(alone, {}, &Vec3::y).y < 0.5); // beyond the edge it falls
        QVERIFY(highestAbove(alone, {0, 0}) > 0.503);           // the table and the lower sheet hold the upper one
        for (const int members : {2, 3}) QVERIFY(after(frames, scene, std::make_shared<Team>(members)) == alone);
    }
    /// Two of four steps are tried with the team and two without.
    void turnsOfTheTeamGiveTheBitsOfOne() {
        constexpr int frames = 4;
        const Scene scene = fallingSheets(material::FabricKind::woven);
        QVERIFY(after(frames, scene, std::make_shared<Team>(2), Sharing::whereItPays) == after(frames, scene, nullptr));
    }
};

TOILE_TEST(tst_Threads)
#include "tst_Threads.moc"
