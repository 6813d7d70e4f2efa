// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace toile::study {

/// A run as a point of the plot.
struct CostError {
    double cost = 0, error = 0;
};

/// The indices of points that no other beats in both, by rising cost. Of equal points the first.
[[nodiscard]] std::vector<int> paretoFront(std::span<const CostError> points);

/// The order of a method: slope of log error over log step by least squares. NaN for fewer than two points.
[[nodiscard]] double observedOrder(std::span<const double> steps, std::span<const double> errors);

/// The least cost at which an error is reached, between points log–log along the front; NaN if it is not reached.
[[nodiscard]] double costOf(double error, std::span<const CostError> points);

} // namespace toile::study
