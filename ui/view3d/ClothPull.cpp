// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/ClothPull.h"

#include "core/picture/Picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ranges>

namespace toile::ui {
namespace {

constexpr double markRadius = 7; // [px]
constexpr int markCorners = 24;
constexpr picture::Colour markColour{0.93F, 0.33F, 0.16F};
constexpr double pinRadius = 5, bodyPinRadius = 8;        // [px]
constexpr picture::Colour pinColour{0.78F, 0.16F, 0.16F}; // as in the pattern view

/// Where the cloth is that is held, to the next vertex.
std::optional<Vec3> nearestVertex(const picture::RenderScene& scene, const HeldPlace& place) {
    if (!scene.frame) return std::nullopt;
    const simulation::Frame& frame = **scene.frame;
    for (const auto& piece : frame.topology->pieces) {
        if (piece.id != place.piece || piece.vertexCount == 0 || frame.topology->material.empty()) continue;
        const auto vertices = std::views::iota(piece.firstVertex, piece.firstVertex + piece.vertexCount);
        return frame.positions[*std::ranges::min_element(
            vertices, {}, [&](int vertex) { return distance(frame.topology->material[vertex], place.material); })];
    }
    return std::nullopt;
}

/// Faces the eye.
picture::Stroke ringAt(const Vec3& middle, double radius, const picture::Colour& colour, double width,
                       const picture::Camera& camera) {
    const picture::CameraAxes axes = axesOf(camera);
    picture::Stroke ring{{}, colour, width};
    for (int i = 0; i <= markCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / markCorners;
        ring.points.push_back(middle + radius * std::cos(angle) * axes.right + radius * std::sin(angle) * axes.up);
    }
    return ring;
}

} // namespace

void ClothPull::drag(const picture::Camera& camera, picture::Viewport viewport, Vec2 pixel) {
    place_.target = screenToWorld(camera, viewport, pixel, place_.target);
}

std::optional<HeldPlace> placeUnder(const picture::RenderScene& scene, const picture::Ray& ray) {
    if (!scene.frame || !scene.options.cloth) return std::nullopt;
    const simulation::Frame& frame = **scene.frame;
    const auto cloth = pickCloth(ray, frame);
    if (!cloth) return std::nullopt;
    if (scene.body && scene.options.body) {
        const auto body = nearestHit(ray, (*scene.body)->mesh.vertices, (*scene.body)->mesh.triangles);
        if (body && body->distance < cloth->distance) return std::nullopt;
    }
    HeldPlace place{cloth->piece, {}, cloth->point};
    const auto& corners = frame.topology->triangles[cloth->triangle];
    if (!frame.topology->material.empty())
        for (std::size_t i = 0; i < 3; ++i)
            place.material = place.material + cloth->barycentric[i] * frame.topology->material[corners[i]];
    return place;
}

std::optional<std::size_t> pinUnder(const std::vector<HeldPlace>& pins, const picture::Camera& camera,
                                    picture::Viewport viewport, Vec2 pixel) {
    std::optional<std::size_t> nearest;
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pins.size(); ++i) {
        const auto seen = worldToScreen(camera, viewport, pins[i].target);
        if (!seen || distance(seen->pixel, pixel) > markRadius + 2 || seen->depth >= depth) continue;
        nearest = i;
        depth = seen->depth;
    }
    return nearest;
}

std::vector<picture::Stroke> marksOf(const HeldPlace& place, bool inHand, const picture::RenderScene& scene,
                                     const picture::Camera& camera, picture::Viewport viewport) {
    const double radius = markRadius * pixelSize(camera, viewport, place.target);
    std::vector<picture::Stroke> marks{ringAt(place.target, radius, markColour, inHand ? 4.0 : 2.0, camera)};
    if (const auto cloth = nearestVertex(scene, place); cloth && distance(*cloth, place.target) > 2 * radius)
        marks.push_back({{*cloth, place.target + (*cloth - place.target) * (radius / distance(*cloth, place.target))},
                         markColour,
                         1.5});
    return marks;
}

std::vector<picture::Stroke> marksOfPins(const simulation::Frame& frame, const picture::Camera& camera,
                                         picture::Viewport viewport) {
    std::vector<picture::Stroke> marks;
    for (const auto& [vertex, toBody] : frame.topology->pins) {
        const Vec3& at = frame.positions[vertex];
        const double pixel = pixelSize(camera, viewport, at);
        marks.push_back(ringAt(at, pinRadius * pixel, pinColour, 2, camera));
        if (toBody) marks.push_back(ringAt(at, bodyPinRadius * pixel, pinColour, 2, camera));
    }
    return marks;
}

} // namespace toile::ui
