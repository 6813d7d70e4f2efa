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

    const bool fallsAnew = from == GoesOn::asSewn && sameBody && after.mayFallAnew(before);
    std::vector<std::vector<Vec3>> drapes{before.shownNodes()};
    if (fallsAnew) drapes.push_back(before.sewnNodes_);
    std::vector<std::vector<Vec3>> carried = after.carriedFrom(before, std::move(drapes));
    after.state_.positions = particlePositions(after.garment_->particles, carried.back());
    if (fallsAnew) {
        after.shown_ = std::move(carried[0]);
        after.sewnNodes_ = std::move(carried[1]);
    }
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
    const auto nodesOf = [](const Simulation& s) {
        return static_cast<double>(s.garment_->particles.particleOf.size());
    };
    after.leaps_ = !after.goesOnAsItLay_ || nodesOf(after) > finer * nodesOf(before);
    after.sewnTime_ = after.state_.time;
    if (auto kept = after.keepSewn(before); !kept) return tl::unexpected(kept.error());
    after.beginToSew();
    after.rebuildPlan();
    return after;
}

/// All that is not closed, from where it is.
void Simulation::beginToSew() {
    std::ranges::fill(seamStart_, -1);
    for (TackState& tack : tacks_)
        if (!tack.closed) tack.start = -1;
    startDue();
}

/// What was sewn and is closed still, whatever its order, where layers are kept apart: contact would part its sides,
/// and cloth beside them cross, before they are sewn again. Elsewhere they are in a frame step.
Result<void> Simulation::keepSewn(const Simulation& before) {
    if (!scene_.settings.selfContact || before.scene_.paper) return {};
    const std::vector<bool> merged = mergedIn(before, scene_.pattern);
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (merged[seam]) startSeam(seam);
    const auto& old = before.scene_.pattern.tacks;
    for (std::size_t tack = 0; tack < tacks_.size(); ++tack) {
        const auto found = std::ranges::find(old, scene_.pattern.tacks[tack].id, &pattern::Tack::id);
        if (found != old.end() && before.tacks_[found - old.begin()].closed) startTack(tack);
    }
    if (auto done = mergeReadySeams(); !done) return tl::unexpected(done.error());
    (void)closeReadyTacks();
    return {};
}

/// The nodes of this garment where those of another lay, in each of its drapes; of pieces that it has not, where they
/// are placed.
std::vector<std::vector<Vec3>> Simulation::carriedFrom(const Simulation& before,
                                                       std::vector<std::vector<Vec3>> drapes) const {
    std::vector<std::vector<Vec3>> carried(drapes.size(), nodePositions());
    for (std::size_t piece = 0; piece < scene_.pattern.pieces.size(); ++piece) {
        const auto& old = before.scene_.pattern.pieces;
        const auto found = std::ranges::find_if(
            old, [&](const auto& candidate) { return candidate->id == scene_.pattern.pieces[piece]->id; });
        if (found == old.end()) continue;
        const auto from = static_cast<std::size_t>(found - old.begin());
        const meshing::PieceMesh& oldMesh = before.garment_->mesh->pieces[from];
        const auto ofPiece = [&](const std::vector<Vec3>& drape) {
            return std::span(drape).subspan(before.garment_->particles.firstNode[from], oldMesh.nodes.size());
        };
        const DrapedPiece draped(oldMesh, ofPiece(drapes[0]));
        const std::vector<Vec2>& nodes = garment_->mesh->pieces[piece].nodes;
        for (std::size_t node = 0; node < nodes.size(); ++node) {
            const MaterialPlace place = draped.placeOf(nodes[node]);
            for (std::size_t drape = 0; drape < drapes.size(); ++drape)
                carried[drape][garment_->particles.firstNode[piece] + node] = place.in(ofPiece(drapes[drape]));
        }
    }
    for (std::vector<Vec3>& nodes : carried)
        joinSewn(*garment_->mesh, mergedIn(before, scene_.pattern), partedSides, nodes);
    return carried;
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

/// Something else than its weight moves the garment from now on: from where it is seen.
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

/// After a frame step. Also what does not come to rest; and what has not closed at once, as seams of several orders
/// that were not kept, is sewn again from where it is seen.
void Simulation::showWhatRests() {
    if (!fallsUnseen()) return;
    if (phase_ == Phase::sewing) {
        lieAsSeen();
        beginToSew();
        goesOnAsItLay_ = false;
        rebuildPlan();
    } else if (rests() || state_.time > settledBy()) {
        beSeen();
    }
}

} // namespace toile::simulation
