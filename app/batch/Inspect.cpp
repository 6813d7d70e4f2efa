// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "core/base/Extension.h"
#include "core/base/Json.h"
#include "core/io/BodyImport.h"
#include "core/io/DocumentFile.h"
#include "core/pattern/PatternMeasures.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace toile::batch {
namespace {

double sideLength(const pattern::Pattern& pattern, const std::vector<pattern::SeamPart>& side) {
    double sum = 0;
    for (const pattern::SeamPart& part : side) sum += pattern::partLength(pattern, part).value_or(0);
    return sum;
}

Json pieceJson(const pattern::Pattern& pattern, const pattern::Piece& authored) {
    const pattern::Piece piece = pattern::resolved(pattern, authored);
    const geometry::Box2 box = geometry::boundsOf(pattern::flattened(piece.outline, 1e-4));
    const auto& fused = piece.interfacing;
    Json json;
    json.set("id", piece.id.value)
        .set("name", piece.name)
        .set("mirrorOf", piece.mirror ? Json(piece.mirror->source.value) : Json());
    json.set("fabric", piece.fabric.value);
    json.set("interfacingBending", fused ? Json(fused->bendingFactor) : Json());
    json.set("interfacingDensity", fused ? Json(fused->arealDensity) : Json());
    json.set("plies", piece.plies)
        .set("layer", piece.layer)
        .set("pressure", piece.pressure)
        .set("frozen", piece.frozen)
        .set("strengthened", piece.strengthened)
        .set("spacing", piece.spacing)
        .set("area", pattern::areaOf(piece));
    json.set("width", box.high.x - box.low.x).set("height", box.high.y - box.low.y);
    json.set("edges", piece.outline.edges.size()).set("holes", piece.holes.size()).set("regions", piece.regions.size());
    json.set("folds", piece.folds.size());
    return json.set("notches", piece.notches.size()).set("placed", piece.placement.has_value());
}

Json seamJson(const pattern::Pattern& pattern, const pattern::Seam& seam) {
    const double a = sideLength(pattern, seam.sides[0]), b = sideLength(pattern, seam.sides[1]);
    double ease = 0;
    if (const auto sections = pattern::sectionsOf(pattern, seam))
        for (const pattern::SectionLengths& section : *sections) ease += section.wantedEase;
    Json json;
    json.set("id", seam.id.value).set("name", seam.name).set("lengthA", a).set("lengthB", b);
    json.set("elasticRatio", seam.elastic ? Json(seam.elastic->ratio) : Json());
    json.set("elasticStiffness", seam.elastic ? Json(seam.elastic->stiffness) : Json());
    return json.set("difference", a - b).set("declaredEase", ease).set("order", seam.order);
}

Json tackJson(const pattern::Tack& tack) {
    Json json;
    json.set("id", tack.id.value).set("name", tack.name);
    json.set("pieceA", tack.ends[0].piece.value).set("pieceB", tack.ends[1].piece.value);
    json.set("buttonDiameter", tack.buttonDiameter ? Json(*tack.buttonDiameter) : Json());
    return json.set("order", tack.order);
}

Json fabricJson(const material::Fabric& fabric) {
    Json json;
    json.set("id", fabric.id.value).set("name", fabric.name);
    json.set("kind", fabric.kind == material::FabricKind::knit ? "knit" : "woven")
        .set("arealDensity", fabric.arealDensity);
    json.set("warpStiffness", fabric.warpStiffness).set("weftStiffness", fabric.weftStiffness);
    json.set("shearStiffness", fabric.shearStiffness).set("bendingLength", material::bendingLength(fabric));
    json.set("proposedSpacing", material::proposedSpacing(fabric));
    return json.set("source", fabric.source);
}

Json documentJson(const document::Document& document) {
    const pattern::Pattern& pattern = document.pattern;
    Json pieces(Json::Array{}), seams(Json::Array{}), tacks(Json::Array{}), fabrics(Json::Array{});
    for (const auto& piece : pattern.pieces) pieces.push(pieceJson(pattern, *piece));
    for (const pattern::Seam& seam : pattern.seams) seams.push(seamJson(pattern, seam));
    for (const pattern::Tack& tack : pattern.tacks) tacks.push(tackJson(tack));
    for (const auto& fabric : pattern.fabrics) fabrics.push(fabricJson(*fabric));
    Json json;
    json.set("avatar", document.avatarFile.empty() ? Json() : Json(document.avatarFile));
    return json.set("pieces", pieces).set("seams", seams).set("tacks", tacks).set("fabrics", fabrics);
}

Json bodyJson(const body::Body& body) {
    const geometry::Box3 box = geometry::boundsOf(body.mesh.vertices);
    Json json;
    json.set("name", body.name).set("vertices", body.mesh.vertices.size()).set("triangles", body.mesh.triangles.size());
    json.set("closed", geometry::isClosedManifold(body.mesh)).set("height", box.high.y - box.low.y);
    return json.set("limbs", body.axes.size());
}

/// A table of the rows' numbers and texts under their keys.
void printRows(const char* title, const Json& rows) {
    fmt::print("{}: {}\n", title, rows.asArray()->size());
    for (const Json& row : *rows.asArray()) {
        std::string line = " ";
        for (const auto& [key, value] : *row.asObject()) {
            if (key == "id" || value.isNull()) continue; // it stands behind the name
            if (const double* number = value.asNumber()) line += fmt::format(" {} {:.4g}", key, *number);
            else if (const std::string* text = value.asString())
                line += key == "name" ? fmt::format(" {} ({}):", *text, *row.find("id")->asString())
                                      : fmt::format(" {} {}", key, *text);
            else if (value.asBool() && !*value.asBool()) line += " not " + key;
        }
        fmt::print("{}\n", oneLine(line));
    }
}

bool isBodyFile(const std::filesystem::path& file) {
    static constexpr std::array endings{".glb", ".gltf", ".obj", ".stl", ".ply", ".dae", ".fbx"};
    return std::ranges::find(endings, extensionOf(file)) != endings.end();
}

Result<Json> contentOf(const InspectOptions& options) {
    if (isBodyFile(options.file)) {
        const auto body = io::readBody(options.file);
        if (!body) return tl::unexpected(body.error());
        return bodyJson(*body);
    }
    const auto imported = io::readDocument(options.file);
    if (!imported) return tl::unexpected(imported.error());
    return documentJson(imported->document);
}

} // namespace

int inspect(const InspectOptions& options) {
    const auto content = contentOf(options);
    if (!content) {
        printError(content.error());
        return inputWrong;
    }
    if (options.json) {
        fmt::print("{}", toText(*content));
        return done;
    }
    if (!content->find("pieces")) {
        fmt::print("{}\n", toLine(*content));
        return done;
    }
    if (const std::string* avatar = content->find("avatar")->asString()) fmt::print("avatar: {}\n", oneLine(*avatar));
    printRows("pieces", *content->find("pieces"));
    printRows("seams", *content->find("seams"));
    printRows("tacks", *content->find("tacks"));
    printRows("fabrics", *content->find("fabrics"));
    return done;
}

} // namespace toile::batch
