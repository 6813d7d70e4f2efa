// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/VertexMotion.h"
#include "core/simulation/Grips.h"
#include "core/simulation/Scene.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// What a step's parts cost, and that they cost nothing where a scene does not need them.
namespace toile::study::lean {

/// How a scene stands to a part of the step.
enum class Role {
    absent, ///< it does not ask for it
    unused, ///< it asks for it, and the plan sees that it is of no use
    forced, ///< the part is there, and has nothing to do
    inUse
};
[[nodiscard]] std::string_view nameOf(Role role);

/// One way to run a feature's scene.
struct Variant {
    Role role = Role::absent;
    std::string what; ///< "a body 10 m away"
    simulation::Scene scene;
    int like = -1;                        ///< index of the variant whose result it must have, or, in use,
                                          ///< must not have; negative = none
    std::vector<std::string> forced = {}; ///< stages that the plan is told to build
    std::vector<simulation::Grip> holds = {}, letsGo = {}; ///< held all the time; held only before the first step
    std::shared_ptr<const geometry::VertexMotion> motion =
        {}; ///< of the body, from the first step on; null = it stands
};

/// A part of the step: a stage of the plan, elements of the cloth, a setting of the integrator.
struct Feature {
    std::string name;
    std::string part; ///< as the plan calls it; empty = it has no object of its own
    std::vector<Variant> variants;
};

/// All that can be in a step, each on a small scene. quick: on coarse meshes.
[[nodiscard]] std::vector<Feature> allFeatures(bool quick);

/// A garment as it is drawn, with its self-contact on and off, and with what its plan leaves out for want of use
/// built all the same. name: of the document.
[[nodiscard]] Feature garmentFeature(const std::string& name, const simulation::Scene& scene);

} // namespace toile::study::lean
