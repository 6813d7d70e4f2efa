// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"

#include <vector>

namespace toile::fixtures {

/// Collects the 3×3 blocks of a small Hessian densely.
class DenseSink : public dynamics::HessianSink {
public:
    explicit DenseSink(int particles) : size(3 * particles), values(size * size) {}
    void add(int i, int j, const double (&block)[9]) override {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) values[(3 * i + r) * size + 3 * j + c] += block[3 * r + c];
    }
    [[nodiscard]] double quadratic(const std::vector<double>& v) const {
        double sum = 0;
        for (int r = 0; r < size; ++r)
            for (int c = 0; c < size; ++c) sum += v[r] * values[r * size + c] * v[c];
        return sum;
    }
    int size;
    std::vector<double> values;
};

} // namespace toile::fixtures
