// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/collision/SelfProximity.h"
#include "core/dynamics/Friction.h"
#include "core/dynamics/Stage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace toile::dynamics {

/// A cloth as a surface that must not pass through itself. Everything but the triangles is per particle.
struct ClothSurface {
    std::vector<std::array<int, 3>> triangles; ///< three different particles each
    std::vector<double> halfThickness;         ///< [m]
    std::vector<double> friction;              ///< μ of the cloth [–]
    std::vector<double>
        room; ///< at rest, to the nearest element that does not end here [m]: there is no push within it
    std::vector<int> layers =
        {}; ///< of each triangle; the higher lies on the right side of the lower. Empty = all alike
    std::vector<int> becomes =
        {}; ///< which particle it will be part of when open seams are closed; empty = none is open
    std::vector<int> pieces = {}; ///< of each triangle; empty where none pass
    std::vector<std::array<int, 2>> passing =
        {}; ///< pieces, the lower first, that are let through each other, as they began in each other
};

struct SelfContactSettings {
    double slack = 0.002;      ///< a particle may leave the way foreseen by this before neighbours are sought anew [m]
    double slackOfRoom = 0.2;  ///< and by so much of the middle room of particles: where more is allowed, fine cloth
                               ///< is watched against itself cell by cell [–]
    double pushOutSpeed = 0.5; ///< at most, of layers that are too near at the start of a substep [m/s]
    double pushOutTime = 0.01; ///< in which a small overlap falls to 1/e [s]
    double keptDistance = 0.1; ///< part of its distance that a pair keeps in one substep whatever pulls [–]
    double closest = 1e-6;     ///< layers are never let nearer than this by a substep [m]
    int sweeps = 2;            ///< over the pairs that touch, in a substep
    std::size_t mostPairs = 3'000'000; ///< watched at a time [–]: half a gigabyte

    double stiffness = 2.5e6;       ///< of statics, per mass of a particle [1/s²]: 500 Pa press 0.1 kg/m² to 0.8 of
                                    ///< its thickness of 0.5 mm, and never to nothing
    double frictionGive = 1e-4;     ///< way over which statics builds friction up to μN [m]
    double staticMove = 0.0025;     ///< of a particle in one iteration of statics, at most [m]
    double staticMoveOfRoom = 0.18; ///< and so much of the middle room of particles [–]
    double staticClosest = 1e-8; ///< layers are never let nearer than this by an iteration of statics: where substeps
                                 ///< have pressed them to `closest`, none could move if all had to keep it [m]
};

/// Keeps the layers of a cloth apart by its thickness, with Coulomb friction between them. docs/collision.md
///
/// Layers that are apart at the start of a substep are apart throughout: every pair of elements that could
/// meet has a direction along which it is separated, at the start, at the end, and so on all straight ways in
/// between. Layers that have crossed already are drawn apart, and the guarantee holds for the others.
class SelfContact final : public Stage {
public:
    /// The model is borrowed and outlives the stage.
    SelfContact(const cloth::ClothModel& model, ClothSurface surface, SelfContactSettings settings = {});

    [[nodiscard]] std::string_view name() const override { return "self-contact"; }
    [[nodiscard]] std::size_t bytes() const override;
    /// Where even the pairs of a single substep would have been more than `mostPairs`.
    [[nodiscard]] int heldBack() const override { return heldBack_; }

    void beginStep(const ParticleState& state, double duration) override;
    void project(Substep& substep) override;
    void hold(std::span<const Vec3> from, std::span<Vec3> positions) override;

    void fixFriction(std::span<const Vec3> positions) override;
    void easeFriction(double part) override;
    /// Finds the pairs within reach. Until the next call no particle can move farther than staticMove, or a part of
    /// it where pairs would be too many, and no pair can cross: the energy is infinite there.
    void beginIteration(std::span<const Vec3> positions) override;
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, HessianSink& sink) const override;
    [[nodiscard]] double largestFrequencySquared() const override;

    /// Edges that passed through triangles when neighbours were last sought.
    [[nodiscard]] int crossings() const { return static_cast<int>(piercings_.size()); }
    /// Where they are: the middles of the edges [m].
    [[nodiscard]] std::vector<Vec3> crossingPlaces(std::span<const Vec3> positions) const;
    /// No layer has crossed another since the last one that had was drawn apart, no seam is open and no piece passes.
    [[nodiscard]] bool guaranteed() const {
        return !mayPierce_ && surface_.becomes.empty() && surface_.passing.empty();
    }
    /// How often neighbours were sought, and how many pairs are near now.
    [[nodiscard]] int searches() const { return searches_; }
    /// How often they were sought only round the particles that had strayed.
    [[nodiscard]] int renewals() const { return renewals_; }
    [[nodiscard]] std::size_t nearPairs() const { return watches_.size(); }
    /// How often `mostPairs` would have been exceeded, so that less was looked ahead.
    [[nodiscard]] int shortSearches() const { return shortSearches_; }

private:
    /// What every substep reads of every pair that is awake.
    struct Watch {
        collision::ElementPair elements;
        double target = 0; ///< distance to be kept [m]
        double known = 0;  ///< distance at from_ [m]
        double before = 0,
               now = 0;          ///< the distance is at least this, at the start of the substep and at its end [m]
        std::uint64_t order = 0; ///< in which pairs are watched, and pushed one after the other
    };
    /// What is read of every pair to see whether it must be woken.
    struct Margin {
        double distance = 0; ///< beyond its target, at from_ [m]
        double way = 0;      ///< of its ends against each other, if all go the ways foreseen [m]
        bool isAwake = false;
    };
    /// What is read only of pairs that may touch.
    struct Contact {
        Vec3 direction;                  ///< unit, from the second element to the first; zero = not asked yet
        double start = 0;                ///< distance at the start of the substep [m]
        std::array<double, 4> weights{}; ///< of the shortest way then
        double friction = 0;             ///< √(μ₁μ₂) [–]
        double normalForce = 0; ///< running mean of the substeps that pushed it, then as friction was fixed [N]
    };
    /// A pair that an iteration of statics may bring to its target.
    struct Coming {
        std::size_t pair = 0;
        double distance = 0; ///< beyond its target, where the iteration began [m]
    };
    /// Friction of a pair, as it was fixed for statics.
    struct Rubbing {
        std::array<int, 4> vertices{};
        std::array<double, 4> weights{}; ///< of the way between its elements
        Vec3 direction;                  ///< of that way, unit
        double force = 0;                ///< μN [N]
    };

    /// Elements nearer than this have no direction that could be trusted: they count as crossed [m].
    static constexpr double noDistance = 1e-9;
    /// Of what should be looked ahead: where there are too many pairs for even so little, nothing is moved [–].
    static constexpr double leastAhead = 1e-3;
    /// Pairs and particles in a thread's part at least: they take some microseconds.
    static constexpr int leastPairs = 500, leastParticles = 2000;
    /// Of what is to be kept, so that rounding does not ask for more [–].
    static constexpr double justEnough = 0.99;

    // SelfContactNeighbours.cpp
    void prepareSearch(std::span<const Vec3> positions);
    [[nodiscard]] std::set<collision::ElementPair> crossedPairs() const;
    [[nodiscard]] bool watch(const collision::SelfProximity::Pairs& pairs, std::span<const Vec3> positions);
    using Pressed = std::map<collision::ElementPair, double>; ///< normal forces of pairs that had one [N]
    void add(const collision::SelfProximity::Near& near, const Pressed& pressed);
    [[nodiscard]] bool isIgnored(const collision::ElementPair& pair) const;
    [[nodiscard]] bool willBeOne(const collision::ElementPair& pair) const;
    [[nodiscard]] bool passes(const collision::ElementPair& pair) const;
    [[nodiscard]] Contact contactOf(const collision::ElementPair& pair) const;
    [[nodiscard]] double targetOf(const collision::ElementPair& pair) const;
    [[nodiscard]] double doneAt(double time) const;
    [[nodiscard]] double strayed(const Substep& substep) const;
    [[nodiscard]] bool foresee(const Substep& substep);
    [[nodiscard]] bool seekOnAllWays(Substep& substep);
    void cutWays(double most, Substep& substep) const;
    void standStill(Substep& substep);
    [[nodiscard]] double leastDistance(const Watch& watch, std::span<const Vec3> positions) const;
    void look(const Watch& watch, Contact& contact, std::span<const Vec3> positions) const;
    [[nodiscard]] static double farthestMove(std::span<const Vec3> from, std::span<const Vec3> to);

    // SelfContactRenewal.cpp
    [[nodiscard]] bool renew(const Substep& substep);
    [[nodiscard]] bool foreseeStrayed(const Substep& substep);
    void replaceFlagged(const std::vector<collision::SelfProximity::Near>& found);

    // SelfContactAwake.cpp
    [[nodiscard]] Margin marginOf(const Watch& watch) const;
    void findMargins(Team* team);
    void wake(double strayed, const Substep& substep);
    void keepFlagged(std::span<const std::size_t> from, std::vector<std::size_t>& kept) const;

    // SelfContact.cpp
    [[nodiscard]] bool areAllApart(const Substep& substep);
    void pushApart(Substep& substep);
    [[nodiscard]] bool touches(std::size_t pair, const Substep& substep);
    [[nodiscard]] bool meetsOnTheWay(const Watch& watch, Contact& contact, const Substep& substep) const;
    void push(const Watch& watch, Contact& contact, const ContactPace& pace, Substep& substep) const;
    void move(int particle, const Vec3& by, Substep& substep) const;
    void placeSlave(int slave, std::span<Vec3> positions) const;
    void placeSlaves(std::span<Vec3> positions) const;

    // SelfContactCrossings.cpp
    [[nodiscard]] Vec3 normalOf(int triangle, std::span<const Vec3> positions) const;
    [[nodiscard]] Vec3 orderlyWay(const collision::Piercing& piercing, const Vec3& normal,
                                  std::span<const Vec3> positions) const;
    void findWhatWentThrough();
    [[nodiscard]] Vec3 wayBack(const collision::Piercing& piercing, const Vec3& normal,
                               std::span<const Vec3> positions) const;
    [[nodiscard]] Vec3 shorteningWay(const collision::Piercing& piercing, const Vec3& normal,
                                     std::span<const Vec3> positions) const;
    void findTrianglesOfEdges();
    void seekPiercings(std::span<const Vec3> positions);
    void uncross(Substep& substep) const;

    // SelfContactGuarantee.cpp
    [[nodiscard]] double holdApart(Substep& substep);
    void findUnseparated(const Substep& substep);
    void beginShortening(const Substep& substep);
    [[nodiscard]] double keptOf(double start, double closest) const;
    [[nodiscard]] bool isSeparated(const Watch& watch, Contact& contact, const Substep& substep) const;
    void shorten(const Watch& watch, const Contact& contact, Substep& substep);
    void goPartOfTheWay(int particle, double fraction, Substep& substep);

    // SelfContactStatics.cpp
    void keepNeighbours(std::span<const Vec3> positions);
    void listRubbing();
    void seekForStatics(std::span<const Vec3> positions);
    [[nodiscard]] double stiffnessOf(const Watch& watch) const;
    [[nodiscard]] double storedAt(const Watch& watch, double distance) const;
    [[nodiscard]] double pressureAt(const Watch& watch, double distance) const;
    [[nodiscard]] Vec3 slipOf(const Rubbing& pair, std::span<const Vec3> positions) const;
    [[nodiscard]] bool isFar(const Watch& watch, const Contact& contact, std::span<const Vec3> positions) const;
    template <class Visit>
    void forPressed(std::span<const Vec3> positions, const Visit& visit) const;

    const cloth::ClothModel& model_;
    ClothSurface surface_;
    SelfContactSettings settings_;
    std::vector<double> mass_;                  ///< of particles; of slaves, what their masters make of it [kg]
    std::vector<int> slaveOf_;                  ///< index into model.slaves, −1 = none
    std::vector<std::set<int>> piecesOf_;       ///< of each particle, of a seam's row several; empty where none pass
    double thickest_ = 0;                       ///< largest target [m]
    double mostSlack_ = 0, mostStaticMove_ = 0; ///< of the settings, for this cloth [m]

    std::optional<collision::SelfProximity> proximity_; ///< from the first step on
    std::vector<Watch> watches_;
    std::vector<Contact> contacts_; ///< one per watch
    std::vector<Margin> margins_;   ///< one per watch, or none yet
    struct Replaced {
        std::vector<Watch> watches;
        std::vector<Contact> contacts;
        std::vector<Margin> margins;
    };
    Replaced before_;                ///< a renewal; kept for the memory it has
    std::vector<std::size_t> awake_; ///< pairs that may have come nearer than their target, rising
    std::vector<char> flags_;        ///< of pairs, while some are chosen
    double awakeDone_ = 0,
           awakeStrayed_ = 0; ///< up to which part of the ways, and so far from them [m], the others have not
    std::vector<collision::Piercing> piercings_;
    std::vector<int> hanging_; ///< of each particle, how many hang on it when all edges that pierce are cut
    std::set<collision::ElementPair> crossed_;      ///< pairs that are not held, for an edge to come out of a triangle
    std::vector<std::array<int, 2>> edgeTriangles_; ///< beside each edge, alike at a border; none if layers are alike
    bool mayPierce_ = true;                         ///< until a search has found no piercing
    std::vector<Vec3> from_,
        moves_;                         ///< where particles were when neighbours were sought, the ways foreseen [m]
    std::vector<char> strayed_;         ///< flags of particles, while some are foreseen anew
    std::vector<char> hasStrayed_;      ///< flags of those that were, since ways were foreseen for all
    double fromTime_ = 0, horizon_ = 0; ///< when that was, how long the ways take [s]
    double ahead_ = 1;                  ///< part of what should be looked ahead for which pairs are not too many [–]
    double slack_ = 0, staticMove_ = 0; ///< of the settings, what holds for the pairs watched now [m]
    double foreseenWith_ = 0;           ///< duration of the substep in which ways were last foreseen for all [s]
    double frame_ = 0;                  ///< duration of the step [s]
    double seenUntil_ = 0;              ///< the end of the last substep [s]
    int searches_ = 0, renewals_ = 0, shortSearches_ = 0, heldBack_ = 0;
    std::vector<std::size_t> touching_;     ///< pairs to be pushed in this substep, or to be held apart
    std::vector<Vec3> wanted_;              ///< where particles would go before their ways are shortened [m]
    std::vector<double> fraction_;          ///< of its way that a particle goes; empty until one is shortened
    std::vector<Rubbing> rubbing_;          ///< of statics
    std::vector<double> normalForceBefore_; ///< one per watch: before friction was fixed last [N]
    std::vector<Vec3> iterationStart_;      ///< of statics [m]
    std::vector<Coming> coming_;            ///< of statics, since the iteration began
    bool isComingKnown_ = false;            ///< and of the pairs that are watched
    std::vector<Vec3> anchors_;             ///< where particles were at the start of statics; empty until then [m]
};

/// Of every pair awake in every substep, and therefore inline: by what its ends have moved against each other since
/// neighbours were sought.
inline double SelfContact::leastDistance(const Watch& watch, std::span<const Vec3> positions) const {
    const auto& v = watch.elements.vertices;
    const auto moved = [&](int i) { return positions[v[i]] - from_[v[i]]; };
    const Vec3 a = moved(0), b = moved(1), c = moved(2), d = moved(3);
    const double squared =
        watch.elements.firstCount == 1
            ? std::max({squaredLength(a - b), squaredLength(a - c), squaredLength(a - d)})
            : std::max({squaredLength(a - c), squaredLength(a - d), squaredLength(b - c), squaredLength(b - d)});
    return watch.known - std::sqrt(squared);
}

} // namespace toile::dynamics
