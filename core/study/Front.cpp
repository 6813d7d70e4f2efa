// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Front.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace toile::study {

std::vector<int> paretoFront(std::span<const CostError> points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, [&](int a, int b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    std::vector<int> front;
    for (const int i : order)
        if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
    return front;
}

double observedOrder(std::span<const double> steps, std::span<const double> errors) {
    expects(steps.size() == errors.size(), "one error for each step");
    if (steps.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const double n = static_cast<double>(steps.size());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double a = std::log(steps[i]), b = std::log(errors[i]);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

double costOf(double error, std::span<const CostError> points) {
    const std::vector<int> front = paretoFront(points);
    for (std::size_t i = 0; i < front.size(); ++i) {
        const CostError& here = points[front[i]];
        if (here.error > error) continue;
        if (i == 0) return here.cost;
        const CostError& before = points[front[i - 1]];
        const double t = std::log(before.error / error) / std::log(before.error / here.error);
        return before.cost * std::pow(here.cost / before.cost, t);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

} // namespace toile::study
