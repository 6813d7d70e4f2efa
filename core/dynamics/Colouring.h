// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

namespace toile::dynamics {

/// Elements of a colour share no particle, but for those of the last, the rest.
constexpr int lastColour = 63;

/// The colour of each element: greedy in the given order, so the same input always gives the same colours.
template <class Element, class ParticlesOf>
std::vector<int> coloursOf(const std::vector<Element>& elements, int particleCount, ParticlesOf particlesOf) {
    std::vector<std::uint64_t> used(particleCount, 0);
    std::vector<int> colours;
    colours.reserve(elements.size());
    for (const Element& element : elements) {
        std::uint64_t taken = 0;
        for (int p : particlesOf(element)) taken |= used[p];
        colours.push_back(std::min(std::countr_one(taken), lastColour));
        for (int p : particlesOf(element)) used[p] |= std::uint64_t{1} << colours.back();
    }
    return colours;
}

/// Indices of the elements, colour by colour.
[[nodiscard]] inline std::vector<int> orderByColour(const std::vector<int>& colours) {
    std::vector<int> order(colours.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int e) { return colours[e]; });
    return order;
}

template <class Element, class ParticlesOf>
std::vector<int> colouredOrder(const std::vector<Element>& elements, int particleCount, ParticlesOf particlesOf) {
    return orderByColour(coloursOf(elements, particleCount, particlesOf));
}

/// The same order in groups of at most `most` elements that share no particle.
template <class Element, class ParticlesOf>
std::vector<std::vector<int>> colouredGroups(const std::vector<Element>& elements, int particleCount, int most,
                                             ParticlesOf particlesOf) {
    const std::vector<int> colours = coloursOf(elements, particleCount, particlesOf);
    std::vector<std::vector<int>> groups;
    int colour = -1;
    for (int e : orderByColour(colours)) {
        const bool full = groups.empty() || std::ssize(groups.back()) == most;
        if (full || colours[e] != colour || colours[e] == lastColour) groups.emplace_back();
        colour = colours[e];
        groups.back().push_back(e);
    }
    return groups;
}

template <class Element>
std::vector<Element> inOrder(const std::vector<Element>& elements, const std::vector<int>& order) {
    std::vector<Element> sorted;
    sorted.reserve(elements.size());
    for (int e : order) sorted.push_back(elements[e]);
    return sorted;
}

} // namespace toile::dynamics
