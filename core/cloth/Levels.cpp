// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Levels.h"

#include <algorithm>
#include <tuple>

namespace toile::cloth {
namespace {

constexpr std::tuple elementArrays{&ClothModel::structural, &ClothModel::shear,     &ClothModel::elastics,
                                   &ClothModel::flexion,    &ClothModel::bending,   &ClothModel::twist,
                                   &ClothModel::hinges,     &ClothModel::triangles, &ClothModel::cells};

template <class Visit>
void forEachArray(const Visit& visit) {
    std::apply([&](auto... arrays) { (visit(arrays), ...); }, elementArrays);
}

std::array<int, 2> particlesOf(const Spring& s) {
    return {s.a, s.b};
}
std::array<int, 4> particlesOf(const Hinge& h) {
    return {h.a, h.b, h.c, h.d};
}
template <class Element>
const auto& particlesOf(const Element& element) {
    return element.particles;
}

} // namespace

std::vector<ClothModel> elementsByLevel(const ClothModel& model, std::span<const int> levelOfParticle, int levels) {
    std::vector<ClothModel> parts(levels);
    for (ClothModel& part : parts) {
        part.mass = model.mass;
        part.tensionCurves = model.tensionCurves;
    }
    forEachArray([&](auto array) {
        for (const auto& element : model.*array) {
            int level = 0;
            for (const int p : particlesOf(element))
                if (p >= 0) level = std::max(level, levelOfParticle[p]);
            (parts[level].*array).push_back(element);
        }
    });
    return parts;
}

std::vector<int> joinedParticles(const ClothModel& model) {
    std::vector<int> joined;
    forEachArray([&](auto array) {
        for (const auto& element : model.*array)
            for (const int p : particlesOf(element))
                if (p >= 0) joined.push_back(p);
    });
    std::ranges::sort(joined);
    const auto [first, last] = std::ranges::unique(joined);
    joined.erase(first, last);
    return joined;
}

} // namespace toile::cloth
