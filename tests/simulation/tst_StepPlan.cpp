// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Simulation.h"
#include "tests/Suite.h"
#include "tests/dynamics/DenseSink.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;

namespace {

/// Writes down which of its functions were called.
class Recorder final : public dynamics::Stage {
public:
    explicit Recorder(std::vector<std::string>& calls) : calls_(calls) {}

    [[nodiscard]] std::string_view name() const override { return "recorder"; }
    [[nodiscard]] std::size_t bytes() const override { return called("bytes", std::size_t{0}); }
    [[nodiscard]] int heldBack() const override { return called("heldBack", 0); }
    void beginStep(const dynamics::ParticleState&, double) override { called("beginStep", 0); }
    void project(dynamics::Substep&) override { called("project", 0); }
    void take(const dynamics::Motion&) override { called("take", 0); }
    [[nodiscard]] bool isFromOutside() const override { return called("isFromOutside", true); }
    [[nodiscard]] bool isBeforeSweep() const override { return called("isBeforeSweep", false); }
    void fixFriction(std::span<const Vec3>) override { called("fixFriction", 0); }
    void easeFriction(double) override { called("easeFriction", 0); }
    void beginIteration(std::span<const Vec3>) override { called("beginIteration", 0); }
    [[nodiscard]] double energy(std::span<const Vec3>) const override { return called("energy", 1.0); }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override { called("addForces", 0); }
    void addHessian(std::span<const Vec3>, dynamics::HessianSink&) const override { called("addHessian", 0); }
    void hold(std::span<const Vec3>, std::span<Vec3>) override { called("hold", 0); }
    [[nodiscard]] double largestFrequencySquared() const override { return called("largestFrequencySquared", 1.0); }

private:
    template <class Value>
    Value called(const char* function, Value value) const {
        calls_.emplace_back(function);
        return value;
    }

    std::vector<std::string>& calls_;
};

} // namespace

/// What a scene does not need is neither built nor allocated, and is named with a reason.
class tst_StepPlan : public QObject {
    Q_OBJECT
private slots:
    void aLonePieceHasNoStage();
    void aSeamBringsExactlyItsStage();
    void aBodyBringsExactlyItsStage();
    void selfContactBringsExactlyItsStage();
    void airBringsExactlyItsStage();
    void pressureBringsExactlyItsStage();
    void airAndPressureWaitUntilTheGarmentIsSewn();
    void clothTooSmallToReachItselfHasNoSelfContact();
    void contactComesAfterTheSeamsAndSelfContactLast();
    void aSeamClosesThoughItsSidesAreNearEachOther();
    void aRegionBringsSlaves();
    void bendingAndTwistGoWithoutStiffness();
    void aMergedSeamLeavesAndSaysWhy();
    void everyCallReachesTheStage();
    void noTimeIsCountedOffTheClock();

private:
    static Scene lonePiece(double spacing = 0.05) {
        Scene scene = twoSquares(spacing);
        scene.pattern.pieces.pop_back();
        scene.pattern.seams.clear();
        return scene;
    }
    static std::vector<std::string> namesOf(const Simulation& simulation) {
        std::vector<std::string> names;
        for (const auto* stage : simulation.plan().stages()) names.emplace_back(stage->name());
        return names;
    }
    static std::string reasonFor(const Simulation& simulation, const std::string& stage) {
        const auto& left = simulation.plan().leftOut();
        const auto found = std::ranges::find(left, stage, &LeftOut::stage);
        return found == left.end() ? "" : found->why;
    }
};

void tst_StepPlan::aLonePieceHasNoStage() {
    const auto simulation = Simulation::create(lonePiece());
    QVERIFY(simulation);
    QVERIFY(simulation->plan().stages().empty());
    for (const char* stage : {"seams", "body contact", "seams that meet", "self-contact"}) {
        QVERIFY2(!reasonFor(*simulation, stage).empty(), stage);
        QVERIFY(simulation->plan().find(stage) == nullptr);
    }
    QVERIFY(simulation->garment().model.slaves.empty());
    QCOMPARE(simulation->garment().model.slaves.capacity(), std::size_t(0));
    QCOMPARE(simulation->garment().model.hinges.capacity(), std::size_t(0));
    QCOMPARE(simulation->garment().model.cells.capacity(), std::size_t(0));
}

void tst_StepPlan::aSeamBringsExactlyItsStage() {
    const auto simulation = Simulation::create(twoSquares(0.05));
    QVERIFY(simulation);
    QCOMPARE(namesOf(*simulation), std::vector<std::string>{"seams"});
    QVERIFY(simulation->plan().find("seams")->bytes() > 0);
    QVERIFY(reasonFor(*simulation, "seams").empty());
}

void tst_StepPlan::aBodyBringsExactlyItsStage() {
    Scene scene = lonePiece();
    scene.body = Shared<body::Body>(box());
    const auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    QCOMPARE(namesOf(*simulation), std::vector<std::string>{"body contact"});
    QVERIFY(simulation->plan().find("body contact")->bytes() > 0);
    QVERIFY(reasonFor(*simulation, "body contact").empty());
}

void tst_StepPlan::selfContactBringsExactlyItsStage() {
    Scene scene = lonePiece();
    scene.settings.selfContact = true;
    const auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    QCOMPARE(namesOf(*simulation), std::vector<std::string>{"self-contact"});
    QVERIFY(reasonFor(*simulation, "self-contact").empty());
    QCOMPARE(simulation->stageCosts().front().name, std::string("self-contact"));

    scene.settings.selfContact = false;
    const auto without = Simulation::create(scene);
    QVERIFY(without && without->plan().stages().empty());
    QCOMPARE(reasonFor(*without, "self-contact"), std::string("the scene does not ask for it"));
}

void tst_StepPlan::airBringsExactlyItsStage() {
    Scene scene = lonePiece();
    QCOMPARE(reasonFor(*Simulation::create(scene), "wind"), std::string("the scene has no air"));
    scene.settings.air = Air{};
    QCOMPARE(namesOf(*Simulation::create(scene)), std::vector<std::string>{"wind"});
    scene.settings.air->drag = 0;
    QVERIFY(namesOf(*Simulation::create(scene)).empty());
    QCOMPARE(reasonFor(*Simulation::create(scene), "wind"), std::string("its air does not drag"));
    scene.settings.air = Air{};
    scene.paper = true;
    QCOMPARE(reasonFor(*Simulation::create(scene), "wind"), std::string("the paper knows gravity alone"));
}

void tst_StepPlan::pressureBringsExactlyItsStage() {
    Scene scene = lonePiece();
    QCOMPARE(reasonFor(*Simulation::create(scene), "pressure"), std::string("no piece has any"));
    const int substeps = Simulation::create(scene)->substeps();
    pattern::Piece piece = *scene.pattern.pieces[0];
    piece.pressure = 50;
    scene.pattern.pieces[0] = piece;
    const auto simulation = Simulation::create(scene);
    QCOMPARE(namesOf(*simulation), std::vector<std::string>{"pressure"});
    QVERIFY(simulation->substeps() > 2 * substeps); // it loads cloth by more than 30 times its weight
}

void tst_StepPlan::airAndPressureWaitUntilTheGarmentIsSewn() {
    Scene scene = twoSquares(0.05);
    scene.settings.air = Air{};
    for (auto& shared : scene.pattern.pieces) {
        pattern::Piece piece = *shared;
        piece.pressure = 1;
        shared = piece;
    }
    auto simulation = Simulation::create(scene);
    QCOMPARE(namesOf(*simulation), std::vector<std::string>{"seams"});
    QCOMPARE(reasonFor(*simulation, "wind"), std::string("as gravity it waits until the garment is sewn"));
    while (simulation->phase() == Phase::sewing && simulation->state().time < 3) QVERIFY(simulation->advance());
    QCOMPARE(namesOf(*simulation), (std::vector<std::string>{"wind", "pressure"}));
}

void tst_StepPlan::clothTooSmallToReachItselfHasNoSelfContact() {
    Scene scene = lonePiece(0.4); // one cell
    scene.settings.selfContact = true;
    const auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    QVERIFY(simulation->plan().stages().empty());
    QCOMPARE(reasonFor(*simulation, "self-contact"), std::string("the cloth is too small to reach itself"));
}

void tst_StepPlan::contactComesAfterTheSeamsAndSelfContactLast() {
    Scene scene = twoSquares(0.05);
    scene.body = Shared<body::Body>(box());
    scene.settings.selfContact = true;
    const auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    QCOMPARE(namesOf(*simulation),
             (std::vector<std::string>{"seams", "body contact", "seams that meet", "self-contact"}));
}

void tst_StepPlan::aSeamClosesThoughItsSidesAreNearEachOther() {
    Scene scene = twoSquares(0.05);
    material::Fabric thick = *scene.pattern.fabrics[0];
    thick.thickness = 0.004; // eight times the gap at which a seam merges
    scene.pattern.fabrics[0] = thick;
    scene.settings.selfContact = true;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    while (!simulation->allSeamsMerged() && simulation->state().time < 3) QVERIFY(simulation->advance());
    QVERIFY(simulation->allSeamsMerged());
}

void tst_StepPlan::aRegionBringsSlaves() {
    Scene scene = lonePiece(0.02); // fine enough for coarse rectangles beside the joint
    pattern::Piece piece = *scene.pattern.pieces[0];
    piece.spacing = 0.02; // coarse main cells about the region, and not border strips alone
    pattern::Region region;
    region.id = pattern::RegionId("r");
    region.outline = {{-0.01, -0.01}, {0.1, -0.01}, {0.1, 0.21}, {-0.01, 0.21}};
    piece.regions.push_back(region);
    scene.pattern.pieces[0] = piece;
    const auto simulation = Simulation::create(scene);
    QVERIFY2(simulation, simulation ? "" : toString(simulation.error()).c_str());
    QVERIFY(!simulation->garment().model.slaves.empty());
    QVERIFY(reasonFor(*simulation, "slaves").empty());
    QVERIFY(simulation->plan().stages().empty());
}

void tst_StepPlan::bendingAndTwistGoWithoutStiffness() {
    Scene scene = lonePiece();
    material::Fabric fabric = *scene.pattern.fabrics[0];
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 0;
    scene.pattern.fabrics[0] = fabric;
    const auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    QCOMPARE(simulation->garment().model.bending.capacity(), std::size_t(0));
    QCOMPARE(simulation->garment().model.twist.capacity(), std::size_t(0));
    QCOMPARE(reasonFor(*simulation, "bending"), std::string("no bending stiffness"));
    QVERIFY(!reasonFor(*simulation, "twist").empty());
}

void tst_StepPlan::aMergedSeamLeavesAndSaysWhy() {
    auto simulation = Simulation::create(twoSquares(0.05));
    QVERIFY(simulation);
    while (!simulation->allSeamsMerged() && simulation->state().time < 3) QVERIFY(simulation->advance());
    QVERIFY(simulation->plan().stages().empty());
    QCOMPARE(reasonFor(*simulation, "seams"), std::string("all seams are merged"));
    QVERIFY(!simulation->garment().model.hinges.empty());
    QVERIFY(reasonFor(*simulation, "seam hinges").empty());
}

/// The plan measures its stages: none of their functions may end there.
void tst_StepPlan::everyCallReachesTheStage() {
    std::vector<std::string> calls;
    StepPlan plan;
    plan.add(std::make_unique<Recorder>(calls));
    dynamics::Stage& stage = *plan.stages().front();
    const auto reaches = [&](const char* function, const auto& call) {
        calls.clear();
        call();
        QCOMPARE(calls, std::vector<std::string>{function});
    };
    std::vector<Vec3> positions, forces;
    dynamics::Substep substep{};
    reaches("bytes", [&] { (void)stage.bytes(); });
    reaches("heldBack", [&] { (void)stage.heldBack(); });
    reaches("beginStep", [&] { stage.beginStep({}, 1); });
    reaches("project", [&] { stage.project(substep); });
    reaches("take", [&] { stage.take({}); });
    reaches("isFromOutside", [&] { QVERIFY(stage.isFromOutside()); });
    reaches("isBeforeSweep", [&] { QVERIFY(!stage.isBeforeSweep()); });
    reaches("fixFriction", [&] { stage.fixFriction(positions); });
    reaches("easeFriction", [&] { stage.easeFriction(0.5); });
    reaches("beginIteration", [&] { stage.beginIteration(positions); });
    reaches("energy", [&] { QCOMPARE(stage.energy(positions), 1.0); });
    reaches("addForces", [&] { stage.addForces(positions, forces); });
    fixtures::DenseSink hessian(0);
    reaches("addHessian", [&] { stage.addHessian(positions, hessian); });
    reaches("hold", [&] { stage.hold(positions, positions); });
    reaches("largestFrequencySquared", [&] { QCOMPARE(stage.largestFrequencySquared(), 1.0); });
}

/// What statics asks of stages is no part of what frame steps cost.
void tst_StepPlan::noTimeIsCountedOffTheClock() {
    std::vector<std::string> calls;
    StepPlan plan;
    plan.add(std::make_unique<Recorder>(calls));
    const auto seconds = [&] { return plan.costs().front().seconds; };
    {
        const StepPlan::OffTheClock offTheClock(plan);
        plan.stages().front()->fixFriction({});
    }
    QCOMPARE(calls.size(), std::size_t{1});
    QCOMPARE(seconds(), 0.0);
    plan.stages().front()->fixFriction({});
    QVERIFY(seconds() > 0);
}

TOILE_TEST(tst_StepPlan)
#include "tst_StepPlan.moc"
