// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/dynamics/Prolongation.h"
#include "core/simulation/LevelsOf.h"
#include "core/simulation/Simulation.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

using namespace toile;
using namespace toile::simulation;

/// The hierarchy above a garment: made of the same pattern, sewn alike, and only where a scene needs it.
class tst_LevelsOf : public QObject {
    Q_OBJECT
private slots:
    void levelsGrowWithTheSubstepsTheySpare() {
        const auto isCorrected = [](int substeps, int levels, int left) {
            const LevelPlan plan = levelPlanFor(substeps);
            QCOMPARE(plan.levels, levels);
            QCOMPARE(plan.substeps, left);
        };
        isCorrected(13, 0, 13);
        isCorrected(60, 0, 60);
        isCorrected(61, 1, 31);
        isCorrected(94, 2, 24); // the blouse at 10 mm
        isCorrected(120, 2, 30);
        isCorrected(138, 3, 28); // at 7 mm
        isCorrected(160, 3, 28); // at 6 mm
        isCorrected(200, 3, 25);
        isCorrected(300, 4, 28);                                   // at 3.2 mm
        QCOMPARE(levelPlanFor(138, {.oneMore = false}).levels, 2); // the third is too coarse for a piece
        QCOMPARE(levelPlanFor(138, {.oneMore = false}).substeps, 35);
    }

    void aRuleSaysHowManyAreSpared() {
        constexpr LevelRule rule{.bearable = 80, .fewest = 36, .oneMore = false}; // of trousers made finer
        const std::array<std::array<int, 3>, 5> expected{
            {{80, 0, 80}, {81, 1, 41}, {144, 2, 36}, {173, 2, 44}, {394, 3, 50}}};
        for (const auto& [substeps, levels, left] : expected) {
            QCOMPARE(levelPlanFor(substeps, rule).levels, levels);
            QCOMPARE(levelPlanFor(substeps, rule).substeps, left);
        }
        LevelRule ofSkirts = rule;
        ofSkirts.most = 2;
        QCOMPARE(levelPlanFor(345, ofSkirts).levels, 2);
        QCOMPARE(levelPlanFor(345, ofSkirts).substeps, 87);
    }

    void aStrapNarrowerThanTheirCellsHasNone() { // S34 of the stability suite
        Scene scene = twoSquares(0.02);
        scene.settings.gravity = {0, -9.81, 0};
        scene.pattern.seams.clear();
        scene.pattern.pieces = {polygonPiece("strap", {{0, 0}, {0.005, 0}, {0.005, 1}, {0, 1}}, 0.005)};
        auto simulation = Simulation::create(scene);
        QVERIFY(simulation);
        QVERIFY(simulation->advance()); // they would be made for it
        const auto& left = simulation->plan().leftOut();
        const auto why = std::ranges::find(left, "coarse levels", &LeftOut::stage);
        QVERIFY(why != left.end());
        QCOMPARE(why->why, std::string("a piece is narrower than their cells"));
    }

    void coarseMeshesAreSewnAsTheGarmentIs() {
        const Scene scene = twoSquares(0.02);
        const auto input = meshInputOf(scene.pattern);
        QVERIFY(input);
        const auto coarser = coarserMeshes(*input, 2);
        QVERIFY(coarser);
        QCOMPARE(coarser->size(), std::size_t(2));
        std::vector<int> particles;
        for (const auto& mesh : *coarser) {
            const auto apart = levelMeshOf(scene.pattern, mesh, {false}),
                       sewn = levelMeshOf(scene.pattern, mesh, {true});
            QVERIFY(sewn.particles < apart.particles);
            QCOMPARE(sewn.triangles.size(), apart.triangles.size());
            particles.push_back(sewn.particles);
        }
        QVERIFY(particles[1] * 2 < particles[0]);
    }

    /// The area of the cloth is that of the pieces on every level, and all mass arrives on it.
    void everyParticleHasItsPlaceOnTheCoarseLevel() {
        const Scene scene = twoSquares(0.02);
        const auto input = meshInputOf(scene.pattern);
        auto mesh = meshing::meshGarment(*input);
        QVERIFY(mesh);
        const auto coarser = coarserMeshes(*input, 1);
        const auto fine = levelMeshOf(scene.pattern, *mesh, {true}),
                   coarse = levelMeshOf(scene.pattern, coarser->front(), {true});
        const auto areaOfAll = [](const dynamics::LevelMesh& level) {
            double sum = 0;
            for (const auto& t : level.triangles) sum += areaOf(t);
            return sum;
        };
        QVERIFY(std::abs(areaOfAll(fine) - areaOfAll(coarse)) < 1e-9); // straight borders
        const auto carried = dynamics::prolongation(fine, coarse);
        for (int p = 0; p < fine.particles; ++p) {
            double sum = 0;
            for (const auto& term : carried.of(p)) sum += term.weight;
            QVERIFY(std::abs(sum - 1) < 1e-12);
        }
    }

    /// A mirror image has no regions of its own: its cloth is that of its source's.
    void aMirrorImageIsAsStiffAsItsSource() {
        pattern::Pattern pattern;
        pattern.fabrics.push_back(plainCloth());
        pattern::Piece left = polygonPiece("left", {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, 0.02);
        left.regions.push_back({.id = pattern::RegionId("box"),
                                .outline = {{0.04, 0.04}, {0.16, 0.04}, {0.16, 0.16}, {0.04, 0.16}},
                                .stiffness = {.stretch = 3}});
        pattern::Piece image;
        image.id = pattern::PieceId("right");
        image.fabric = left.fabric;
        image.mirror = pattern::MirrorOf{left.id};
        pattern.pieces = {Shared<pattern::Piece>(left), Shared<pattern::Piece>(image)};
        const auto input = meshInputOf(pattern);
        QVERIFY(input);
        const auto mesh = meshing::meshGarment(*input);
        QVERIFY(mesh);
        std::array<double, 2> warp{}, area{};
        for (const auto& t : levelMeshOf(pattern, *mesh, {}).triangles) {
            warp[t.patch] += areaOf(t) * t.warp;
            area[t.patch] += areaOf(t);
        }
        QVERIFY(warp[0] > 1.2 * area[0] * plainCloth().warpStiffness);
        QVERIFY(std::abs(warp[1] - warp[0]) < 1e-9 * warp[0]);
    }

    void aShortLineNeedsNone() {
        const auto simulation = Simulation::create(alone(0.05));
        QVERIFY(simulation);
        QVERIFY(reasonIn(*simulation).ends_with("substeps suffice"));
    }

    void whoSaysTheSubstepsGetsThem() {
        Scene scene = alone(0.005);
        scene.settings.substeps = 100;
        const auto simulation = Simulation::create(scene);
        QVERIFY(simulation);
        QCOMPARE(simulation->substeps(), 100);
        QCOMPARE(reasonIn(*simulation), std::string("the scene says how many substeps"));
    }

    void otherMethodsNeedNone() {
        auto simulation = Simulation::create(alone(0.005));
        QVERIFY(simulation);
        simulation->drapeWith(dynamics::Method::trBdf2);
        QCOMPARE(reasonIn(*simulation), std::string("no position-based steps"));
    }

    /// A sheet of 0.2 m at 4 mm hangs from two corners: by levels in a quarter of the substeps where it hangs without.
    void aFineSheetHangsInFewSubsteps() {
        const auto [few, many] = hungForASecond(hungByItsTop());
        QVERIFY(few && many);
        double apart = 0;
        for (std::size_t p = 0; p < few->state().positions.size(); ++p)
            apart = std::max(apart, geometry::distance(few->state().positions[p], many->state().positions[p]));
        QVERIFY2(apart < 0.002, qPrintable(QString::number(apart)));
    }

    void lookingForTheForcesMovesNothing() { // fine cloth is drawn taut before statics, but not to be looked at
        auto simulation = Simulation::create(hungByACorner());
        QVERIFY(simulation);
        for (int frame = 0; frame < 5; ++frame) QVERIFY(simulation->advance());
        const std::vector<Vec3> before = simulation->state().positions;
        const auto seen = simulation->settle({.maximumIterations = 0});
        QVERIFY(seen);
        QVERIFY(seen->newton.residual > 0.1); // it falls
        QVERIFY(simulation->state().positions == before);
        QVERIFY(simulation->settle({.maximumIterations = 1}));
        QVERIFY(simulation->state().positions != before);
    }

    /// Plans are made anew there in the middle of a frame step. This body is far off, and goes by a nanometre.
    void levelsHelpBesideABodyThatMovesAsWell() {
        Scene scene = hungByACorner();
        body::Body far = box();
        for (Vec3& v : far.mesh.vertices) v += Vec3{10, 0, 0};
        scene.body = Shared<body::Body>(far);
        const auto& there = far.mesh.vertices;
        geometry::VertexMotion motion{10, {there, there}};
        for (Vec3& v : motion.poses[1]) v.x += 1e-9;
        const auto withSubsteps = [&](int substeps) {
            Scene other = scene;
            other.settings.substeps = substeps;
            return Simulation::create(other);
        };
        auto still = Simulation::create(scene), moving = Simulation::create(scene);
        auto many = withSubsteps(176), without = withSubsteps(44);
        QVERIFY(still && moving && many && without);
        QVERIFY(moving->moveBody(std::make_shared<const geometry::VertexMotion>(std::move(motion))));
        for (auto* simulation : {&still, &moving, &many, &without})
            for (int frame = 0; frame < 5; ++frame) QVERIFY((*simulation)->advance());
        QCOMPARE(still->substeps(), 28);
        QCOMPARE(moving->substeps(), 44); // each plan's levels begin without a memory: there is none more
        const auto off = [&](const Simulation& by) {
            double most = 0;
            for (std::size_t p = 0; p < by.state().positions.size(); ++p)
                most = std::max(most, geometry::distance(by.state().positions[p], many->state().positions[p]));
            return most;
        };
        QVERIFY2(off(*moving) < 0.002, qPrintable(QString::number(off(*moving))));
        QVERIFY2(off(*still) < 0.005, qPrintable(QString::number(off(*still))));
        QVERIFY2(off(*without) > 0.01, qPrintable(QString::number(off(*without))));
    }

    void clothThatDoesNotRestGoesOnWithout() {
        auto simulation = Simulation::create(hungByACorner());
        QVERIFY(simulation);
        QCOMPARE(reasonIn(*simulation), std::string());
        const int few = simulation->substeps();
        while (simulation->state().time < 6.2) QVERIFY(simulation->advance());
        QCOMPARE(reasonIn(*simulation), std::string("only while a garment falls into its place"));
        QVERIFY(simulation->substeps() >= 2 * few);
    }

    /// Without levels it is stiffer, and what lay still would begin to move.
    void clothThatRestsByThemLiesOn() {
        Scene scene = hungByACorner();
        scene.settings.damping = 10;
        auto simulation = Simulation::create(scene);
        QVERIFY(simulation);
        while (!simulation->frame().atRest) QVERIFY(simulation->advance());
        QVERIFY(simulation->state().time < 5);
        double fastest = 0;
        while (simulation->state().time < 7) {
            QVERIFY(simulation->advance());
            fastest = std::max(fastest, simulation->largestSpeed());
        }
        QCOMPARE(reasonIn(*simulation), std::string());
        QVERIFY2(fastest < 0.005, qPrintable(QString::number(fastest)));
    }

    /// A band of less stiffness, no wider than a cell of the coarsest level, stretches by levels as it does without.
    void aSoftRegionIsSoftToThemAsWell() {
        Scene scene = hungByItsTop();
        pattern::Piece piece = *scene.pattern.pieces[0];
        piece.regions.push_back({.id = pattern::RegionId{"band"},
                                 .outline = {{-0.1, 0.112}, {0.3, 0.112}, {0.3, 0.128}, {-0.1, 0.128}},
                                 .refinement = 0,
                                 .stiffness = {.stretch = 0.002, .shear = 0.002}});
        scene.pattern.pieces[0] = piece;
        const auto [few, many] = hungForASecond(scene);
        QVERIFY(few && many);
        const auto hem = [](const Simulation& s) { return std::ranges::min(s.state().positions, {}, &Vec3::y).y; };
        QVERIFY2(hem(*many) < 0.997, qPrintable(QString::number(hem(*many)))); // 3 mm below the 1 m of a stiff sheet
        QVERIFY2(std::abs(hem(*few) - hem(*many)) < 0.0005, qPrintable(QString::number(hem(*few) - hem(*many))));
    }

private:
    /// By levels, and without them in four times the substeps; none if that cannot be.
    static std::array<std::optional<Simulation>, 2> hungForASecond(const Scene& scene) {
        auto few = Simulation::create(scene);
        if (!few || reasonIn(*few) != "") return {};
        Scene plain = scene;
        plain.settings.substeps = 4 * few->substeps();
        auto many = Simulation::create(plain);
        if (!many) return {};
        while (few->state().time < 1)
            if (!few->advance() || !many->advance()) return {};
        return {std::move(*few), std::move(*many)};
    }
    static Scene hungByItsTop() {
        Scene scene = alone(0.004);
        const auto& outline = scene.pattern.pieces[0]->outline;
        for (const std::size_t corner : {2, 3})
            scene.pattern.pins.push_back({.id = pattern::PinId{"pin " + std::to_string(corner)},
                                          .piece = scene.pattern.pieces[0]->id,
                                          .vertex = outline.vertices[corner].id});
        scene.settings.gravity = {0, -9.81, 0};
        scene.settings.damping = 10;
        return scene;
    }
    static Scene hungByACorner() {
        Scene scene = alone(0.02);
        scene.settings.gravity = {0, -9.81, 0};
        scene.settings.frameStep = 0.1; // many substeps of few particles
        scene.pattern.pins.push_back({.id = pattern::PinId{"pin"},
                                      .piece = scene.pattern.pieces[0]->id,
                                      .vertex = scene.pattern.pieces[0]->outline.vertices[2].id});
        return scene;
    }
    static Scene alone(double spacing) {
        Scene scene = twoSquares(spacing);
        scene.pattern.pieces.pop_back();
        scene.pattern.seams.clear();
        return scene;
    }
    static std::string reasonIn(const Simulation& simulation) {
        const auto& left = simulation.plan().leftOut();
        const auto found = std::ranges::find(left, "coarse levels", &LeftOut::stage);
        return found == left.end() ? "" : found->why;
    }
};

TOILE_TEST(tst_LevelsOf, QCoreApplication)
#include "tst_LevelsOf.moc"
