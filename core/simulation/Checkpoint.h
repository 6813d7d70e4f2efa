// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BodyContact.h"
#include "core/simulation/Garment.h"
#include "core/simulation/Phase.h"
#include "core/simulation/Scene.h"

#include <string>
#include <vector>

namespace toile::simulation {

/// Where a simulation stands. With the scene it belongs to that is all it takes to go on, bit by bit.
struct Checkpoint {
    struct Seam {
        bool merged = false;
        double initialGap = 0, gapAtMerge = 0; ///< largest [m]
        double start = -1;                     ///< when it began to close [s]; negative = not yet
        std::vector<double> gaps;              ///< of each pair then [m]
        friend bool operator==(const Seam&, const Seam&) = default;
    };
    struct Tack {
        bool closed = false;
        double initialGap = 0;           ///< where the pieces were placed [m]
        double start = -1, startGap = 0; ///< when it began to close [s], negative = not yet; and its gap then [m]
        friend bool operator==(const Tack&, const Tack&) = default;
    };
    std::string scene; ///< fingerprint of what it belongs to
    double time = 0;   ///< [s]
    int steps = 0;
    Phase phase = Phase::sewing;
    std::string method;           ///< that the last frame step was made with; empty = none was
    double sewnTime = 0;          ///< when the last seam was closed or given up [s]
    double restingTime = 0;       ///< [s]
    double largestSpeed = 0;      ///< [m/s]
    bool goesOnAsItLay = false;   ///< after an edit
    bool settles = false;         ///< as sewn or edited cloth is damped
    bool leaps = false;           ///< is held back when its seams are closed
    std::vector<Seam> seams;      ///< as the pattern has them
    std::vector<Tack> tacks;      ///< the same
    std::vector<Vec3> positions;  ///< of particles [m]
    std::vector<Vec3> velocities; ///< [m/s]
    std::vector<int> hangsBy;     ///< nodes, of a garment on a finer mesh than it was sewn on
    std::vector<Vec3> sewn;       ///< nodes when the last seam was closed; empty: more than weight moved it since [m]
    std::vector<Vec3> shown;      ///< nodes in frames, while an edited garment falls unseen [m]
    dynamics::ContactMemory contact; ///< with the body
    friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

/// Of the mesh, the constants of the cloth, the body and the settings: equal for scenes in which a state means the
/// same.
[[nodiscard]] std::string fingerprintOf(const Scene& scene, const Garment& garment);

} // namespace toile::simulation
