// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SceneParts.h"

#include "core/pattern/PatternCheck.h"
#include "core/simulation/SceneCheck.h"
#include "core/simulation/SceneMemory.h"

#include <algorithm>

namespace toile::simulation {
namespace {

/// The first error becomes the answer.
Result<void> judged(const std::vector<pattern::Problem>& problems) {
    const auto error = std::ranges::find_if(problems, &pattern::Problem::isError);
    if (error == problems.end()) return {};
    return fail(ErrorCode::invalidInput, error->text, error->place);
}

Result<std::shared_ptr<const collision::BodySurface>> surfaceOf(const Scene& scene) {
    if (!scene.body) return nullptr;
    auto surface = collision::BodySurface::create((*scene.body)->mesh);
    if (!surface) return tl::unexpected(surface.error());
    return std::make_shared<const collision::BodySurface>(std::move(*surface));
}

Result<Garment> flatGarment(const Scene& scene, const MeshOverrides& overrides) {
    MeshOverrides asked = overrides;
    if (scene.paper && !asked.rule) asked.rule = pattern::LineRule::paper;
    const auto input = meshInputOf(scene.pattern, asked);
    if (!input) return tl::unexpected(input.error());
    auto mesh = meshing::meshGarment(*input);
    if (!mesh) return tl::unexpected(mesh.error());
    if (auto fits = checkedMemory(scene, *mesh); !fits) return tl::unexpected(fits.error());
    std::vector<bool> merged(mesh->seams.size(), false);
    return makeGarment(scene.pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), std::move(merged), scene.paper);
}

/// The paper's way knows seams alone.
std::vector<TackState> threadsOf(const Scene& scene, const Garment& garment) {
    if (scene.paper) return {};
    return tacksOf(scene.pattern, *garment.mesh, TackSettings{});
}

} // namespace

Result<SceneParts> partsOf(const Scene& scene, const MeshOverrides& overrides,
                           std::shared_ptr<const collision::BodySurface> standing) {
    if (auto sound = judged(checkScene(scene.settings)); !sound) return tl::unexpected(sound.error());
    if (auto sound = judged(pattern::checkPattern(scene.pattern)); !sound) return tl::unexpected(sound.error());
    if (!standing) {
        auto surface = surfaceOf(scene);
        if (!surface) return tl::unexpected(surface.error());
        standing = std::move(*surface);
    }
    auto garment = flatGarment(scene, overrides);
    if (!garment) return tl::unexpected(garment.error());
    std::vector<TackState> tacks = threadsOf(scene, *garment);
    return SceneParts{std::move(*garment), std::move(tacks), std::move(standing)};
}

} // namespace toile::simulation
