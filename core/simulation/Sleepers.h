// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Garment.h"
#include "core/simulation/Tacks.h"

#include <optional>
#include <span>
#include <vector>

namespace toile::simulation {

/// So long cloth has not moved when it falls asleep [s].
inline constexpr double beforeSleep = 1;

/// Pieces that lie still while others move. What hangs together by seams and tacks, also by such as are still open,
/// sleeps together: it is a group.
class Sleepers {
public:
    Sleepers(const Garment& garment, std::span<const TackState> tacks);

    /// After a frame step in which particles went from where they were before to where they are after [m]. Groups
    /// whose boxes are nearer than the reach [m] keep each other awake; absent: they pass through each other.
    /// Returns whether others sleep now than before. Where all lie still, no other group does so alone.
    [[nodiscard]] bool note(const Garment& garment, std::span<const Vec3> before, std::span<const Vec3> after,
                            double duration, std::optional<double> reach);
    void wake(); ///< all

    [[nodiscard]] bool isAsleep(int piece) const;
    [[nodiscard]] std::vector<int> pieces() const; ///< that sleep, rising
    [[nodiscard]] double share() const;            ///< of the particles that sleep [–]
    /// The garment without what a step of cloth that moves has no use for: what sleeps is pinned where it is, and has
    /// no elements but hinges, by whose numbers folds are known.
    [[nodiscard]] Garment awakeOf(const Garment& garment) const;

private:
    struct Group {
        std::vector<int> pieces, particles; ///< rising
        double stillTime = 0;               ///< [s]
        bool isAsleep = false;
    };

    void keepAwakeNear(std::span<const Vec3> positions, double reach, std::vector<bool>& sleeps) const;

    std::vector<Group> groups_; ///< none where all pieces hang together
    int particles_ = 0;         ///< of all
};

} // namespace toile::simulation
