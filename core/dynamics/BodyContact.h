// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/collision/MovingSurface.h"
#include "core/collision/SmoothDistance.h"
#include "core/collision/SurfaceTracker.h"
#include "core/dynamics/Friction.h"
#include "core/dynamics/Stage.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace toile::dynamics {

/// A place of the cloth that keeps its distance to the body: x = Σ weight · x(particle); weights sum to 1.
struct ContactSample {
    std::vector<std::pair<int, double>> particles;
    double halfThickness = 0; ///< of the cloth [m]
    double friction = 0;      ///< μ of the pair cloth and body [–]
    double mass = 0;          ///< of the cloth it stands for [kg]; sets its stiffness in statics
};

/// One sample per particle, μ = √(μ_cloth · μ_body); a slave's sample is the blend of its masters.
/// halfThickness and clothFriction: one per particle.
[[nodiscard]] std::vector<ContactSample> particleSamples(const cloth::ClothModel& model,
                                                         std::span<const double> halfThickness,
                                                         std::span<const double> clothFriction, double bodyFriction);

/// The sample in the middle of others, e.g. of the four corners of a cell that bridges a limb.
[[nodiscard]] ContactSample middleOf(std::span<const ContactSample* const> corners);

struct BodyContactSettings {
    double skinOffset = 0.003;   ///< between the body and the cloth's underside [m]
    double pushOutSpeed = 0.5;   ///< at most, of cloth that is too near at the start of a substep [m/s]
    double pushOutTime = 0.02;   ///< in which a small overlap falls to 1/e, so that cloth leaves without a jump [s]
    double planeReach = 0.00025; ///< a tangent plane stands for the surface over so short a way [m]
    bool bearsLayers = false;    ///< a stage after this one presses cloth on to the body

    double stiffness = 2.5e7;   ///< of statics, k per mass of the sample [1/s²]: 500 Pa dent 0.4 mm into 0.1 kg/m²
    double onset = 5e-4;        ///< dent over which the push grows to that stiffness [m]
    int takings = 3;            ///< how often statics takes dents back
    double lattice = 0.0025;    ///< of the smooth distance that statics sees [m]
    double frictionGive = 1e-4; ///< way over which statics builds friction up to μN [m]
    double staticReach = 0.02;  ///< how far ahead statics looks for contact in one iteration [m]
};

struct ContactReport {
    double smallestClearance = 0;  ///< signed distance of the nearest sample to the body's surface [m]
    double largestPenetration = 0; ///< max(0, −smallestClearance) [m]
    int contacts = 0;              ///< samples at their target distance, to within 0.1 mm
};

/// What the samples of a contact know of the forces they bear. It goes on by it as if it had never been made anew.
struct ContactMemory {
    std::vector<double> forces;    ///< by which they are pressed [N]; empty: nothing is known
    std::vector<double> takenBack; ///< by which statics has them kept farther [m]
    std::vector<Vec3> anchors;     ///< that friction pulls back to [m]; empty: it has not been fixed
    friend bool operator==(const ContactMemory&, const ContactMemory&) = default;
};

/// Contact of cloth with a body: the distance of skin offset + half thickness is kept, and
/// tangential motion is resisted by Coulomb friction, which sticks exactly. A body may move while steps are
/// position-based. docs/collision.md
class BodyContact final : public Stage {
public:
    /// The body is borrowed and outlives the stage. Samples on pinned particles alone (rising) are not looked at in a
    /// substep: none moves them.
    BodyContact(const collision::BodySurface& body, std::vector<ContactSample> samples,
                BodyContactSettings settings = {}, std::span<const int> pinned = {});

    /// The body moves from now on: the surface of this motion is the one that the stage was made with. Borrowed.
    void follow(collision::MovingSurface& motion) { motion_ = &motion; }

    [[nodiscard]] std::string_view name() const override { return "body contact"; }
    [[nodiscard]] std::size_t bytes() const override;

    void beginStep(const ParticleState& state, double duration) override;
    void project(Substep& substep) override;

    /// Normal forces and directions that friction rests on. It pulls back to anchors: where the samples were at the
    /// first call after a position-based substep, dragged along by what slips in implicit and explicit steps.
    void fixFriction(std::span<const Vec3> positions) override;
    void easeFriction(double part) override;
    /// In statics, the first times that friction is fixed anew, what presses is kept farther by its dent, so that it
    /// comes to rest at its distance (method of multipliers).
    void take(const Motion& motion) override;
    /// Finds the samples that may touch in the iteration.
    void beginIteration(std::span<const Vec3> positions) override;
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, HessianSink& sink) const override;
    /// All samples pressed at once, dented by at most 0.4 mm (500 Pa on 0.1 kg/m²): friction is as stiff as that.
    [[nodiscard]] double largestFrequencySquared() const override;

    /// For another contact of the same samples.
    [[nodiscard]] ContactMemory memory() const;
    /// False and nothing done: it is of other samples.
    bool recall(const ContactMemory& memory);
    /// Takes over what another knows of the same samples, as far as these are the same. Cloth lies at the positions.
    void goOnFrom(const BodyContact& before, std::span<const Vec3> positions);

    /// Asks the body for every sample: for reports, not for every step.
    [[nodiscard]] ContactReport report(std::span<const Vec3> positions) const;
    /// Smallest signed distance of a sample to the body's surface [m].
    [[nodiscard]] double clearance(std::span<const Vec3> positions) const {
        return report(positions).smallestClearance;
    }

private:
    struct Term {
        int particle = 0;
        double weight = 0;
        friend bool operator==(const Term&, const Term&) = default;
    };
    struct Sample {
        int firstTerm = 0, termCount = 0;
        double distance = 0;    ///< to be kept [m]
        double friction = 0;    ///< [–]
        double stiffness = 0;   ///< [N/m]
        double normalForce = 0; ///< running mean of the substeps, then as friction was fixed [N]
        double takenBack = 0;   ///< by which it is kept farther than that in statics [m]
        Vec3 normal;            ///< of the body, where friction was fixed
    };
    /// What only statics, implicit and explicit steps need; the first of them makes it.
    struct Pushing {
        collision::SmoothDistance distance;
        std::vector<collision::SmoothDistance::Patch> patches; ///< one per sample
        std::vector<Vec3> anchors; ///< one per sample; empty until friction is fixed after a position-based substep
        std::vector<int> near;     ///< samples that may touch in this iteration
        std::vector<double> normalForceBefore; ///< one per sample: before friction was fixed last [N]
    };

    [[nodiscard]] std::span<const Term> termsOf(const Sample& sample) const {
        return std::span(terms_).subspan(sample.firstTerm, sample.termCount);
    }
    [[nodiscard]] Vec3 at(const Sample& sample, std::span<const Vec3> positions) const {
        const Term* term = terms_.data() + sample.firstTerm;
        if (sample.termCount == 1) return positions[term->particle]; // the weight is 1
        Vec3 sum;
        for (int k = 0; k < sample.termCount; ++k) sum += positions[term[k].particle] * term[k].weight;
        return sum;
    }
    void follow(double time);
    void meet(std::size_t sample, const ContactPace& pace, Substep& substep);
    void meetMoving(std::size_t sample, const Vec3& now, const Vec3& before, const ContactPace& pace, Substep& substep);
    void resolve(Sample& sample, const collision::TangentPlane& plane, const Vec3& now, const Vec3& before,
                 const ContactPace& pace, Substep& substep);
    [[nodiscard]] double pressedIn(const Sample& sample, const Vec3& normal, const Substep& substep) const;
    void press(int particle, const Vec3& push, double cancels);
    void rub(int particle, Substep& substep) const;
    Pushing& pushing();
    [[nodiscard]] double dentOf(const Sample& sample, double distance) const;
    [[nodiscard]] double roomOf(const Sample& sample) const;
    [[nodiscard]] std::optional<collision::SmoothValue> dentingAt(int sample, const Vec3& now) const;
    [[nodiscard]] Vec3 slipOf(int sample, const Vec3& now) const;

    BodyContactSettings settings_;
    std::vector<Term> terms_;
    std::vector<Sample> samples_;
    std::vector<int> blends_, alone_; ///< samples that have a particle in common with others, and those that have not
    std::vector<double> mayCancel_;   ///< of each particle, slip that friction can cancel in this substep [m]
    std::vector<Vec3> pushed_;        ///< and where the pushes that press it have moved it, if it can any [m]
    std::vector<Vec3> left_;          ///< with layers to bear: where the last substep of this step left particles [m]
    double frequencySquared_ = 0;     ///< [1/s²]
    collision::SurfaceTracker tracker_;
    collision::MovingSurface* motion_ = nullptr; ///< null: the body stands still
    std::unique_ptr<Pushing> pushing_;
    bool beginsStatics_ = false; ///< friction has not been fixed since
    bool recalled_ = false;      ///< the same
    int takings_ = 0;            ///< how often dents will be taken back still
    bool rests_ = false;         ///< forces are those of statics
};

} // namespace toile::dynamics
