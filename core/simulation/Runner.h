// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/dynamics/Method.h"
#include "core/geometry/VertexMotion.h"
#include "core/simulation/Checkpoint.h"
#include "core/simulation/Frame.h"
#include "core/simulation/Grips.h"
#include "core/simulation/Scene.h"

#include <memory>
#include <optional>

namespace toile::simulation {

/// Runs a simulation on a thread of its own. The owner hands over scenes and takes frames; neither side waits:
/// both are mailboxes in which the newest value wins.
class Runner {
public:
    Runner();
    ~Runner(); ///< stops the thread

    /// The garment to simulate from now on. If only values changed, the drape is kept where it can be
    /// (positions carried over by material coordinates); where it can (GoesOn::asSewn), the garment then falls into
    /// place anew, unseen unless it takes long or is stepped, and frames show the way there. What is playing goes on
    /// playing. generation > 0, rising.
    void setScene(Scene scene, std::uint64_t generation);
    /// Goes on until paused. A garment that comes to rest stays playing, but costs nothing until the next scene; told
    /// to play again it goes on for half a second at least.
    void play();
    void pause(); ///< a frame step under way is dropped, however long it would take
    void step();  ///< one frame step, then paused
    void reset(); ///< back to the placement, paused; nothing is held any more; a frame step under way is dropped
    /// From now on a garment that comes to rest while it plays goes on to its equilibrium by statics, on the same
    /// thread; frames show the way there. Every order stops it, and the garment lies where it rested. At first: no.
    void finishAtRest(bool wanted);
    /// By which method a sewn garment is draped from now on (Simulation::drapeWith), once no body moves beside it; what
    /// plays goes on by it, also if it was at rest. At first: XPBD.
    void drapeWith(dynamics::Method method);
    /// What hands hold from now on. While the cloth plays it follows them, also if it was at rest.
    void hold(std::vector<Grip> grips);
    /// The body moves so from now on (Simulation::moveBody), and time runs. What cannot be is refused by a frame's
    /// message.
    void moveBody(std::shared_ptr<const geometry::VertexMotion> motion);
    /// Asks where the simulation stands; takeCheckpoint() has it when the frame step under way is done.
    void askForCheckpoint();
    /// Refused where there is no garment that could stand anywhere, and where the body has moved.
    [[nodiscard]] std::optional<Result<Checkpoint>> takeCheckpoint();
    /// Goes on from there, paused; a frame step under way is dropped. What belongs to another scene is refused by a
    /// frame's message; the garment stays.
    void resume(Checkpoint checkpoint);
    [[nodiscard]] bool isPlaying() const;
    /// Something ordered is still to be done, or time is running: frames will come. Otherwise the thread sleeps.
    [[nodiscard]] bool isBusy() const;

    /// The newest frame if there is one that was not taken yet. Called once per repaint.
    [[nodiscard]] std::optional<Frame> takeFrame();

private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

} // namespace toile::simulation
