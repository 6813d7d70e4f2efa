// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Runner.h"

#include "core/base/Mailbox.h"
#include "core/base/WallTime.h"
#include "core/simulation/Glide.h"
#include "core/simulation/Simulation.h"
#include "core/simulation/Warnings.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <thread>

namespace toile::simulation {
namespace {

struct Order {
    Scene scene;
    std::uint64_t generation = 0;
};

/// Told to play, a garment at rest goes on at least this long before it rests again: it may creep [s].
constexpr double atLeast = 0.5;

/// How often statics is tried where it does not come to its end: a fold still snaps through, and time goes on between.
constexpr int finishAttempts = 4;

constexpr const char* noMemory = "There is not enough memory to simulate this garment: choose a larger spacing.";

/// By the clock: a garment that takes longer to fall into place anew is seen on its way [s].
constexpr double longestUnseen = 2;

/// Words alone, where there are some: who works in a window knows no paths of a file.
std::string toldOf(Error error) {
    if (!error.place.object.empty()) error.place.path.clear();
    return toString(error);
}

} // namespace

/// Everything above the line is touched by both threads, everything below by the worker's alone.
class Runner::Worker {
public:
    Worker() : thread_([this](std::stop_token stop) { run(stop); }) {}
    ~Worker() {
        thread_.request_stop();
        cutOff();
    }

    void order(Order order) {
        orders_.put(std::move(order));
        wake();
    }
    void play() {
        playing_ = pushed_ = true;
        wake();
    }
    void pause() {
        stopPlaying();
        cutOff();
    }
    void requestStep() {
        stopPlaying();
        ++steps_;
        wake();
    }
    void finishAtRest(bool wanted) {
        finishWanted_ = wanted;
        wake();
    }
    void drapeWith(dynamics::Method method) {
        method_ = method;
        wake();
    }
    void hold(std::vector<Grip> grips) {
        grips_.put(std::move(grips));
        wake();
    }
    void moveBody(std::shared_ptr<const geometry::VertexMotion> motion) {
        motions_.put(std::move(motion));
        playsWithBody_ = true;
        wake();
    }
    void requestReset() {
        stopPlaying();
        reset_ = true;
        cutOff();
    }
    void askForCheckpoint() {
        asked_ = true;
        wake();
    }
    void resume(Checkpoint checkpoint) {
        stopPlaying();
        resumed_.put(std::move(checkpoint));
        cutOff();
    }
    [[nodiscard]] std::optional<Result<Checkpoint>> takeCheckpoint() { return checkpoints_.take(); }
    [[nodiscard]] bool isPlaying() const { return playing_; }
    [[nodiscard]] bool isBusy() const { return idleSince_ != signal_; }
    [[nodiscard]] std::optional<Frame> takeFrame() { return frames_.take(); }

private:
    void stopPlaying() { playing_ = playsWithBody_ = false; }
    void wake() {
        ++signal_;
        signal_.notify_one();
        const std::lock_guard lock(stopping_);
        stopFinish_.request_stop();
    }
    /// For what would throw a frame step away, or need not wait for it.
    void cutOff() {
        ++cuts_;
        wake();
        const std::lock_guard lock(stopping_);
        stopStep_.request_stop();
    }

    // -- shared
    Mailbox<Order> orders_;
    Mailbox<Frame> frames_;
    Mailbox<std::vector<Grip>> grips_;
    Mailbox<std::shared_ptr<const geometry::VertexMotion>> motions_;
    Mailbox<Checkpoint> resumed_;
    Mailbox<Result<Checkpoint>> checkpoints_;
    std::atomic<bool> playing_{false}, reset_{false};
    std::atomic<bool> asked_{false};         ///< for a checkpoint
    std::atomic<bool> pushed_{false};        ///< play was ordered and not seen yet
    std::atomic<bool> playsWithBody_{false}; ///< time will run if the body may move as it was ordered
    std::atomic<bool> finishWanted_{false};
    std::atomic<dynamics::Method> method_{dynamics::Method::xpbd};
    std::atomic<int> steps_{0};
    std::atomic<std::uint64_t> signal_{1};    ///< counts orders
    std::atomic<std::uint64_t> cuts_{0};      ///< counts those that cut a frame step off
    std::atomic<std::uint64_t> idleSince_{0}; ///< the order after which there was nothing left to do
    std::mutex stopping_;                     ///< held for a moment, to look at the next two
    std::stop_source stopFinish_;             ///< of the statics under way
    std::stop_source stopStep_;               ///< of the frame step under way

    // -- the worker's
    void run(std::stop_token stop) {
        while (!stop.stop_requested()) {
            try {
                serve(stop);
            } catch (const std::bad_alloc&) {
                giveUp();
            }
        }
    }

    void serve(std::stop_token stop) {
        for (;;) {
            // Read in this order, so that a scene handed over before play was pressed is taken over before it plays,
            // and who stops the thread wakes it afterwards.
            const std::uint64_t seen = signal_, cutsSeen = cuts_;
            if (stop.stop_requested()) return;
            const bool pushed = pushed_.exchange(false), mayPlay = playing_, mayStep = steps_ > 0;
            if (auto order = orders_.take()) accept(std::move(*order));
            if (reset_.exchange(false)) restart();
            if (auto checkpoint = resumed_.take()) goOnFrom(*checkpoint);
            if (asked_.exchange(false)) tellWhereItStands();
            if (auto grips = grips_.take()) take(std::move(*grips));
            takeMethod();
            if (auto motion = motions_.take()) take(std::move(*motion));
            if ((pushed || mayStep) && !broken_.empty()) stopWith(broken_);
            if (pushed && stands()) playUntil_ = simulation_->state().time + atLeast;
            if (mayStep) {
                if (advance(seen, cutsSeen)) --steps_;
            } else if (mayPlay && playing_ && stands() && !rests()) {
                advance(seen, cutsSeen);
            } else if (mayPlay && playing_ && mayFinish()) {
                finish(seen);
            } else {
                idleSince_ = seen;
                signal_.wait(seen); // returns at once when something was ordered meanwhile
            }
        }
    }

    /// Whatever was being done, the simulation may have been left half changed. The pattern is not touched by it.
    void giveUp() {
        simulation_.reset();
        broken_ = noMemory;
        steps_ = 0;
        stopWith(broken_);
    }

    /// A garment at rest costs nothing: the thread sleeps, and what is playing stays playing, for the next edit.
    [[nodiscard]] bool rests() const { return resting_ && simulation_->state().time >= playUntil_; }

    [[nodiscard]] bool stands() const { return simulation_ && broken_.empty(); }

    void accept(Order order) {
        scene_ = std::move(order.scene);
        generation_ = order.generation;
        adopt(built([&] {
            return simulation_ && simulation_->steps() > 0
                       ? Simulation::continued(scene_, *simulation_, {}, GoesOn::asSewn)
                       : Simulation::create(scene_);
        }));
    }

    /// A hand that moves wakes a garment at rest.
    void take(std::vector<Grip> grips) {
        held_ = std::move(grips);
        if (!stands()) return;
        simulation_->hold(held_);
        attempts_ = 0;
        playUntil_ = simulation_->state().time + atLeast;
    }

    /// Whatever simulation it is: a new one drapes by XPBD.
    void takeMethod() {
        const dynamics::Method wanted = method_;
        if (!stands() || simulation_->bodyMoves() || simulation_->drapingMethod() == wanted) return;
        simulation_->drapeWith(wanted);
        attempts_ = 0;
        finish_ = Finish::none;
        playUntil_ = simulation_->state().time + atLeast;
    }

    void take(std::shared_ptr<const geometry::VertexMotion> motion) {
        const auto moved = stands() ? simulation_->moveBody(std::move(motion))
                                    : fail(ErrorCode::invalidInput, "There is no garment on a body that could move.");
        if (!moved) {
            playsWithBody_ = false;
            return publish(moved.error().text);
        }
        resting_ = false;
        finish_ = Finish::none;
        attempts_ = 0;
        if (!playsWithBody_.exchange(false)) return; // paused meanwhile
        playing_ = true;
        ++signal_;
    }

    void restart() {
        simulation_.reset();
        held_.clear();
        if (generation_ > 0) adopt(built([&] { return Simulation::create(scene_); }));
    }

    void goOnFrom(const Checkpoint& checkpoint) {
        auto resumed = built([&] { return Simulation::resumed(scene_, {}, checkpoint); });
        if (!resumed) return stopWith(toldOf(resumed.error()));
        adopt(std::move(resumed));
    }

    void tellWhereItStands() {
        if (stands() && simulation_->movedBody())
            checkpoints_.put(fail(ErrorCode::invalidInput,
                                  "The avatar has moved; a checkpoint knows it only as it stood at first."));
        else if (stands()) checkpoints_.put(simulation_->checkpoint());
        else checkpoints_.put(fail(ErrorCode::invalidInput, "There is no garment that could be simulated."));
    }

    /// What make() makes; an error where memory runs out.
    [[nodiscard]] static Result<Simulation> built(const auto& make) {
        try {
            return make();
        } catch (const std::bad_alloc&) {
            return fail(ErrorCode::tooLarge, noMemory);
        }
    }

    /// A scene that cannot be built stands still; the garment before it is kept, and goes on when the next one can.
    void adopt(Result<Simulation> made) {
        broken_ = made ? std::string() : toldOf(made.error());
        if (!made) return stopWith(broken_);
        simulation_.emplace(std::move(*made));
        adopted_ = std::chrono::steady_clock::now();
        simulation_->hold(held_);
        finish_ = Finish::none;
        attempts_ = 0;
        simulation_->workWith(team_);
        publish({});
    }

    /// A frame step, unless one is cut off after so many cuts; edits that come faster than scenes can be built do not
    /// keep cloth from moving. Whether it is done with.
    bool advance(std::uint64_t seen, std::uint64_t cutsSeen) {
        if (!stands()) return true;
        const std::stop_token stop = fresh(stopStep_);
        if (cuts_ != cutsSeen) return false;
        finish_ = Finish::none;
        const auto before = simulation_->fallsUnseen() ? std::optional(simulation_->frame()) : std::nullopt;
        const auto advanced = simulation_->advance(stop);
        if (before && advanced) {
            if (steps_ > 0 || secondsSince(adopted_) > longestUnseen) simulation_->beSeen();
            if (!simulation_->fallsUnseen()) showTheWay(*before, seen);
        }
        const bool isCutOff = !advanced && advanced.error().code == ErrorCode::cancelled;
        if (advanced || isCutOff) publish({});
        else stopWith(toldOf(advanced.error()));
        return true;
    }

    /// How a garment that was seen so goes to where it lies now, unless something is ordered after `seen`.
    void showTheWay(const Frame& before, std::uint64_t seen) {
        const std::stop_token stop = fresh(stopFinish_);
        if (signal_ == seen) glideFrom(before, Finish::none, stop);
    }

    /// The paper has no statics.
    [[nodiscard]] bool mayFinish() const {
        return finishWanted_ && stands() && resting_ && finish_ == Finish::none && !scene_.paper;
    }

    /// The garment at rest goes on to its equilibrium, unless something is ordered after `seen`.
    void finish(std::uint64_t seen) {
        const std::stop_token stop = fresh(stopFinish_);
        if (signal_ != seen) return;
        finish_ = Finish::underWay;
        publish({});
        const Frame rested = simulation_->frame();
        const auto settled = simulation_->settle(finishing, stop);
        finish_ = Finish::none;
        if (!settled && settled.error().code == ErrorCode::cancelled) return publish({});
        const bool found = settled && settled->newton.converged;
        finishMove_ = settled ? settled->displacementMaximum : 0;
        glideFrom(rested, Finish::underWay, stop);
        if (!found && ++attempts_ < finishAttempts) {
            playUntil_ = simulation_->state().time + atLeast;
            return;
        }
        attempts_ = 0;
        finish_ = found ? Finish::found : Finish::notFound;
        warnings_ = warningsOf(*simulation_, contactOf(*simulation_));
        publish({});
    }

    [[nodiscard]] std::stop_token fresh(std::stop_source& source) {
        const std::lock_guard lock(stopping_);
        source = {};
        return source.get_token();
    }

    /// Pictures between where the garment was seen last and where it lies now.
    void glideFrom(const Frame& seen, Finish finish, std::stop_token stop) {
        const Glide glide(seen.positions, simulation_->nodePositions());
        for (int i = 1; i <= glide.pictures() && !stop.stop_requested(); ++i) {
            Frame between = seen;
            between.generation = generation_;
            between.finish = finish;
            between.positions = glide.picture(i);
            show(std::move(between));
            std::this_thread::sleep_for(Glide::each);
        }
    }

    void publish(std::string message) {
        Frame frame = stands() ? simulation_->frame() : Frame{};
        frame.generation = generation_;
        frame.message = std::move(message);
        frame.finish = finish_;
        frame.finishMove = finishMove_;
        if (finish_ == Finish::found || finish_ == Finish::notFound) frame.warnings = warnings_;
        resting_ = frame.atRest;
        show(std::move(frame));
    }

    /// A frame that was not taken in time hands on what it had to say of the same scene.
    void show(Frame frame) {
        const auto unseen = frames_.take();
        if (unseen && frame.message.empty() && unseen->generation == frame.generation) frame.message = unseen->message;
        frames_.put(std::move(frame));
    }

    void stopWith(std::string message) {
        stopPlaying();
        publish(std::move(message));
    }

    Scene scene_;
    std::uint64_t generation_ = 0;
    const std::shared_ptr<Team> team_ = std::make_shared<Team>(); ///< all cores
    std::optional<Simulation> simulation_;
    std::vector<Grip> held_; ///< by hands, whether there is a garment or not
    std::string broken_; ///< why the scene could not be built, and simulation_ is of one before it; empty = it could be
    bool resting_ = false;                          ///< the frame published last is at rest
    double playUntil_ = 0;                          ///< at rest or not [s]
    std::chrono::steady_clock::time_point adopted_; ///< when the simulation was taken over
    Finish finish_ = Finish::none;
    double finishMove_ = 0;         ///< of the finish before [m]
    std::vector<Warning> warnings_; ///< and of the garment after it
    int attempts_ = 0;              ///< of statics, since something was changed or held

    std::jthread thread_; // last: starts when all else stands, ends before all else goes
};

Runner::Runner() : worker_(std::make_unique<Worker>()) {}
Runner::~Runner() = default;

void Runner::setScene(Scene scene, std::uint64_t generation) {
    worker_->order({std::move(scene), generation});
}
void Runner::play() {
    worker_->play();
}
void Runner::pause() {
    worker_->pause();
}
void Runner::step() {
    worker_->requestStep();
}
void Runner::reset() {
    worker_->requestReset();
}
void Runner::finishAtRest(bool wanted) {
    worker_->finishAtRest(wanted);
}
void Runner::drapeWith(dynamics::Method method) {
    worker_->drapeWith(method);
}
void Runner::hold(std::vector<Grip> grips) {
    worker_->hold(std::move(grips));
}
void Runner::moveBody(std::shared_ptr<const geometry::VertexMotion> motion) {
    worker_->moveBody(std::move(motion));
}
void Runner::askForCheckpoint() {
    worker_->askForCheckpoint();
}
std::optional<Result<Checkpoint>> Runner::takeCheckpoint() {
    return worker_->takeCheckpoint();
}
void Runner::resume(Checkpoint checkpoint) {
    worker_->resume(std::move(checkpoint));
}
bool Runner::isPlaying() const {
    return worker_->isPlaying();
}
bool Runner::isBusy() const {
    return worker_->isBusy();
}
std::optional<Frame> Runner::takeFrame() {
    return worker_->takeFrame();
}

} // namespace toile::simulation
