// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"

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

/// Where colours begin in that order, and the end; each element of the last is on its own.
[[nodiscard]] inline std::vector<int> bordersOfColours(std::vector<int> colours) {
    std::ranges::sort(colours);
    std::vector<int> borders{0};
    for (std::size_t i = 1; i < colours.size(); ++i)
        if (colours[i] != colours[i - 1] || colours[i] == lastColour) borders.push_back(static_cast<int>(i));
    if (!colours.empty()) borders.push_back(static_cast<int>(colours.size()));
    return borders;
}

/// The same order in groups of at most `most` elements that share no particle, and between which groups colours change.
struct ColouredGroups {
    std::vector<std::vector<int>> groups;
    std::vector<int> borders{0}; ///< groups between two of them share no particle
};
template <class Element, class ParticlesOf>
ColouredGroups colouredGroups(const std::vector<Element>& elements, int particleCount, int most,
                              ParticlesOf particlesOf) {
    const std::vector<int> colours = coloursOf(elements, particleCount, particlesOf);
    ColouredGroups found;
    std::vector<std::vector<int>>& groups = found.groups;
    int colour = -1;
    for (int e : orderByColour(colours)) {
        const bool isOther = !groups.empty() && (colours[e] != colour || colours[e] == lastColour);
        if (isOther) found.borders.push_back(static_cast<int>(groups.size()));
        if (groups.empty() || isOther || std::ssize(groups.back()) == most) groups.emplace_back();
        colour = colours[e];
        groups.back().push_back(e);
    }
    if (!groups.empty()) found.borders.push_back(static_cast<int>(groups.size()));
    return found;
}

/// Does work(begin, end) with all elements in order; those between two borders are shared out where each part has at
/// least `least` of them.
template <class Work>
void byColours(Team* team, const std::vector<int>& borders, int least, const Work& work) {
    for (std::size_t i = 1; i < borders.size(); ++i) {
        const int first = borders[i - 1];
        inParts(team, borders[i] - first, least, [&](int begin, int end) { work(first + begin, first + end); });
    }
}

template <class Element>
std::vector<Element> inOrder(const std::vector<Element>& elements, const std::vector<int>& order) {
    std::vector<Element> sorted;
    sorted.reserve(elements.size());
    for (int e : order) sorted.push_back(elements[e]);
    return sorted;
}

} // namespace toile::dynamics
