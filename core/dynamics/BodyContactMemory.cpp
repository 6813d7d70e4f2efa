// SPDX-License-Identifier: GPL-3.0-or-later
/// What is known of contact with the body, from one stage to the next.
#include "core/dynamics/BodyContact.h"

#include <algorithm>

namespace toile::dynamics {

ContactMemory BodyContact::memory() const {
    ContactMemory memory;
    memory.forces.reserve(samples_.size());
    memory.takenBack.reserve(samples_.size());
    for (const Sample& sample : samples_) {
        memory.forces.push_back(sample.normalForce);
        memory.takenBack.push_back(sample.takenBack);
    }
    if (pushing_) memory.anchors = pushing_->anchors;
    return memory;
}

bool BodyContact::recall(const ContactMemory& memory) {
    const std::size_t count = samples_.size();
    const bool isOfThese = memory.forces.size() == count && memory.takenBack.size() == count &&
                           (memory.anchors.empty() || memory.anchors.size() == count);
    if (!isOfThese) return false;
    for (std::size_t s = 0; s < count; ++s) {
        samples_[s].normalForce = memory.forces[s];
        samples_[s].takenBack = memory.takenBack[s];
    }
    if (!memory.anchors.empty()) pushing().anchors = memory.anchors;
    recalled_ = true;
    return true;
}

/// Samples of the particles come first; the others stand for places between them, and which of these are looked at
/// changes as cloth and body move.
void BodyContact::goOnFrom(const BodyContact& before, std::span<const Vec3> positions) {
    const auto areAlike = [&](const Sample& a, const Sample& b) {
        return std::ranges::equal(termsOf(a), before.termsOf(b));
    };
    const auto same = std::ranges::mismatch(samples_, before.samples_, areAlike).in1 - samples_.begin();
    ContactMemory memory = before.memory();
    memory.forces.resize(same);
    memory.takenBack.resize(same);
    memory.forces.resize(samples_.size());
    memory.takenBack.resize(samples_.size());
    if (!memory.anchors.empty()) {
        memory.anchors.resize(same);
        for (std::size_t s = same; s < samples_.size(); ++s) memory.anchors.push_back(at(samples_[s], positions));
    }
    (void)recall(memory);
}

} // namespace toile::dynamics
