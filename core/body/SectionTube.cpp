// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/SectionTube.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <cmath>

namespace toile::body {

namespace {

constexpr std::size_t channels = 7;
constexpr double farAway = 0.1; // beyond the widest rounding of joints, a lower bound is distance enough [m]

/// Second derivatives of the cubic spline through equally indexed values whose slope is zero at both ends.
template <class Values>
std::vector<Values> clampedCurvatures(const std::vector<double>& at, const std::vector<Values>& values) {
    const std::size_t n = at.size();
    std::vector<Values> curvature(n);
    for (std::size_t c = 0; c < channels; ++c) {
        std::vector<double> diagonal(n), upper(n), right(n);
        const auto step = [&](std::size_t i) { return at[i + 1] - at[i]; };
        const auto slope = [&](std::size_t i) { return (values[i + 1][c] - values[i][c]) / step(i); };
        diagonal[0] = 2 * step(0), upper[0] = step(0), right[0] = 6 * slope(0);
        for (std::size_t i = 1; i < n; ++i) {
            const bool last = i + 1 == n;
            const double below = step(i - 1), factor = below / diagonal[i - 1];
            upper[i] = last ? 0 : step(i);
            diagonal[i] = 2 * (below + upper[i]) - factor * upper[i - 1];
            right[i] = 6 * ((last ? 0 : slope(i)) - slope(i - 1)) - factor * right[i - 1];
        }
        for (std::size_t i = n; i-- > 0;)
            curvature[i][c] = (right[i] - (i + 1 < n ? upper[i] * curvature[i + 1][c] : 0)) / diagonal[i];
    }
    return curvature;
}

/// (|u|ⁿ + |v|ⁿ)^(1/n)
double norm(double u, double v, double power) {
    if (power == 2) return std::sqrt(u * u + v * v);
    const double a = std::abs(u), b = std::abs(v), large = std::max(a, b);
    return large > 0 ? large * std::pow(1 + std::pow(std::min(a, b) / large, power), 1 / power) : 0;
}

} // namespace

SectionTube::SectionTube(const Transform& frame, const std::vector<Section>& sections, double lowCap, double highCap)
    : frame_(frame), lowCap_(lowCap), highCap_(highCap) {
    expects(sections.size() >= 2, "a tube has at least two sections");
    for (const Section& s : sections) {
        expects(at_.empty() || s.at > at_.back(), "the sections of a tube stand in order");
        at_.push_back(s.at);
        values_.push_back({s.centre.x, s.centre.y, s.right, s.left, s.front, s.back, s.power});
        reach_ = std::max(reach_,
                          1.1 * (length(s.centre) + std::hypot(std::max(s.right, s.left), std::max(s.front, s.back))));
    }
    curvatures_ = clampedCurvatures(at_, values_);
}

SectionTube::Values SectionTube::valuesAt(double at) const {
    const double x = std::clamp(at, at_.front(), at_.back());
    const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, x);
    const auto j = static_cast<std::size_t>(above - at_.begin()), i = j - 1;
    const double h = at_[j] - at_[i], a = (at_[j] - x) / h, b = 1 - a;
    const double ca = (a * a * a - a) * h * h / 6, cb = (b * b * b - b) * h * h / 6;
    Values result;
    for (std::size_t c = 0; c < channels; ++c)
        result[c] = a * values_[i][c] + b * values_[j][c] + ca * curvatures_[i][c] + cb * curvatures_[j][c];
    return result;
}

double SectionTube::distance(const Vec3& point) const {
    const Vec3 d = point - frame_.origin;
    const double x = dot(d, frame_.axisX), y = dot(d, frame_.axisY), z = dot(d, frame_.axisZ);
    const double away = std::max({at_.front() - lowCap_ - y, y - at_.back() - highCap_, std::hypot(x, z) - reach_});
    if (away > farAway) return away;
    const Values s = valuesAt(y);
    const double dx = x - s[0], dz = z - s[1];
    const double past = y < at_.front() ? at_.front() - y : y > at_.back() ? y - at_.back() : 0;
    const double cap = y < at_.front() ? lowCap_ : highCap_;
    double q = norm(dx / (dx < 0 ? s[2] : s[3]), dz / (dz < 0 ? s[5] : s[4]), s[6]);
    if (past > 0) q = std::hypot(q, past / cap);
    const double narrowest = std::min({s[2], s[3], s[4], s[5]});
    if (q < 0.05) return -0.95 * narrowest; // near the middle line, where no direction leads outward
    return (q - 1) / q * std::sqrt(dx * dx + dz * dz + past * past);
}

Vec3 SectionTube::middle(double at) const {
    const Section s = sectionAt(at);
    return frame_.point({s.centre.x + (s.left - s.right) / 2, at, s.centre.y + (s.front - s.back) / 2});
}

Section SectionTube::sectionAt(double at) const {
    const Values v = valuesAt(at);
    return {at, {v[0], v[1]}, v[2], v[3], v[4], v[5], v[6]};
}

double smoothMin(double a, double b, double k) {
    const double overlap = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - overlap * overlap * overlap * k / 6;
}

} // namespace toile::body
