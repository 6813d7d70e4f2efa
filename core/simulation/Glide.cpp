// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Glide.h"

#include "core/base/Contracts.h"

#include <algorithm>

namespace toile::simulation {
namespace {

constexpr double speed = 0.03;  ///< of the vertex that goes farthest, on the average [m/s]
constexpr double longest = 0.5; ///< [s]

double eased(double share) {
    return share * share * (3 - 2 * share);
}

} // namespace

Glide::Glide(std::vector<Vec3> from, std::vector<Vec3> to) : from_(std::move(from)), to_(std::move(to)) {
    expects(from_.size() == to_.size(), "a way has two ends");
    double farthest = 0;
    for (std::size_t v = 0; v < from_.size(); ++v) farthest = std::max(farthest, geometry::distance(from_[v], to_[v]));
    const double duration = std::min(farthest / speed, longest);
    pictures_ = std::max(static_cast<int>(duration / std::chrono::duration<double>(each).count()) - 1, 0);
}

std::vector<Vec3> Glide::picture(int i) const {
    expects(i >= 1 && i <= pictures_, "a picture of the way");
    const double share = eased(static_cast<double>(i) / (pictures_ + 1));
    std::vector<Vec3> between(from_.size());
    for (std::size_t v = 0; v < between.size(); ++v) between[v] = lerp(from_[v], to_[v], share);
    return between;
}

} // namespace toile::simulation
