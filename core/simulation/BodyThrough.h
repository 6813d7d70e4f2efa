// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Simulation.h"

#include <optional>
#include <string>
#include <vector>

namespace toile::simulation {

/// A part of the body that sticks through the cloth of a piece. Contact cannot undo it: on either side of the part the
/// cloth keeps its distance.
struct BodyThrough {
    std::optional<body::Limb> limb; ///< none of a body without limbs, and of one that has moved: its middle lines stand
    std::size_t piece = 0;          ///< index into Pattern::pieces
    friend bool operator==(const BodyThrough&, const BodyThrough&) = default;
};

/// By limbs, then pieces, each once: the piece meets skin all round the limb. What only cuts a bend of the skin, as
/// coarse cells do, lies along it.
[[nodiscard]] std::vector<BodyThrough> bodyThrough(const Simulation& simulation);

/// "left arm", "body".
[[nodiscard]] std::string partOf(const BodyThrough& through);

} // namespace toile::simulation
