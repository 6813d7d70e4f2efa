// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

namespace toile::dynamics {

/// The order of elements by colour: elements of a colour share no particle (but for the 64th, the rest).
/// Greedy in the given order, so the same input always gives the same order.
template <class Element, class ParticlesOf>
std::vector<int> colouredOrder(const std::vector<Element>& elements, int particleCount, ParticlesOf particlesOf) {
    std::vector<std::uint64_t> used(particleCount, 0);
    std::vector<int> colour(elements.size()), order(elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
        std::uint64_t taken = 0;
        for (int p : particlesOf(elements[e])) taken |= used[p];
        colour[e] = std::min(std::countr_one(taken), 63);
        for (int p : particlesOf(elements[e])) used[p] |= std::uint64_t{1} << colour[e];
    }
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int e) { return colour[e]; });
    return order;
}

template <class Element>
std::vector<Element> inOrder(const std::vector<Element>& elements, const std::vector<int>& order) {
    std::vector<Element> sorted;
    sorted.reserve(elements.size());
    for (int e : order) sorted.push_back(elements[e]);
    return sorted;
}

} // namespace toile::dynamics
