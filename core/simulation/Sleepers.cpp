// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sleepers.h"

#include "core/base/Contracts.h"
#include "core/geometry/TriangleMesh.h"
#include "core/simulation/Speeds.h"

#include <algorithm>
#include <numeric>

namespace toile::simulation {
namespace {

/// For each piece the number of a piece of its group, the same for all of them.
std::vector<int> groupsOf(const meshing::GarmentMesh& mesh, std::span<const TackState> tacks) {
    std::vector<int> group(mesh.pieces.size());
    std::iota(group.begin(), group.end(), 0);
    const auto join = [&](int a, int b) {
        if (group[a] != group[b]) std::ranges::replace(group, int(group[b]), int(group[a]));
    };
    for (const auto& seam : mesh.seams)
        for (const auto& [a, b] : seam.pairs) join(a.piece, b.piece);
    for (const TackState& tack : tacks) join(tack.ends[0].piece, tack.ends[1].piece);
    return group;
}

void appendParticles(const Garment& garment, int piece, std::vector<int>& particles) {
    const auto first = garment.particles.particleOf.begin() + garment.particles.firstNode[piece];
    particles.insert(particles.end(), first, first + std::ssize(garment.mesh->pieces[piece].nodes));
}

template <class T>
std::vector<T> gathered(const std::vector<int>& particles, std::span<const T> all) {
    std::vector<T> some;
    some.reserve(particles.size());
    for (const int particle : particles) some.push_back(all[particle]);
    return some;
}

bool areNear(const geometry::Box3& a, const geometry::Box3& b, double reach) {
    return a.low.x < b.high.x + reach && b.low.x < a.high.x + reach && a.low.y < b.high.y + reach &&
           b.low.y < a.high.y + reach && a.low.z < b.high.z + reach && b.low.z < a.high.z + reach;
}

} // namespace

Sleepers::Sleepers(const Garment& garment, std::span<const TackState> tacks)
    : particles_(garment.particles.particleCount) {
    const std::vector<int> groupOf = groupsOf(*garment.mesh, tacks);
    for (int root = 0; root < std::ssize(groupOf); ++root) {
        Group group;
        for (int piece = 0; piece < std::ssize(groupOf); ++piece)
            if (groupOf[piece] == root) {
                group.pieces.push_back(piece);
                appendParticles(garment, piece, group.particles);
            }
        std::ranges::sort(group.particles);
        const auto [first, last] = std::ranges::unique(group.particles);
        group.particles.erase(first, last);
        if (!group.pieces.empty()) groups_.push_back(std::move(group));
    }
    if (groups_.size() < 2) groups_.clear();
}

bool Sleepers::note(const Garment& garment, std::span<const Vec3> before, std::span<const Vec3> after, double duration,
                    std::optional<double> reach) {
    std::vector<bool> sleeps;
    for (Group& group : groups_) {
        const Speeds speeds = speedsOf(gathered<double>(group.particles, garment.model.mass),
                                       gathered(group.particles, before), gathered(group.particles, after), duration);
        group.stillTime = speeds.areStill() ? group.stillTime + duration : 0;
        sleeps.push_back(group.stillTime >= beforeSleep);
    }
    if (std::ranges::count(sleeps, false) == 0) return false;
    if (reach) keepAwakeNear(after, *reach, sleeps);
    bool changed = false;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        Group& group = groups_[g];
        if (group.isAsleep == sleeps[g]) continue;
        if (group.isAsleep) group.stillTime = 0;
        group.isAsleep = sleeps[g];
        changed = true;
    }
    return changed;
}

/// Who is near one that is awake stays awake, and so does who is near that.
void Sleepers::keepAwakeNear(std::span<const Vec3> positions, double reach, std::vector<bool>& sleeps) const {
    std::vector<geometry::Box3> boxes;
    for (const Group& group : groups_) boxes.push_back(geometry::boundsOf(gathered(group.particles, positions)));
    for (bool found = true; std::exchange(found, false);)
        for (std::size_t awake = 0; awake < boxes.size(); ++awake)
            for (std::size_t g = 0; g < boxes.size() && !sleeps[awake]; ++g)
                if (sleeps[g] && areNear(boxes[awake], boxes[g], reach)) {
                    sleeps[g] = false;
                    found = true;
                }
}

void Sleepers::wake() {
    for (Group& group : groups_) {
        group.stillTime = 0;
        group.isAsleep = false;
    }
}

bool Sleepers::isAsleep(int piece) const {
    return std::ranges::any_of(
        groups_, [&](const Group& group) { return group.isAsleep && std::ranges::binary_search(group.pieces, piece); });
}

std::vector<int> Sleepers::pieces() const {
    std::vector<int> pieces;
    for (const Group& group : groups_)
        if (group.isAsleep) pieces.insert(pieces.end(), group.pieces.begin(), group.pieces.end());
    std::ranges::sort(pieces);
    return pieces;
}

double Sleepers::share() const {
    std::size_t asleep = 0;
    for (const Group& group : groups_)
        if (group.isAsleep) asleep += group.particles.size();
    return static_cast<double>(asleep) / particles_;
}

Garment Sleepers::awakeOf(const Garment& garment) const {
    Garment awake = garment;
    std::vector<bool> sleeps(particles_, false);
    std::vector<int>& pinned = awake.model.pinned;
    for (const Group& group : groups_) {
        if (!group.isAsleep) continue;
        for (const int particle : group.particles) sleeps[particle] = true;
        pinned.insert(pinned.end(), group.particles.begin(), group.particles.end());
    }
    std::ranges::sort(pinned);
    const auto [first, last] = std::ranges::unique(pinned);
    pinned.erase(first, last);

    cloth::ClothModel& model = awake.model; // an element is of one group, as its first particle is
    for (auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        std::erase_if(*springs, [&](const cloth::Spring& spring) { return sleeps[spring.a]; });
    for (auto* stencils : {&model.bending, &model.twist})
        std::erase_if(*stencils, [&](const cloth::Stencil& stencil) { return sleeps[stencil.particles[0]]; });
    std::erase_if(model.triangles, [&](const auto& triangle) { return sleeps[triangle.particles[0]]; });
    std::erase_if(model.cells, [&](const auto& cell) { return sleeps[cell.particles[0]]; });
    return awake;
}

} // namespace toile::simulation
