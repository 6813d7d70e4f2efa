// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/BodyGlb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile::io {
namespace {

using body::Body;
using body::Landmarks;
using body::Limb;
using body::LimbAxis;

constexpr int bodyVersion = 1;

constexpr std::array<std::pair<const char*, Vec3 Landmarks::*>, 15> landmarkNames{{
    {"nape", &Landmarks::nape},
    {"frontNeck", &Landmarks::frontNeck},
    {"neckLeft", &Landmarks::neckLeft},
    {"neckRight", &Landmarks::neckRight},
    {"acromionLeft", &Landmarks::acromionLeft},
    {"acromionRight", &Landmarks::acromionRight},
    {"bustLeft", &Landmarks::bustLeft},
    {"bustRight", &Landmarks::bustRight},
    {"waist", &Landmarks::waist},
    {"hip", &Landmarks::hip},
    {"crotch", &Landmarks::crotch},
    {"wristLeft", &Landmarks::wristLeft},
    {"wristRight", &Landmarks::wristRight},
    {"ankleLeft", &Landmarks::ankleLeft},
    {"ankleRight", &Landmarks::ankleRight},
}};

constexpr std::array<std::pair<const char*, Limb>, 6> limbNames{{
    {"neck", Limb::neck},
    {"torso", Limb::torso},
    {"leftArm", Limb::leftArm},
    {"rightArm", Limb::rightArm},
    {"leftLeg", Limb::leftLeg},
    {"rightLeg", Limb::rightLeg},
}};

Json jsonOf(const Vec3& p) {
    return Json(Json::Array{p.x, p.y, p.z});
}

Json axisJson(const LimbAxis& axis) {
    Json points{Json::Array{}}, json;
    for (const Vec3& p : axis.points) points.push(jsonOf(p));
    json.set("limb", std::ranges::find(limbNames, axis.limb, &std::pair<const char*, Limb>::second)->first);
    json.set("points", std::move(points));
    return json;
}

Json extrasOf(const Body& body) {
    Json landmarks, axes{Json::Array{}}, json;
    for (const auto& [name, member] : landmarkNames) landmarks.set(name, jsonOf(body.landmarks.*member));
    for (const LimbAxis& axis : body.axes) axes.push(axisJson(axis));
    json.set("version", bodyVersion).set("name", body.name);
    json.set("landmarks", std::move(landmarks)).set("axes", std::move(axes));
    return Json(Json::Object{{"toile", Json(Json::Object{{"body", std::move(json)}})}});
}

std::optional<Vec3> pointOf(const Json* json) {
    const Json::Array* items = json ? json->asArray() : nullptr;
    if (!items || items->size() != 3) return std::nullopt;
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        const double* x = (*items)[axis].asNumber();
        if (!x || !std::isfinite(*x)) return std::nullopt;
        p[axis] = *x;
    }
    return p;
}

std::optional<LimbAxis> axisOf(const Json& json) {
    const Json *name = json.find("limb"), *points = json.find("points");
    if (!name || !name->asString() || !points || !points->asArray()) return std::nullopt;
    const auto known = std::ranges::find_if(limbNames, [&](const auto& n) { return *name->asString() == n.first; });
    if (known == limbNames.end()) return std::nullopt;
    LimbAxis axis{known->second, {}};
    for (const Json& item : *points->asArray()) {
        const auto p = pointOf(&item);
        if (!p) return std::nullopt;
        axis.points.push_back(*p);
    }
    return axis;
}

const Json* memberOf(const Json* json, std::initializer_list<const char*> path) {
    for (const char* key : path)
        if (json) json = json->find(key);
    return json;
}

tl::unexpected<Error> broken(const std::string& what, const std::string& file) {
    return fail(ErrorCode::invalidInput, what, {.file = file, .path = "asset.extras.toile.body"});
}

} // namespace

GlbFile glbOf(const Body& body) {
    GlbArrays arrays;
    const std::vector<Vec3> normals = geometry::vertexNormals(body.mesh);
    Json attributes, primitive, mesh, node, json;
    attributes.set("POSITION", arrays.add(body.mesh.vertices, true)).set("NORMAL", arrays.add(normals));
    primitive.set("attributes", std::move(attributes)).set("indices", arrays.add(body.mesh.triangles));
    primitive.set("material", 0);
    mesh.set("name", body.name).set("primitives", Json(Json::Array{std::move(primitive)}));
    node.set("name", body.name).set("mesh", 0);

    Json asset, material, surface;
    asset.set("version", "2.0").set("generator", "toile").set("extras", extrasOf(body));
    surface.set("baseColorFactor", Json(Json::Array{0.82, 0.74, 0.68, 1})).set("metallicFactor", 0);
    surface.set("roughnessFactor", 0.8);
    material.set("name", "skin").set("pbrMetallicRoughness", std::move(surface));
    json.set("asset", std::move(asset)).set("scene", 0);
    json.set("scenes", Json(Json::Array{Json(Json::Object{{"nodes", Json(Json::Array{0})}})}));
    json.set("nodes", Json(Json::Array{std::move(node)})).set("meshes", Json(Json::Array{std::move(mesh)}));
    json.set("materials", Json(Json::Array{std::move(material)}));
    return std::move(arrays).finish(std::move(json));
}

Result<std::optional<Body>> bodyOf(const GlbFile& glb, const std::string& file) {
    const Json* extras = memberOf(&glb.json, {"asset", "extras", "toile", "body"});
    if (!extras) return std::optional<Body>();
    const Json* version = extras->find("version");
    if (!version || !version->asNumber()) return broken("The body has no version.", file);
    if (*version->asNumber() > bodyVersion)
        return fail(ErrorCode::unsupported, "The body was written by a newer version of the program.", {.file = file});

    Body body;
    if (const Json* name = extras->find("name"); name && name->asString()) body.name = *name->asString();
    const Json* landmarks = extras->find("landmarks");
    for (const auto& [name, member] : landmarkNames) {
        const auto p = pointOf(landmarks ? landmarks->find(name) : nullptr);
        if (!p) return broken(std::string("The landmark \"") + name + "\" is missing or no point.", file);
        body.landmarks.*member = *p;
    }
    const Json* axes = extras->find("axes");
    if (!axes || !axes->asArray()) return broken("The limb axes are missing.", file);
    for (const Json& item : *axes->asArray()) {
        auto axis = axisOf(item);
        if (!axis) return broken("A limb axis is broken.", file);
        body.axes.push_back(std::move(*axis));
    }
    auto mesh = firstMesh(glb, file);
    if (!mesh) return tl::unexpected(mesh.error());
    body.mesh = std::move(*mesh);
    return std::optional<Body>(std::move(body));
}

} // namespace toile::io
