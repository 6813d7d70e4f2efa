// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Energy.h"

#include <optional>

namespace toile::dynamics {

/// How much energy has been turned over since the watch of it began: against that gains are measured.
class EnergyTurnover {
public:
    /// At least what lifts all cloth by a millimetre and makes it a millimetre a second fast: less is nothing.
    EnergyTurnover(const cloth::ClothModel& model, const Vec3& gravity);

    void observe(const Energies& now);
    [[nodiscard]] double joules() const { return joules_; }

private:
    double joules_;
    std::optional<double> firstHeight_; ///< gravity's energy where the watch began [J]
};

} // namespace toile::dynamics
