// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/dynamics/LevelMesh.h"
#include "core/dynamics/Prolongation.h"
#include "core/dynamics/SweepKernels.h"

#include <cstddef>
#include <span>

namespace toile::dynamics {

using geometry::Vec3;

/// Carries tension over long ways at once: the same cloth at 2, 4, 8 … times the spacing, corrected after the sweep of
/// each position-based substep, from the coarsest down.
///
/// With L levels the transport error of a line of n springs is that of n/2^L. A coarse triangle acts where it is taut,
/// along warp and weft, and against shear; each level has only the stiffness that the finer ones cannot have within the
/// cap. Linear and angular momentum are kept. Ref: docs/physics/xpbd.md
class CoarseLevels {
public:
    /// coarser: finest first; mass and inverseMass of the fine particles (0 = pinned).
    CoarseLevels(const LevelMesh& fine, std::span<const LevelMesh> coarser, std::span<const double> mass,
                 std::span<const double> inverseMass);

    /// Once before the substeps of a frame step, of length h [s]; cap κ of XpbdSettings.
    void beginStep(std::span<const Vec3> positions, double h, double cap);
    /// Drops what was measured in the frame steps before.
    void forget();
    /// Moves what is not pinned. With a team the work is shared out where it is much: the bits are the same.
    void correct(std::span<Vec3> positions, Team* team = nullptr);

    /// The least mass of a coarse particle over the median of its level. Near zero where a piece is narrower than the
    /// cells of a level: such a particle stands for no cloth, and what acts on it flings it.
    [[nodiscard]] double lightest() const;
    [[nodiscard]] int count() const { return static_cast<int>(levels_.size()); }
    [[nodiscard]] std::size_t bytes() const;

private:
    using PerStrain = std::array<double, 3>; ///< weft, warp, shear

    struct Triangle {
        std::array<int, 3> particles{};
        std::array<double, 3> u{}, v{}; ///< F_u = Σ u·x, F_v = Σ v·x [1/m]
        double area = 0;                ///< [m²]
        int parent = -1;                ///< in the next coarser level
        double share = 0;               ///< of its parent's area [–]
        PerStrain modulus{};            ///< of the cloth in it, in series [N/m]
    };
    /// Where a triangle stands among the fours.
    struct Seat {
        int four = 0, lane = 0;
    };
    struct Level {
        std::vector<double> mass, inverseMass;
        std::vector<Triangle> triangles;
        std::vector<FourLevelTriangles> fours; ///< the same in the order of the sweep, with what they do in a substep
        std::vector<Seat> seats;               ///< of each triangle
        std::vector<int> borders;              ///< fours between two of them share no particle
        Prolongation toFiner;
        Prolongation centres; ///< of each coarse particle, what it is the centre of mass of, with shares of its mass
        std::vector<Place> places;      ///< now, then the corners of lanes without a triangle
        std::vector<Vec3> before;       ///< this level's sweep; after it, what it moved
        std::vector<Vec3> meanU, meanV; ///< F_u, F_v of each triangle, the mean over the cloth in it
    };

    void compileFor(double h, double cap);
    void gather(std::span<const Vec3> positions, Team* team = nullptr);
    void measure(std::span<const Vec3> positions);
    static void putInSeries(std::span<const Triangle> finer, std::span<Triangle> coarse);
    static void compile(Level& level, int particles);
    template <class Positions>
    static void carryDown(const Level& level, Positions& finer, std::span<const double> inverseMass, Team* team);

    const SweepKernels& kernels_;
    std::vector<Triangle> fine_;
    std::vector<double> mass_, inverseMass_;
    std::vector<Level> levels_; ///< finest first
    double compiledStep_ = 0, compiledCap_ = 0;
};

} // namespace toile::dynamics
