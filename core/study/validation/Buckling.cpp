// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/BlockCholesky.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/Statics.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"

namespace toile::study::validation {

namespace {

constexpr double length = 0.1, bending = 5e-5; // [m], [N·m]
constexpr double modulus = 1e4, shear = 100;   // [N/m]
constexpr int cells = 32;
constexpr double h = length / cells;

/// A strip that stands on two clamped rows of nodes at y = −h and 0.
struct Column {
    Patch patch;
    ClothModel model;
};

Column column() {
    Fabric fabric = unequalWeave();
    fabric.warpStiffness = fabric.weftStiffness = modulus;
    fabric.shearStiffness = shear;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = bending;
    std::vector<double> rows;
    for (int j = -1; j <= cells; ++j) rows.push_back(j * h);
    Column c{gridPatch(evenLines(h, 1), rows), {}};
    c.model = modelOf(c.patch, fabric);
    c.model.pinned = {0, 1, 2, 3};
    cloth::doubleBendingAtClampedRows(c.model);
    return c;
}

/// An equilibrium with an indefinite exact Hessian is no minimum of the energy: it gives way.
bool isIndefinite(const ClothModel& model, const std::vector<Vec3>& x) {
    const dynamics::Eliminated eliminated(model);
    struct Sink : cloth::HessianSink {
        const dynamics::Eliminated& eliminated;
        dynamics::BlockCholesky& matrix;
        Sink(const dynamics::Eliminated& e, dynamics::BlockCholesky& m) : eliminated(e), matrix(m) {}
        void add(int i, int j, const double (&block)[9]) override {
            const int row = eliminated.unknownOf(i), col = eliminated.unknownOf(j);
            if (row >= 0 && col >= 0) matrix.add(row, col, block);
        }
    };
    dynamics::BlockCholesky matrix(eliminated.count());
    Sink sink(eliminated, matrix);
    cloth::addHessian(model, x, cloth::HessianForm::exact, sink);
    return !matrix.factorize(std::vector<double>(eliminated.count(), 0.0));
}

/// The straight strip compressed by what stands above each height is no energy minimum any more once it
/// buckles: the exact Hessian loses its definiteness. compression(y): strain along y.
bool buckles(const Column& c, auto compression) {
    std::vector<Vec3> x = flatPositions(c.patch);
    for (std::size_t p = 4; p < x.size(); p += 2) {
        const double middle = 0.5 * (c.patch.material[p].y + c.patch.material[p - 2].y);
        const double strain = compression(middle);
        x[p].y = x[p + 1].y = x[p - 2].y + h * (1 - strain);
        x[p + 1].x = h * (1 + strain * shear / modulus); // free sides
    }
    return isIndefinite(c.model, x);
}

/// The smallest load at which it buckles, between two that enclose it.
double criticalLoad(double low, double high, auto bucklesAt) {
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (bucklesAt(middle) ? high : low) = middle;
    }
    return low;
}

/// A ribbon on edge along x, clamped at two columns of nodes at x = −spacing and 0; isotropic with ν = 0.
/// The formula is that of a narrow ribbon: at a width of L/10 the load is 6 % higher, at L/40 1 %.
struct Ribbon {
    static constexpr double reach = 0.2, width = 0.01;
    Patch patch;
    ClothModel model;

    Ribbon(int along, int across) {
        Fabric fabric = unequalWeave();
        fabric.arealDensity = 0.01;
        fabric.warpStiffness = fabric.weftStiffness = modulus;
        fabric.shearStiffness = modulus / 2;
        fabric.warpBending = fabric.weftBending = bending;
        fabric.biasBending = bending; // 4·B45 − B1 − B2 = 4·D66 = 2B
        std::vector<double> columns;
        for (int i = -1; i <= along; ++i) columns.push_back(i * reach / along);
        patch = gridPatch(columns, evenLines(width, across));
        model = modelOf(patch, fabric);
        for (std::size_t p = 0; p < patch.material.size(); ++p)
            if (patch.material[p].x < 1e-9) model.pinned.push_back(static_cast<int>(p));
        cloth::doubleBendingAtClampedRows(model);
    }
    /// Under a weight per area [N/m²] that bends it in its own plane.
    [[nodiscard]] bool tipsOver(Findings& found, double weight) const {
        dynamics::ParticleState state{.positions = flatPositions(patch), .velocities = {}};
        const Vec3 gravity{0, -weight / 0.01, 0};
        const auto rest = dynamics::solveStatic(model, state, gravity, {}, {.tolerance = 1e-5});
        if (found.ran(rest) && !rest->newton.converged) found.stop("There is no equilibrium in the plane.");
        return isIndefinite(model, state.positions);
    }
};

void v11EulerBuckling(Findings& found) {
    const Column c = column();
    const double load = criticalLoad(0, 1, [&](double p) { return buckles(c, [p](double) { return p / modulus; }); });
    const double expected = std::numbers::pi * std::numbers::pi * bending / (4 * length * length);
    found.within("clamped–free strip, edge load, 32 cells", expected, load, 0.02);
}

void v12SelfBuckling(Findings& found) {
    const Column c = column();
    const double load = criticalLoad(0, 10, [&](double weight) { // ρg [N/m²]
        return buckles(c, [weight](double y) { return weight * (length - y) / modulus; });
    });
    found.within("standing strip, ρgL³/B, 32 cells", 7.83735, load * length * length * length / bending, 0.02);
}

void v13LateralBuckling(Findings& found) {
    const Ribbon ribbon(64, 4);
    const double load = criticalLoad(0, 1, [&](double weight) { return ribbon.tipsOver(found, weight); });
    const double cube = Ribbon::reach * Ribbon::reach * Ribbon::reach;
    found.within("ribbon on edge, ρgL³/B, 64 × 4 cells with twist", 18.18, load * cube / bending, 0.05);
}

} // namespace

std::vector<Case> bucklingCases() {
    constexpr std::string_view theme = "buckling";
    return {
        {"V11", theme, "Euler buckling", v11EulerBuckling},
        {"V12", theme, "self-buckling", v12SelfBuckling},
        {"V13", theme, "lateral buckling", v13LateralBuckling},
    };
}

} // namespace toile::study::validation
