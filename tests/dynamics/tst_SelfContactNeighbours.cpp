// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Statics.h"
#include "core/dynamics/Ways.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"
#include "tests/dynamics/LayeredCloth.h"

#include <QTest>
#include <random>
#include <set>

using namespace toile;
using namespace toile::layers;
using collision::ElementPair;
using dynamics::SelfContact;
using dynamics::SelfContactSettings;

namespace {

/// Two square sheets of 5 mm cells, one `gap` above the other.
Cloth twoSheets(int cells, double gap) {
    Cloth cloth;
    const double size = 0.005 * cells;
    append(cloth, size, cells, size, cells, 0.3, [](const Vec2& m) { return Vec3{m.x, 0, -m.y}; });
    append(cloth, size, cells, size, cells, 0.3, [=](const Vec2& m) {
        return Vec3{m.x + 0.0012, gap, -m.y - 0.0017}; // no edges lie on each other
    });
    return cloth;
}

/// The stage alone: one substep in which particles should go some way.
struct OneSubstep {
    explicit OneSubstep(const Cloth& c, SelfContactSettings settings = {})
        : cloth(c), inverseMass(c.model.mass.size()), previous(c.state.positions),
          contact(c.model, c.surface, settings) {
        for (std::size_t p = 0; p < inverseMass.size(); ++p) inverseMass[p] = 1 / c.model.mass[p];
    }
    /// Returns where it let them go in the substep of this number.
    std::vector<Vec3> go(std::vector<Vec3> positions, int number = 1) {
        constexpr double duration = frame / 20;
        return go(std::move(positions), number * duration, duration);
    }
    std::vector<Vec3> go(std::vector<Vec3> positions, double end, double duration) {
        contact.beginStep({previous, {}, end - duration}, frame);
        return goOn(std::move(positions), end, duration);
    }
    /// In the same step.
    std::vector<Vec3> goOn(std::vector<Vec3> positions, double end = frame / 20, double duration = frame / 20) {
        dynamics::Substep substep{positions, previous, inverseMass, duration, end};
        contact.project(substep);
        return positions;
    }

    const Cloth& cloth;
    std::vector<double> inverseMass;
    std::vector<Vec3> previous;
    SelfContact contact;
};

std::size_t pairsWhenOneFalls(const Cloth& cloth, double way) {
    OneSubstep substep(cloth);
    std::vector<Vec3> positions = cloth.state.positions;
    positions[positions.size() * 3 / 4].y -= way; // in the middle of the upper sheet
    const std::vector<Vec3> held = substep.go(positions);
    if (held[positions.size() * 3 / 4].y <= 0 || substep.contact.searches() != 1 || substep.contact.renewals() != 1)
        return 0;
    return substep.contact.nearPairs();
}

/// A sheet over a pinned one, falling.
Cloth fallingSheet(double speed) {
    Cloth cloth = sheetOverPinnedSheet(20, 10, 0.01);
    for (std::size_t p = cloth.model.pinned.size(); p < cloth.state.positions.size(); ++p)
        cloth.state.velocities[p] = {0.1 * speed, -speed, 0};
    return cloth;
}

/// Two sheets that cross along a line through the middle of both.
Cloth slopedThroughLevel() {
    Cloth cloth;
    append(cloth, 0.1, 10, 0.1, 10, 0.3, level(0));
    append(cloth, 0.1, 10, 0.1, 10, 0.3, [](const Vec2& m) {
        return Vec3{m.x - 0.05, 0.3 * (m.x - 0.05), 0.05 - m.y};
    });
    return cloth;
}

std::set<ElementPair> elementsOf(const std::vector<collision::SelfProximity::Near>& found) {
    std::set<ElementPair> pairs;
    for (const auto& near : found) pairs.insert(near.pair);
    return pairs;
}

} // namespace

/// Which pairs self-contact watches: as many as speeds ask for, where they do, and no more than there is room for.
class tst_SelfContactNeighbours : public QObject {
    Q_OBJECT
private slots:
    void aFastParticleBringsItsOwnNeighboursOnly();
    void shorterSubstepsAreForeseenForShort();
    void whoStraysIsSoughtAlone();
    void whoGoesToAndFroIsSoughtSeldom();
    void whoeverStraysLayersStayApart();
    void noPairIsMissedWhateverPartOfTheirWaysParticlesGo();
    void besideACrossingAllButWhatMustPassIsWatched();
    void besideACrossingWhoStraysIsSoughtAloneToo();
    void whatWasSoughtBeyondALayerIsHeldBeforeIt();
    void aStepThatIsRepeatedForgetsTheOneBefore();
    void withRoomForFewPairsLayersStayApart_data();
    void withRoomForFewPairsLayersStayApart();
    void withRoomForFewPairsWaysAreCut();
    void withRoomForNoneNothingMoves();
    void staticsWithRoomForFewPairsComesToTheSameRest();
};

/// 45 000 particles, of which one goes 40 mm in a substep.
void tst_SelfContactNeighbours::aFastParticleBringsItsOwnNeighboursOnly() {
    const Cloth cloth = twoSheets(149, 0.0015);
    QCOMPARE(cloth.model.particleCount(), 45000);
    const std::size_t slow = pairsWhenOneFalls(cloth, 0.005), fast = pairsWhenOneFalls(cloth, 0.04);
    qInfo("%zu pairs within reach when it goes 5 mm, %zu when it goes 40 mm", slow, fast);
    QVERIFY2(slow > 100000 && fast < slow + slow / 100, qPrintable(QString("%1 and %2 pairs").arg(slow).arg(fast)));
}

/// A list that held for two frame steps tells nothing of substeps in which cloth begins to move by 24 m/s.
void tst_SelfContactNeighbours::shorterSubstepsAreForeseenForShort() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(-1, 1);
    const Cloth cloth = twoSheets(20, 0.05);
    OneSubstep substep(cloth);
    substep.previous = substep.go(substep.previous, 1);
    substep.previous = substep.go(substep.previous, 40);
    std::vector<Vec3> moves(substep.previous.size());
    for (Vec3& move : moves) move = 0.0003 * Vec3{part(random), part(random), part(random)};
    constexpr double duration = frame / 80 / 16;
    for (int s = 1; substep.contact.searches() < 2; ++s) {
        QVERIFY(s < 20);
        std::vector<Vec3> wanted = substep.previous;
        for (std::size_t p = 0; p < wanted.size(); ++p) wanted[p] += moves[p];
        substep.previous = substep.go(wanted, 2 * frame + s * duration, duration);
    }
    const std::size_t pairs = substep.contact.nearPairs(); // 2.3 million where it looks ahead for a frame step
    QVERIFY2(pairs > 0 && pairs < 20000, qPrintable(QString("%1 pairs").arg(pairs)));
}

/// It is held where it would have been held by a search for all.
void tst_SelfContactNeighbours::whoStraysIsSoughtAlone() {
    const Cloth cloth = twoSheets(10, 0.004);
    const std::vector<Vec3>& still = cloth.state.positions;
    std::vector<Vec3> flung = still;
    const std::size_t one = flung.size() * 3 / 4; // in the middle of the upper sheet
    flung[one] += Vec3{0.003, -0.01, 0.002};
    OneSubstep watched(cloth), fresh(cloth);
    QVERIFY(watched.go(still) == still);
    QCOMPARE(watched.contact.searches(), 1);
    const std::vector<Vec3> held = watched.go(flung);
    QCOMPARE(watched.contact.searches(), 1);
    QVERIFY(watched.contact.renewals() > 0);
    QVERIFY(held[one].y > 0 && held[one].y < 0.004);
    QVERIFY(held == fresh.go(flung));
}

/// As what cloth draws to where layers push it back from: in each substep it begins where it was, and is on its way
/// again. The list is for a frame step.
void tst_SelfContactNeighbours::whoGoesToAndFroIsSoughtSeldom() {
    constexpr double before = frame / 4, duration = frame / 40;
    const Cloth cloth = twoSheets(10, 0.004);
    std::vector<Vec3> drawn = cloth.state.positions;
    drawn[drawn.size() * 3 / 4].y += 0.0009; // in the middle of the upper sheet, by more than the slack
    OneSubstep substep(cloth);
    substep.go(cloth.state.positions, before, before);
    for (int s = 1; s <= 20; ++s) substep.go(drawn, before + s * duration, duration);
    QCOMPARE(substep.contact.searches(), 1);
    const int renewals = substep.contact.renewals();
    QVERIFY2(renewals >= 2 && renewals <= 3, qPrintable(QString::number(renewals)));
}

/// Some are flung far, all others drift, for many substeps.
void tst_SelfContactNeighbours::whoeverStraysLayersStayApart() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(-1, 1);
    const auto somewhere = [&](double size) { return size * Vec3{part(random), part(random), part(random)}; };
    const Cloth cloth = twoSheets(20, 0.003);
    OneSubstep substep(cloth);
    collision::SelfProximity referee(cloth.surface.triangles, cloth.state.positions);
    std::vector<Vec3> velocities(cloth.state.positions.size());
    for (Vec3& v : velocities) v = somewhere(0.0001);
    for (int s = 1; s <= 60; ++s) {
        std::vector<Vec3> wanted = substep.previous;
        for (std::size_t p = 0; p < wanted.size(); ++p) wanted[p] += velocities[p];
        for (int k = 0; k < 2; ++k) wanted[random() % wanted.size()] += somewhere(0.01);
        substep.previous = substep.go(wanted, s);
        QVERIFY(referee.piercings(substep.previous).empty());
    }
    const SelfContact& contact = substep.contact;
    QVERIFY2(contact.renewals() > contact.searches() && contact.heldBack() == 0,
             qPrintable(QString("%1, %2 searches").arg(contact.renewals()).arg(contact.searches())));
}

void tst_SelfContactNeighbours::noPairIsMissedWhateverPartOfTheirWaysParticlesGo() {
    constexpr double reach = 0.001;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(0, 1);
        const auto somewhere = [&](double size) {
            return size * Vec3{2 * part(random) - 1, 2 * part(random) - 1, 2 * part(random) - 1};
        };
        Cloth cloth = twoSheets(5, 0.004);
        const int count = cloth.model.particleCount();
        for (int p = 1; p + 1 < count; p += 5) // every fifth hangs on its neighbours
            cloth.model.slaves.push_back({p, {{p - 1, 0.3}, {p + 1, 0.7}}});
        const auto placed = [&](std::vector<Vec3> x) {
            for (const cloth::Slave& slave : cloth.model.slaves) {
                x[slave.particle] = {};
                for (const auto& [master, weight] : slave.masters) x[slave.particle] += weight * x[master];
            }
            return x;
        };
        std::vector<Vec3> from = cloth.state.positions;
        for (Vec3& p : from) p += somewhere(0.002);
        from = placed(from);
        std::vector<Vec3> to = from;
        for (Vec3& p : to) p += somewhere(random() % 8 == 0 ? 0.02 : 0.001); // a few are fast
        to = placed(to);

        collision::SelfProximity proximity(cloth.surface.triangles, cloth.state.positions);
        const auto all = elementsOf(*proximity.pairsWithin(10, from));
        const auto found = elementsOf(*proximity.pairsInBoxes(reach, from, dynamics::waysOf(cloth.model, from, to)));
        std::set<ElementPair> meeting;
        for (int trial = 0; trial < 400; ++trial) {
            std::vector<Vec3> x(from.size());
            for (std::size_t p = 0; p < x.size(); ++p)
                x[p] = lerp(from[p], to[p], trial % 2 ? part(random) : static_cast<double>(random() % 2));
            x = placed(x);
            for (const ElementPair& pair : all)
                if (collision::separationOf(pair, x).distance <= reach) meeting.insert(pair);
        }
        QVERIFY(!meeting.empty() && std::ranges::includes(found, meeting));
        QVERIFY2(found.size() < all.size() / 2, qPrintable(QString("%1 of %2").arg(found.size()).arg(all.size())));
    }
}

void tst_SelfContactNeighbours::besideACrossingAllButWhatMustPassIsWatched() {
    constexpr std::size_t perCrossing = 5; // an edge with the sides of a triangle, its ends with the triangle
    const Cloth cloth = slopedThroughLevel();
    SelfContactSettings settings;
    settings.slackOfRoom = 1;
    OneSubstep substep(cloth, settings);
    QVERIFY(substep.go(cloth.state.positions).size() == cloth.state.positions.size());
    const auto crossings = static_cast<std::size_t>(substep.contact.crossings());
    collision::SelfProximity proximity(cloth.surface.triangles, cloth.state.positions);
    const std::size_t all = proximity.pairsWithin(2 * settings.slack + thickness, cloth.state.positions)->size(),
                      watched = substep.contact.nearPairs();
    QVERIFY2(crossings > 10 && watched < all && watched + perCrossing * crossings >= all,
             qPrintable(QString("%1 of %2 pairs, %3 crossings").arg(watched).arg(all).arg(crossings)));
}

/// It is held, and let through, as by a search for all.
void tst_SelfContactNeighbours::besideACrossingWhoStraysIsSoughtAloneToo() {
    const Cloth cloth = slopedThroughLevel();
    const std::vector<Vec3>& still = cloth.state.positions;
    const std::size_t first = still.size() / 2;                     // of the sloped sheet
    for (const std::size_t one : {first, first + 38, first + 49}) { // at a corner, near the line of the crossing, on it
        std::vector<Vec3> flung = still;
        flung[one] += Vec3{0.003, -0.01, 0.002};
        OneSubstep watched(cloth), fresh(cloth);
        QVERIFY(watched.go(still) != still); // the sheets are drawn apart
        QCOMPARE(watched.contact.searches(), 1);
        const std::vector<Vec3> held = watched.goOn(flung);
        QVERIFY(watched.contact.crossings() > 10 && watched.contact.renewals() > 0);
        QCOMPARE(watched.contact.searches(), 1);
        QVERIFY(held == fresh.go(flung));
    }
}

/// An explicit method may look at forces where a sheet has gone through another, and there seek neighbours, before it
/// is held on its way.
void tst_SelfContactNeighbours::whatWasSoughtBeyondALayerIsHeldBeforeIt() {
    const Cloth cloth = twoSheets(10, 0.001);
    SelfContact contact(cloth.model, cloth.surface, {.staticMove = 0.002, .staticMoveOfRoom = 1});
    const std::vector<Vec3>& from = cloth.state.positions;
    std::vector<Vec3> beyond = from;
    for (std::size_t p = from.size() / 2; p < from.size(); ++p) beyond[p].y = -0.002;
    contact.beginStep(cloth.state, frame);
    contact.fixFriction(from);
    contact.beginIteration(beyond);
    QCOMPARE(contact.searches(), 2);
    std::vector<Vec3> held = beyond;
    contact.hold(from, held);
    for (std::size_t p = from.size() / 2; p < from.size(); ++p) QVERIFY(held[p].y > 0);
}

/// A step that gained energy is taken back and made again: what was near at its end is not what is near at its start.
void tst_SelfContactNeighbours::aStepThatIsRepeatedForgetsTheOneBefore() {
    const auto stepped = [](bool twice) {
        Cloth cloth = fallingSheet(0); // by less than what is looked ahead
        SelfContact contact(cloth.model, cloth.surface, {});
        dynamics::Xpbd xpbd(cloth.model, {.damping = 5});
        std::array<dynamics::Stage*, 1> stages{&contact};
        const auto before = cloth.state;
        if (twice) {
            if (!xpbd.step(cloth.state, frame, 20, {0, -9.81, 0}, stages)) qFatal("it can be made");
            cloth.state = before;
        }
        if (!xpbd.step(cloth.state, frame, 40, {0, -9.81, 0}, stages)) qFatal("it can be made");
        return std::pair{cloth.state.positions, contact.searches()};
    };
    const auto [once, searches] = stepped(false);
    const auto [again, more] = stepped(true);
    QVERIFY(once == again);
    QVERIFY2(more >= 2 * searches, qPrintable(QString("%1, %2").arg(searches).arg(more)));
}

void tst_SelfContactNeighbours::withRoomForFewPairsLayersStayApart_data() {
    QTest::addColumn<double>("speed");
    for (const double speed : {0.0, 1.0, 10.0, 100.0}) QTest::addRow("%g m/s", speed) << speed;
}

void tst_SelfContactNeighbours::withRoomForFewPairsLayersStayApart() {
    QFETCH(double, speed);
    SelfContactSettings settings;
    settings.mostPairs = 1000; // 4400 come within the usual reach
    Cloth cloth = fallingSheet(speed);
    SelfContact contact(cloth.model, cloth.surface, settings);
    dynamics::Xpbd xpbd(cloth.model, {.damping = 5});
    std::array<dynamics::Stage*, 1> stages{&contact};
    for (int f = 0; f < 30; ++f) {
        QVERIFY(xpbd.step(cloth.state, frame, 20, {0, -9.81, 0}, stages));
        QVERIFY(contact.nearPairs() <= settings.mostPairs);
        QCOMPARE(cloth.intersections(), 0);
    }
    QVERIFY(contact.shortSearches() > 0);
    for (int p = static_cast<int>(cloth.model.pinned.size()); p < cloth.model.particleCount(); ++p)
        QVERIFY(cloth.state.positions[p].y > 0);
}

void tst_SelfContactNeighbours::withRoomForFewPairsWaysAreCut() {
    const Cloth cloth = twoSheets(20, 0.002);
    SelfContactSettings settings;
    settings.mostPairs = 16000; // 41 000 are within the usual reach before anything moves
    OneSubstep substep(cloth, settings);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> way(-0.04, 0.04);
    std::vector<Vec3> positions = cloth.state.positions; // each on a way of its own, through all others
    for (Vec3& p : positions) p += Vec3{way(random), way(random), way(random)};
    Cloth after = cloth;
    after.state.positions = substep.go(positions);
    QCOMPARE(substep.contact.heldBack(), 1);
    QVERIFY(substep.contact.nearPairs() <= settings.mostPairs);
    QVERIFY(after.state.positions != cloth.state.positions);
    QCOMPARE(after.intersections(), 0);
}

void tst_SelfContactNeighbours::withRoomForNoneNothingMoves() {
    const Cloth cloth = twoSheets(10, 0.0004); // nearer than they are thick
    SelfContactSettings settings;
    settings.mostPairs = 10;
    OneSubstep substep(cloth, settings);
    std::vector<Vec3> positions = cloth.state.positions;
    for (Vec3& p : positions) p.x += 0.001;
    QVERIFY(substep.go(positions) == cloth.state.positions);
    QCOMPARE(substep.contact.heldBack(), 1);
    QVERIFY(substep.contact.shortSearches() > 0);

    substep.contact.beginIteration(cloth.state.positions);
    QCOMPARE(substep.contact.energy(cloth.state.positions), 0.0);
    QCOMPARE(substep.contact.energy(positions), std::numeric_limits<double>::infinity());
}

void tst_SelfContactNeighbours::staticsWithRoomForFewPairsComesToTheSameRest() {
    Cloth cloth = fallingSheet(0);
    SelfContactSettings settings;
    settings.mostPairs = 3000; // 4400 come within the usual reach; moves that are much shorter are many
    SelfContact contact(cloth.model, cloth.surface, settings);
    dynamics::Stage* stages[]{&contact};
    const auto rest = dynamics::solveStatic(cloth.model, cloth.state, {0, -9.81, 0}, stages);
    QVERIFY(rest);
    QVERIFY2(rest->newton.converged, qPrintable(QString::number(rest->newton.residual)));
    QVERIFY(contact.shortSearches() > 0 && contact.nearPairs() <= settings.mostPairs);
    QCOMPARE(cloth.intersections(), 0);
    for (int p = static_cast<int>(cloth.model.pinned.size()); p < cloth.model.particleCount(); ++p)
        QVERIFY(cloth.state.positions[p].y > 0 && cloth.state.positions[p].y < thickness);
}

TOILE_TEST(tst_SelfContactNeighbours)
#include "tst_SelfContactNeighbours.moc"
