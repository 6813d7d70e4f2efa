// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Simulation.h"
#include "tests/Suite.h"

#include <QTest>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

/// What the program holds on the heap, counted by operators new and delete of this test.
struct Heap {
    long blocks = 0, bytes = 0;
};
std::atomic<long> liveBlocks{0}, liveBytes{0};

} // namespace

namespace {
/// Before each block stands how much was asked for: what malloc gives varies with what was freed before.
constexpr std::size_t header = alignof(std::max_align_t);
} // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    void* block = std::malloc(header + size);
    if (!block) return nullptr;
    *static_cast<std::size_t*>(block) = size;
    ++liveBlocks;
    liveBytes += static_cast<long>(size);
    return static_cast<char*>(block) + header;
}
void* operator new(std::size_t size) {
    void* block = operator new(size, std::nothrow);
    if (!block) throw std::bad_alloc();
    return block;
}
void operator delete(void* block) noexcept {
    if (!block) return;
    void* whole = static_cast<char*>(block) - header;
    --liveBlocks;
    liveBytes -= static_cast<long>(*static_cast<std::size_t*>(whole));
    std::free(whole);
}
void operator delete(void* block, std::size_t) noexcept {
    operator delete(block);
}

using namespace toile;
using namespace toile::simulation;

namespace {

Scene lonePiece(double spacing = 0.05) {
    Scene scene = twoSquares(spacing);
    scene.pattern.pieces.pop_back();
    scene.pattern.seams.clear();
    return scene;
}

/// What the simulation of a scene holds before its first step.
Heap heldBy(const Scene& scene) {
    (void)Simulation::create(scene); // what is made once and kept is there now
    const Heap before{liveBlocks, liveBytes};
    const auto simulation = Simulation::create(scene);
    if (!simulation) qFatal("%s", toString(simulation.error()).c_str());
    return {liveBlocks - before.blocks, liveBytes - before.bytes};
}

Scene withPressure(Scene scene) {
    pattern::Piece piece = *scene.pattern.pieces[0];
    piece.pressure = 1;
    scene.pattern.pieces[0] = piece;
    return scene;
}

StepPlan::StageCost only(const Scene& scene) {
    const auto simulation = Simulation::create(scene);
    const auto costs = simulation->plan().costs();
    return costs.size() == 1 ? costs.front() : StepPlan::StageCost{};
}

} // namespace

/// What is left out is no object and no byte: counted on the heap, not by what stages say of themselves.
class tst_LeftOut : public QObject {
    Q_OBJECT
private slots:
    void aLonePieceHasNoStageAndNoByteOfOne();
    void whatIsAddedBringsItsOneStage_data();
    void whatIsAddedBringsItsOneStage();
    void whatIsTakenAwayIsGoneToTheLastBlock();
    void whatIsAskedForAndNotNeededCostsNothing();
};

void tst_LeftOut::aLonePieceHasNoStageAndNoByteOfOne() {
    const auto simulation = Simulation::create(lonePiece());
    QVERIFY(simulation);
    QCOMPARE(simulation->plan().stages().size(), std::size_t(0));
    QCOMPARE(simulation->plan().costs().size(), std::size_t(0));
    QVERIFY(!simulation->plan().leftOut().empty());
}

void tst_LeftOut::whatIsAddedBringsItsOneStage_data() {
    QTest::addColumn<QString>("stage");
    for (const char* stage : {"seams", "body contact", "self-contact", "wind", "pressure", "strain damping"})
        QTest::newRow(stage) << stage;
}

void tst_LeftOut::whatIsAddedBringsItsOneStage() {
    QFETCH(QString, stage);
    Scene without = lonePiece();
    if (stage == "seams") {
        without = twoSquares(0.05);
        without.pattern.seams.clear();
    }
    Scene with = without;
    if (stage == "seams") with = twoSquares(0.05);
    if (stage == "body contact") with.body = Shared<body::Body>(box());
    if (stage == "self-contact") with.settings.selfContact = true;
    if (stage == "wind") with.settings.air = Air{};
    if (stage == "strain damping") with.settings.strainDamping = 0.01;
    if (stage == "pressure") with = withPressure(with);

    const StepPlan::StageCost cost = only(with);
    QCOMPARE(QString::fromStdString(cost.name), stage);
    QCOMPARE(only(without).name, std::string());
    const Heap more = heldBy(with), less = heldBy(without);
    QVERIFY(more.blocks > less.blocks);
    QVERIFY2(
        more.bytes - less.bytes >= static_cast<long>(cost.bytes),
        qPrintable(QString("%1 more on the heap, %2 by its own account").arg(more.bytes - less.bytes).arg(cost.bytes)));
}

void tst_LeftOut::whatIsTakenAwayIsGoneToTheLastBlock() {
    const Heap before = heldBy(lonePiece());
    Scene scene = lonePiece();
    scene.body = Shared<body::Body>(box());
    scene.settings.selfContact = true;
    QVERIFY(heldBy(scene).blocks > before.blocks);
    scene.body.reset();
    scene.settings.selfContact = false;
    const Heap after = heldBy(scene);
    QCOMPARE(after.blocks, before.blocks);
    QCOMPARE(after.bytes, before.bytes);
}

void tst_LeftOut::whatIsAskedForAndNotNeededCostsNothing() {
    Scene scene = lonePiece(0.4); // one cell, which cannot reach itself
    const Heap notAskedFor = heldBy(scene);
    scene.settings.selfContact = true;
    const Heap notNeeded = heldBy(scene);
    QCOMPARE(notNeeded.blocks, notAskedFor.blocks);
    QVERIFY(std::abs(notNeeded.bytes - notAskedFor.bytes) <= 32); // the reason is a longer sentence
}

TOILE_TEST(tst_LeftOut)
#include "tst_LeftOut.moc"
