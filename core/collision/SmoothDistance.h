// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace toile::collision {

/// A function of the place, with its slope and curvature there.
struct SmoothValue {
    double value = 0;    ///< [m]
    Vec3 gradient;       ///< [–]
    double hessian[9]{}; ///< row-major, symmetric [1/m]
};

/// The signed distance to a body as a function with two continuous derivatives: tricubic B-splines over a lattice,
/// whose nodes are asked of the body when they are first needed. Planes are exact; of edges and corners what is
/// narrower than the lattice is rounded: near a surface with mean curvature H the value is spacing²·H/3 larger than the
/// distance. Like the distance it changes by no more than the way gone.
class SmoothDistance {
public:
    /// The nodes that bear on a place; whoever asks again near it hands them back.
    struct Patch {
        std::array<std::int32_t, 3> cell{};
        std::array<double, 64> nodes{};
        bool known = false;
    };

    /// The body is borrowed and outlives the function. spacing of the lattice [m].
    SmoothDistance(const BodySurface& body, double spacing) : body_(body), spacing_(spacing) {}

    [[nodiscard]] SmoothValue at(const Vec3& p, Patch& patch);

    [[nodiscard]] std::size_t bytes() const;

private:
    void fill(Patch& patch);

    const BodySurface& body_;
    double spacing_;
    std::unordered_map<std::uint64_t, double> nodes_; ///< distance by lattice place [m]
};

} // namespace toile::collision
