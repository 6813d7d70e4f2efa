// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/dynamics/Method.h"
#include "core/geometry/VertexMotion.h"
#include "core/simulation/Checkpoint.h"
#include "core/simulation/Frame.h"
#include "core/simulation/Grips.h"
#include "core/simulation/Scene.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace toile::ui {

/// What the window needs of a running simulation (simulation::Runner); tests put their own in its place.
class Simulation {
public:
    virtual ~Simulation() = default;
    virtual void setScene(simulation::Scene scene, std::uint64_t generation) = 0;
    virtual void play() = 0;
    virtual void pause() = 0;
    virtual void step() = 0;
    virtual void reset() = 0;
    virtual void finishAtRest(bool wanted) = 0;
    virtual void drapeWith(dynamics::Method method) = 0;
    virtual void hold(std::vector<simulation::Grip> grips) = 0;
    virtual void moveBody(std::shared_ptr<const geometry::VertexMotion> motion) = 0;
    virtual void askForCheckpoint() = 0;
    [[nodiscard]] virtual std::optional<Result<simulation::Checkpoint>> takeCheckpoint() = 0;
    virtual void resume(simulation::Checkpoint checkpoint) = 0;
    [[nodiscard]] virtual bool isPlaying() const = 0;
    [[nodiscard]] virtual bool isBusy() const = 0; ///< frames will come
    [[nodiscard]] virtual std::optional<simulation::Frame> takeFrame() = 0;
};

} // namespace toile::ui
