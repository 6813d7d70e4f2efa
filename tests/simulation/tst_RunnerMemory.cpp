// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunnerFixture.h"
#include "tests/Suite.h"

#include <QTest>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <thread>

namespace {

constexpr std::size_t anything = std::numeric_limits<std::size_t>::max();
/// What other threads than the test's get at a time.
std::atomic<std::size_t> mostBytes{anything};
const std::thread::id own = std::this_thread::get_id();

} // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    const bool isRefused = size > mostBytes && std::this_thread::get_id() != own;
    return isRefused ? nullptr : std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
    if (void* block = operator new(size, std::nothrow)) return block;
    throw std::bad_alloc();
}
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}

using namespace toile;
using namespace toile::simulation;

/// The simulation's thread where memory runs out.
class tst_RunnerMemory : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { mostBytes = anything; }
    void aFrameStepThatDoesNotFitIsToldAndTheNextSceneRuns();
    void aSceneThatDoesNotFitIsToldAndTheNextSceneRuns();
    void theGarmentBeforeASceneThatDoesNotFitIsKept();

private:
    static constexpr std::size_t little = 1000; ///< less than a scene's positions take [B]
};

namespace {

bool tellsOfMemory(const Frame& frame) {
    return frame.message.starts_with("There is not enough memory");
}

/// It never comes to rest.
Scene fallingSheet() {
    Scene scene = sheetOnTable();
    scene.body.reset();
    return scene;
}

/// The sheet falls, once there is enough.
void verifyItRuns(Runner& runner, std::uint64_t generation) {
    mostBytes = anything;
    runner.setScene(fallingSheet(), generation);
    runner.play();
    QVERIFY(waitForFrame(runner, [&](const Frame& frame) {
        return frame.generation == generation && frame.particles > 0 && frame.time > 0.05;
    }));
}

} // namespace

void tst_RunnerMemory::aFrameStepThatDoesNotFitIsToldAndTheNextSceneRuns() {
    Runner runner;
    verifyItRuns(runner, 1);
    mostBytes = little;
    const auto frame = waitForFrame(runner, tellsOfMemory);
    QVERIFY(frame);
    QCOMPARE(frame->particles, 0);
    QVERIFY(!runner.isPlaying());
    verifyItRuns(runner, 2);
}

void tst_RunnerMemory::aSceneThatDoesNotFitIsToldAndTheNextSceneRuns() {
    Runner runner;
    mostBytes = little;
    runner.setScene(fallingSheet(), 1);
    QVERIFY(waitForFrame(runner, tellsOfMemory));
    verifyItRuns(runner, 2);
}

void tst_RunnerMemory::theGarmentBeforeASceneThatDoesNotFitIsKept() {
    Runner runner;
    verifyItRuns(runner, 1);
    runner.pause();
    QTRY_VERIFY(!runner.isBusy());
    mostBytes = little;
    runner.setScene(fallingSheet(), 2);
    QVERIFY(waitForFrame(runner, tellsOfMemory));
    mostBytes = anything;
    runner.setScene(fallingSheet(), 3);
    const auto frame = waitForFrame(runner, [](const Frame& f) { return f.generation == 3 && f.particles > 0; });
    QVERIFY(frame);
    QVERIFY(frame->time > 0.05);
}

TOILE_TEST(tst_RunnerMemory, QCoreApplication)
#include "tst_RunnerMemory.moc"
