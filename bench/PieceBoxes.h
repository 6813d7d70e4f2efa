// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"

#include <memory>
#include <span>
#include <vector>

namespace toile::bench {

/// FCL's broad phase over the pieces of a garment and the limbs of a body that stands.
class PieceBoxes {
public:
    /// pieceOf: of each particle.
    PieceBoxes(const body::Body& body, std::span<const int> pieceOf);
    ~PieceBoxes();

    /// How many particles are in pieces whose box, larger by reach [m], meets that of no limb.
    [[nodiscard]] int farParticles(std::span<const Vec3> positions, double reach);

private:
    struct Trees;
    std::unique_ptr<Trees> trees_;
};

} // namespace toile::bench
