// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/CarryOver.h"
#include "core/simulation/Simulation.h"

#include <algorithm>

/// A garment whose document has changed goes on.
namespace toile::simulation {
namespace {

/// By which the sides of a merged seam may part when they are carried over to another mesh: along a curve their chords
/// rise, and corners of both sides that a coarse mesh sews to each other are a few millimetres apart [m].
constexpr double partedSides = 0.005;

/// So many times the nodes of the mesh before are more than what an edit adds.
constexpr double finer = 1.5;

/// Which seams of a pattern are merged in a simulation of the pattern as it was before. What falls anew was sewn, even
/// if it has not made a step since.
std::vector<bool> mergedIn(const Simulation& before, const pattern::Pattern& pattern) {
    const std::vector<pattern::Seam>& old = before.scene().pattern.seams;
    std::vector<bool> merged;
    for (const pattern::Seam& seam : pattern.seams) {
        const auto found = std::ranges::find(old, seam.id, &pattern::Seam::id);
        merged.push_back(found != old.end() && (before.fallsUnseen() || before.seams()[found - old.begin()].merged));
    }
    return merged;
}

} // namespace

Result<Simulation> Simulation::continued(Scene scene, const Simulation& before, const MeshOverrides& overrides,
                                         GoesOn from) {
    const bool sameBody = scene.body && before.scene_.body && scene.body->sameAs(*before.scene_.body);
    auto parts = partsOf(scene, overrides, sameBody ? before.body_ : nullptr);
    if (!parts) return tl::unexpected(parts.error());
    Simulation after(std::move(scene), std::move(*parts), overrides);

    std::vector<Vec3> nodes = after.carriedFrom(before, before.shownNodes());
    const bool fallsAnew = from == GoesOn::asSewn && sameBody && after.mayFallAnew(before);
    if (fallsAnew) {
        after.sewnNodes_ = after.carriedFrom(before, before.sewnNodes_);
        after.shown_ = std::exchange(nodes, after.sewnNodes_);
    }
    after.state_.positions = particlePositions(after.garment_->particles, nodes);
    after.state_.time = before.state_.time;
    after.steps_ = before.steps_;
    after.team_ = before.team_;
    after.sharing_ = before.sharing_;
    after.teamTrial_ = before.teamTrial_;
    after.grips_ = before.grips_;
    after.drapingMethod_ = before.drapingMethod_;
    after.forced_ = before.forced_;
    if (sameBody) {
        after.motion_ = before.motion_;
        after.movedBody_ = before.movedBody_;
        after.pinToBody();
    }
    after.goesOnAsItLay_ = !fallsAnew && (before.phase_ == Phase::draping || before.goesOnAsItLay_);
    after.settles_ = after.settles_ || after.goesOnAsItLay_;
    const std::size_t drapedNodes = before.garment_->particles.particleOf.size();
    after.leaps_ =
        !after.goesOnAsItLay_ || static_cast<double>(nodes.size()) > finer * static_cast<double>(drapedNodes);
    after.sewnTime_ = after.state_.time;
    after.seamStart_.assign(after.seams_.size(), -1);
    for (TackState& tack : after.tacks_) tack.start = -1;
    after.startDue();
    after.rebuildPlan();
    return after;
}

/// The nodes of this garment where those of another were draped; of pieces that it has not, where they are placed.
std::vector<Vec3> Simulation::carriedFrom(const Simulation& before, std::span<const Vec3> draped) const {
    std::vector<Vec3> nodes = nodePositions();
    for (std::size_t piece = 0; piece < scene_.pattern.pieces.size(); ++piece) {
        const auto& old = before.scene_.pattern.pieces;
        const auto found = std::ranges::find_if(
            old, [&](const auto& candidate) { return candidate->id == scene_.pattern.pieces[piece]->id; });
        if (found == old.end()) continue;
        const auto from = static_cast<std::size_t>(found - old.begin());
        const meshing::PieceMesh& oldMesh = before.garment_->mesh->pieces[from];
        const DrapedPiece drape(oldMesh,
                                draped.subspan(before.garment_->particles.firstNode[from], oldMesh.nodes.size()));
        const meshing::PieceMesh& mesh = garment_->mesh->pieces[piece];
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
            nodes[garment_->particles.firstNode[piece] + node] = drape.at(mesh.nodes[node]);
    }
    joinSewn(*garment_->mesh, mergedIn(before, scene_.pattern), partedSides, nodes);
    return nodes;
}

/// Before it has made a step. What is pinned or frozen stays where it lies now; a piece or a seam that is new has to be
/// put on.
bool Simulation::mayFallAnew(const Simulation& before) const {
    const auto& pieces = scene_.pattern.pieces;
    const bool samePieces = std::ranges::equal(pieces, before.scene_.pattern.pieces,
                                               [](const auto& a, const auto& b) { return a->id == b->id; });
    const std::vector<bool> merged = mergedIn(before, scene_.pattern);
    return !before.sewnNodes_.empty() && samePieces && std::ranges::find(merged, false) == merged.end() &&
           garment_->model.pinned.empty() && garment_->pinnedToBody.empty() && before.grips_->empty() &&
           !before.motion_ && !before.movedBody_ && before.drapingMethod_ == dynamics::Method::xpbd;
}

/// When the last seam has just been closed. What is sewn from where a drape lay has been moved by its weight before.
void Simulation::noteSewn() {
    if (!goesOnAsItLay_ && grips_->empty() && !scene_.paper) sewnNodes_ = nodePositions();
}

std::vector<Vec3> Simulation::shownNodes() const {
    return shown_.empty() ? nodePositions() : shown_;
}

void Simulation::lieAsSeen() {
    sewnNodes_.clear();
    if (shown_.empty()) return;
    state_.positions = particlePositions(garment_->particles, std::exchange(shown_, {}));
    std::ranges::fill(state_.velocities, Vec3{});
    sewnTime_ = state_.time;
    goesOnAsItLay_ = settles_ = true;
    leaps_ = false;
    if (phase_ == Phase::draping) phase_ = Phase::shaking;
    rebuildPlan();
}

/// Also what does not come to rest, and what has to be sewn after all.
void Simulation::showWhatRests() {
    if (phase_ == Phase::sewing) sewnNodes_.clear();
    if (phase_ == Phase::sewing || rests() || state_.time > settledBy()) shown_.clear();
}

} // namespace toile::simulation
