// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/lean/Features.h"

#include "core/simulation/Simulation.h"
#include "core/study/lean/FeatureChapters.h"
#include "core/study/lean/FeatureScenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::study::lean {

using simulation::Scene;

std::string_view nameOf(Role role) {
    switch (role) {
    case Role::absent: return "absent";
    case Role::unused: return "unused";
    case Role::forced: return "forced";
    case Role::inUse: return "in use";
    }
    return "";
}

std::vector<Feature> allFeatures(bool quick) {
    const double spacing = quick ? 0.02 : 0.01;
    std::vector<Feature> features;
    for (const auto& chapter : {stageFeatures(spacing), elementFeatures(spacing), integratorFeatures(spacing)})
        features.insert(features.end(), chapter.begin(), chapter.end());
    return features;
}

Feature garmentFeature(const std::string& name, const Scene& scene) {
    Scene off = scene;
    off.settings.selfContact = false;
    Feature feature{name, "self-contact", {{Role::absent, "without self-contact", off}}};
    if (const auto simulation = simulation::Simulation::create(off)) {
        const auto isLeftOut = [&](std::string_view stage) { return !simulation->plan().find(stage); };
        std::vector<std::string> idle{"hands"};
        if (scene.pattern.seams.empty())
            for (const char* stage : {"seams", "seams that meet"})
                if (isLeftOut(stage)) idle.emplace_back(stage);
        feature.variants.push_back(
            {Role::forced, fmt::format("{} built all the same", fmt::join(idle, ", ")), off, 0, idle});
    }
    feature.variants.push_back({Role::inUse, "with self-contact", asking(scene)});
    return feature;
}

} // namespace toile::study::lean
