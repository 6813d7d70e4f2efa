// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/ParticleMap.h"

#include <optional>
#include <string>
#include <vector>

namespace toile::simulation {

/// A point of a piece as a blend of three nodes of its mesh: weights sum to 1, none is negative.
struct MeshPoint {
    int piece = 0;
    std::array<int, 3> nodes{};
    std::array<double, 3> weights{};
};

/// In the display triangle that holds the point, or in the nearest place of the mesh: its outline is a chord's error
/// within that of the pattern.
[[nodiscard]] MeshPoint meshPointAt(const meshing::GarmentMesh& mesh, int piece, Vec2 point);

/// How far a tack is.
struct TackState {
    std::string name;
    std::array<MeshPoint, 2> ends;
    double length = 0; ///< of its thread between the mid-surfaces of the two layers [m]
    int order = 0;
    double initialGap = 0; ///< beyond that length where the pieces were placed [m]
    bool closed = false;   ///< it has been drawn together; since then its thread holds with all its strength
    double start = -1;     ///< when it began to close [s]; negative = not yet
    double startGap = 0;   ///< then [m]
};

struct TackSettings {
    double play = 0.5e-3;      ///< of the thread beyond the thickness of the layers [m]; assumed
    double closedGap = 1e-3;   ///< beyond the thread's length that passes for closed [m]: what contact, which has the
                               ///< last word in a substep, leaves between layers that it parts
    double closedSpeed = 0.1;  ///< of the ends against each other, for the same [m/s]
    double maximumForce = 5;   ///< that draws it together [N], as of a pair of a seam: a tack that something blocks
                               ///< neither tears the cloth nor presses it into that
    double openStiffness = 10; ///< of that force where forces are solved for [N/m]: the block is hardly dented
    double strength = 50;      ///< of the thread once it is closed [N]; assumed, buttons are tested with 70 to 90 N
    double stiffness = 1e4;    ///< of the taut thread then [N/m]: 3 N, as between the buttons
                               ///< of a tight shirt, lengthen it by 0.3 mm
    double maximumSpeed = 5;   ///< at which it may close [m/s]
    int iterations = 4;        ///< sweeps over the tacks in a substep
};

/// The tacks of a pattern without errors (pattern::checkPattern) in a mesh of it.
[[nodiscard]] std::vector<TackState> tacksOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                             const TackSettings& settings = {});

/// From the first end to the second [m].
[[nodiscard]] Vec3 wayBetween(const TackState& tack, const ParticleMap& particles, std::span<const Vec3> positions);
/// How much the ends are farther apart than the thread is long [m]; 0 where it hangs loose.
[[nodiscard]] double gapBetween(const TackState& tack, const ParticleMap& particles, std::span<const Vec3> positions);

/// Holds the two ends of every tack together: a thread, which pulls but does not push. A tack that closes is drawn
/// together like a seam, by an allowed gap that falls to nothing; its ends never become one particle, so that a button
/// sits anywhere in the mesh.
class Tacks final : public dynamics::Stage {
public:
    /// duration: in which a tack is drawn together [s]; mass: one per particle [kg]. Tacks that have not begun are
    /// passed over.
    Tacks(std::span<const TackState> tacks, const ParticleMap& particles, double duration, std::span<const double> mass,
          TackSettings settings = {});

    [[nodiscard]] std::string_view name() const override { return "tacks"; }
    [[nodiscard]] std::size_t bytes() const override { return threads_.capacity() * sizeof(Thread); }
    void beginStep(const dynamics::ParticleState&, double) override {}
    void project(dynamics::Substep& substep) override;

    void beginIteration(std::span<const Vec3>) override {}
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const override;
    [[nodiscard]] double largestFrequencySquared() const override { return frequencySquared_; }

private:
    /// Way between its ends = Σ coefficient · x(particle).
    struct Thread {
        std::array<int, 6> particles{};
        std::array<double, 6> coefficients{};
        int count = 0;
        double length = 0, startGap = 0, start = 0;
        double stiffness = 0, maximumForce = 0;
    };

    [[nodiscard]] static Thread threadOf(const TackState& tack, const ParticleMap& particles,
                                         const TackSettings& settings);
    [[nodiscard]] static Vec3 wayOf(const Thread& thread, std::span<const Vec3> positions);
    [[nodiscard]] double allowedGap(const Thread& thread, double time) const;

    std::vector<Thread> threads_;
    double duration_;
    TackSettings settings_;
    double frequencySquared_ = 0; ///< [1/s²]
};

} // namespace toile::simulation
