// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Ways to find the nearest place of a body, for toile-bench-body to compare.
namespace toile::bench {

struct Nearest {
    double signedDistance = 0; ///< [m]
    Vec3 normal;               ///< [–]
};

class NearestWay {
public:
    virtual ~NearestWay() = default;
    /// None if nothing is within the radius [m], or the way does not reach so far.
    [[nodiscard]] virtual std::optional<Nearest> nearest(const Vec3& p, double radius) = 0;
    /// The body goes on with its vertices there [m].
    virtual void moveTo(std::span<const Vec3> vertices) = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// How far from the skin the grids reach [m].
inline constexpr double gridBand = 0.03;

struct NamedWay {
    std::string name;
    std::function<std::unique_ptr<NearestWay>(const body::Body&)> build;
};

/// The product's own way first.
[[nodiscard]] std::vector<NamedWay> nearestWays();

/// A search over all triangles: the truth.
[[nodiscard]] std::unique_ptr<NearestWay> bruteForce(const body::Body& body);

/// The body's limb whose middle line is nearest to each triangle: parts for a broad phase. One part without axes.
[[nodiscard]] std::vector<int> limbOfTriangles(const body::Body& body);

} // namespace toile::bench
