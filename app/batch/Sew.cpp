// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sew.h"
#include "app/batch/BodyMotion.h"
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/Outputs.h"
#include "app/batch/Pictures.h"
#include "app/batch/SewBegin.h"
#include "app/batch/SewSummary.h"
#include "app/batch/StudyFolder.h"
#include "core/base/AtomicFile.h"
#include "core/dynamics/Method.h"
#include "core/io/CheckpointFile.h"
#include "core/io/DocumentFile.h"
#include "core/io/DrapeExport.h"
#include "core/io/FrameFiles.h"
#include "core/simulation/Arrange.h"
#include "core/simulation/FrameTally.h"
#include "core/simulation/Inspect.h"
#include "core/simulation/Wearing.h"

#include <chrono>
#include <fmt/format.h>

namespace toile::batch {
namespace {

constexpr std::string_view staticMethod = "static"; ///< no motion after sewing, only the equilibrium

/// All that the run reads, but for the poses: their folder.
std::vector<std::string> inputsOf(const SewOptions& options, const document::Document& document) {
    std::vector<std::string> inputs{options.file, options.avatar, options.motion};
    if (!document.avatarFile.empty()) inputs.push_back(io::fileNamedBy(options.file, document.avatarFile).string());
    const bool goesOnInPlace = !options.checkpoint.empty() && areSameFile(options.resume, options.checkpoint);
    if (!goesOnInPlace) inputs.push_back(options.resume);
    return inputs;
}

/// What can be said before any work is done.
Result<void> checked(const SewOptions& options, const document::Document& document) {
    if (options.method == staticMethod && options.seconds)
        return fail(ErrorCode::invalidInput, "The method \"static\" knows no time: leave out --seconds.");
    std::vector<Output> outputs{{options.out, {".glb", ".obj", ".ply", ".stl"}},
                                {options.report},
                                {options.checkpoint},
                                {.file = options.frames, .holdsFrames = true}};
    for (const std::string& picture : options.pictures) outputs.push_back({picture, {".png"}});
    return checkedOutputs(outputs, inputsOf(options, document));
}

void applyOptions(OpenedScene& opened, const SewOptions& options) {
    simulation::Scene& scene = opened.scene;
    scene.settings.selfContact |= options.selfContact;
    scene.paper = options.paper;
    scene.memory = options.memory;
    if (options.step) scene.settings.frameStep = *options.step;
    if (options.arrange && scene.body) scene.pattern = simulation::startingClearOf(scene.pattern, **scene.body);
    for (const auto& piece : scene.pattern.pieces)
        if (!piece->placement)
            opened.warnings.push_back(
                {fmt::format("piece \"{}\"", piece->name), "It is not placed, and starts flat in the plane z = 0."});
}

/// What sewing came to, and what followed when the avatar moved.
struct Outcome {
    simulation::SewReport sewn;
    std::optional<simulation::WearingReport> wearing;
    std::optional<simulation::FrameTally> frames = {}; ///< that were kept
};

Json reportJson(const SewOptions& options, const OpenedScene& opened, const Outcome& outcome) {
    const int threads = Team(options.threads).members();
    const study::Circumstances circumstances = circumstancesOf({}); // after the run: to calibrate takes memory
    Json json;
    json.set("program", circumstances.program).set("machine", machineOf(circumstances));
    json.set("document", options.file).set("avatar", opened.avatar.empty() ? Json() : Json(opened.avatar));
    json.set("method", options.paper ? "paper" : options.method)
        .set("step", opened.scene.settings.frameStep)
        .set("threads", threads);
    const Json result = simulation::toJson(outcome.sewn);
    for (const auto& [key, value] : *result.asObject()) json.set(key, value);
    json.set("motion", outcome.wearing ? simulation::toJson(*outcome.wearing) : Json());
    return json.set("frames", outcome.frames ? simulation::toJson(*outcome.frames) : Json());
}

/// The scene's body as it stands at the end.
std::optional<Shared<body::Body>> bodyAtEnd(const OpenedScene& opened, const simulation::Simulation& simulation) {
    return simulation.movedBody() ? simulation.movedBody() : opened.scene.body;
}

Result<void> writeResults(const SewOptions& options, const OpenedScene& opened,
                          const simulation::Simulation& simulation, const Outcome& outcome) {
    const simulation::Frame frame = simulation.frame();
    if (!options.out.empty())
        if (auto written = io::writeDrape(options.out, *frame.topology, frame.positions); !written) return written;
    if (!options.report.empty())
        if (auto written = writeFileAtomically(options.report, toText(reportJson(options, opened, outcome))); !written)
            return written;
    if (options.pictures.empty()) return {};
    return writePictures(options.pictures, frame, bodyAtEnd(opened, simulation)); // last: not every machine can draw
}

using Motion = std::shared_ptr<const geometry::VertexMotion>; ///< of the avatar; null = it stands still

/// Sews, and moves the avatar if that is wanted.
Result<Outcome> sewn(const SewOptions& options, const Motion& motion, const simulation::SewSettings& settings,
                     simulation::Simulation& simulation, std::stop_token stop,
                     const simulation::FrameObserver& observer) {
    ProgressBar bar(options.quiet);
    auto report = simulation::sew(simulation, settings, stop, bar.progress(), observer);
    if (!report) return tl::unexpected(report.error());
    Outcome outcome{std::move(*report), std::nullopt};
    if (!motion || outcome.sewn.ranOutOfTime()) return outcome;
    auto wearing = simulation::wear(simulation, motion, settings, stop, bar.progress(), observer);
    if (!wearing) return tl::unexpected(wearing.error());
    outcome.wearing = std::move(*wearing);
    return outcome;
}

/// The same, and keeps the start and every frame step if that is wanted.
Result<Outcome> sewnAndKept(const SewOptions& options, const Motion& motion, const simulation::SewSettings& settings,
                            simulation::Simulation& simulation, std::stop_token stop) {
    if (options.frames.empty()) return sewn(options, motion, settings, simulation, stop, {});
    auto files = io::FrameFiles::create(options.frames, simulation.frame().topology);
    if (!files) return tl::unexpected(files.error());
    Result<void> kept;
    simulation::FrameTally tally;
    const auto keep = [&](const simulation::Simulation& now) {
        if (kept) kept = (*files)->add(now.nodePositions());
        tally.add(now.state().time, simulation::intersectionsOf(now));
    };
    keep(simulation);
    auto outcome = sewn(options, motion, settings, simulation, stop, keep);
    if (outcome && kept) kept = (*files)->finish();
    if (!kept) return tl::unexpected(kept.error());
    if (outcome) outcome->frames = tally;
    return outcome;
}

/// Reading and meshing count as well.
std::optional<std::chrono::steady_clock::time_point> deadlineAfter(const std::optional<double>& seconds) {
    if (!seconds) return std::nullopt;
    return std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(*seconds));
}

Result<void> keepStanding(const std::string& checkpoint, simulation::Simulation& simulation) {
    return checkpoint.empty() ? Result<void>() : io::writeCheckpoint(simulation.checkpoint(), checkpoint);
}

} // namespace

const std::vector<std::string>& sewMethods() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{std::string(staticMethod)};
        for (const dynamics::Method method : dynamics::allMethods()) all.emplace_back(dynamics::nameOf(method));
        return all;
    }();
    return names;
}

int sew(const SewOptions& options, std::stop_token stop) {
    const auto deadline = deadlineAfter(options.timeLimit);
    const auto refuse = [&options](const Error& error) {
        printError(io::locatedIn(options.file, error));
        return static_cast<int>(inputWrong);
    };
    auto document = io::readDocument(options.file);
    if (!document) return refuse(document.error());
    if (const auto sound = checked(options, document->document); !sound) return refuse(sound.error());
    auto opened = openScene(document->document, options.file, options.avatar);
    if (!opened) return refuse(opened.error());
    applyOptions(*opened, options);
    const auto motion = bodyMotionOf(options, *opened); // sewing takes long: what is wrong with it is told before
    if (!motion) return refuse(motion.error());
    simulation::SewSettings settings{
        .seconds = options.seconds, .limit = options.limit, .hold = options.hold, .deadline = deadline};
    auto begin = begun(options, *opened, settings, stop);
    if (!begin) return refuse(begin.error());
    auto& [simulation, coarse] = *begin;

    if (coarse) settings = settingsAfter(*coarse, settings);
    auto outcome = sewnAndKept(options, *motion, settings, simulation, stop);
    if (const auto kept = keepStanding(options.checkpoint, simulation); !kept) return refuse(kept.error());
    if (!outcome) return refuse(outcome.error());
    simulation::SewReport& report = outcome->sewn;
    if (coarse) count(*coarse, report);
    report.warnings.insert(report.warnings.begin(), opened->warnings.begin(), opened->warnings.end());
    printSummary(report, options);
    if (outcome->wearing) printWearing(*outcome->wearing);
    if (outcome->frames) fmt::print("{}\n", simulation::describe(*outcome->frames));
    if (const auto written = writeResults(options, *opened, simulation, *outcome); !written)
        return refuse(written.error());
    const bool wornWell = !outcome->wearing || outcome->wearing->reachedItsGoal();
    return report.reachedItsGoal(settings) && wornWell ? done : goalMissed;
}

} // namespace toile::batch
