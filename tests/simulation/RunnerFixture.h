// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "SmallScenes.h"
#include "core/simulation/Runner.h"

#include <QTest>
#include <functional>

namespace toile::simulation {

/// The first frame from now on that is as wanted; absent after a minute.
inline std::optional<Frame> waitForFrame(Runner& runner, std::function<bool(const Frame&)> wanted) {
    std::optional<Frame> found;
    (void)QTest::qWaitFor(
        [&] {
            if (auto frame = runner.takeFrame(); frame && wanted(*frame)) found = std::move(frame);
            return found.has_value();
        },
        60000);
    return found;
}

inline Checkpoint checkpointOf(Runner& runner) {
    runner.askForCheckpoint();
    std::optional<Result<Checkpoint>> checkpoint;
    (void)QTest::qWaitFor([&] { return (checkpoint = runner.takeCheckpoint()).has_value(); }, 60000);
    if (!checkpoint || !*checkpoint) qFatal("no checkpoint");
    return std::move(**checkpoint);
}

} // namespace toile::simulation
