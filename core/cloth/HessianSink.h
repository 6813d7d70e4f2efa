// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::cloth {

/// Collects 3×3 blocks of ∂²E/∂x∂x. Blocks are row-major; (i, j) and (j, i) are both added by the caller.
class HessianSink {
public:
    virtual ~HessianSink() = default;
    virtual void add(int i, int j, const double (&block)[9]) = 0;
};

} // namespace toile::cloth
