// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Openings.h"

#include <algorithm>
#include <map>

namespace toile::simulation {
namespace {

/// How many triangles run through each directed edge.
std::map<std::array<int, 2>, int> usesOfEdges(std::span<const std::array<int, 3>> triangles) {
    std::map<std::array<int, 2>, int> uses;
    for (const auto& t : triangles) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    }
    return uses;
}

} // namespace

std::vector<std::array<int, 2>> turnedEdgesOf(std::span<const std::array<int, 3>> triangles) {
    std::vector<std::array<int, 2>> turned;
    for (const auto& [edge, count] : usesOfEdges(triangles))
        if (count > 1) turned.push_back(edge);
    return turned;
}

std::vector<Opening> openingsOf(std::span<const std::array<int, 3>> triangles) {
    const std::map<std::array<int, 2>, int> uses = usesOfEdges(triangles);
    std::multimap<int, int> next; // border edges, from -> to
    for (const auto& [edge, count] : uses) {
        const auto back = uses.find({edge[1], edge[0]});
        const int lonely = count - (back == uses.end() ? 0 : back->second);
        for (int i = 0; i < lonely; ++i) next.emplace(edge[0], edge[1]);
    }
    std::vector<Opening> openings;
    while (!next.empty()) {
        Opening loop;
        auto step = next.begin();
        while (step != next.end()) {
            loop.push_back(step->first);
            const int to = step->second;
            next.erase(step);
            step = next.find(to);
        }
        openings.push_back(std::move(loop));
    }
    return openings;
}

} // namespace toile::simulation
