// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/DrapeExport.h"
#include "core/io/DrapeFaces.h"
#include "core/io/GlbFile.h"

namespace toile::io {
namespace {

using simulation::FrameTopology;

Json clothMaterial() {
    Json surface, material;
    surface.set("baseColorFactor", Json(Json::Array{0.36, 0.52, 0.66, 1})).set("metallicFactor", 0);
    surface.set("roughnessFactor", 0.9);
    material.set("name", "cloth").set("pbrMetallicRoughness", std::move(surface)).set("doubleSided", true);
    return material;
}

/// Images lie the other way up in glTF: programs that read it turn v over, and then have metres again.
std::vector<Vec2> textureCoordinates(std::span<const Vec2> material) {
    std::vector<Vec2> turned;
    turned.reserve(material.size());
    for (const Vec2& m : material) turned.push_back({m.x, 1 - m.y});
    return turned;
}

Json toileExtras(const char* key, Json value) {
    return Json(Json::Object{{"toile", Json(Json::Object{{key, std::move(value)}})}});
}

} // namespace

std::string drapeGlb(const FrameTopology& topology, std::span<const Vec3> positions) {
    const std::vector<Vec3> normals = drapeNormals(topology, positions);
    const std::vector<Vec2> coordinates = textureCoordinates(topology.material);
    GlbArrays arrays;
    Json meshes{Json::Array{}}, nodes{Json::Array{}}, roots{Json::Array{}}, pieces{Json::Array{}};
    for (const FrameTopology::PieceRange& piece : topology.pieces) {
        if (piece.triangleCount == 0) continue;
        const auto part = [&](const auto& all) { return std::span(all).subspan(piece.firstVertex, piece.vertexCount); };
        const int index = static_cast<int>(meshes.asArray()->size());
        Json attributes, primitive, mesh, node, name;
        attributes.set("POSITION", arrays.add(part(positions), true)).set("NORMAL", arrays.add(part(normals)));
        attributes.set("TEXCOORD_0", arrays.add(part(coordinates)));
        primitive.set("attributes", std::move(attributes));
        primitive.set("indices", arrays.add(trianglesOf(topology, piece), piece.firstVertex)).set("material", 0);
        mesh.set("name", piece.name).set("primitives", Json(Json::Array{std::move(primitive)}));
        node.set("name", piece.name).set("mesh", index).set("extras", toileExtras("piece", piece.id));
        name.set("id", piece.id).set("name", piece.name).set("node", index);
        meshes.push(std::move(mesh));
        nodes.push(std::move(node));
        roots.push(index);
        pieces.push(std::move(name));
    }
    Json asset, json;
    asset.set("version", "2.0").set("generator", "toile").set("extras", toileExtras("pieces", std::move(pieces)));
    json.set("asset", std::move(asset)).set("scene", 0);
    json.set("scenes", Json(Json::Array{Json(Json::Object{{"nodes", std::move(roots)}})}));
    json.set("nodes", std::move(nodes)).set("meshes", std::move(meshes));
    json.set("materials", Json(Json::Array{clothMaterial()}));
    return toBytes(std::move(arrays).finish(std::move(json)));
}

} // namespace toile::io
