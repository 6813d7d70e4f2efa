// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"
#include "core/io/ToileFile.h"
#include "core/io/ToileNames.h"

#include <set>
#include <string>
#include <utility>

namespace toile::io {
namespace {

using namespace pattern;

template <class Names, class Enum>
const char* nameIn(const Names& names, Enum value) {
    return names[static_cast<std::size_t>(value)];
}

Json point(Vec2 p) {
    return Json(Json::Array{millimetres(p.x), millimetres(p.y)});
}

Json points(const std::vector<Vec2>& list) {
    Json json(Json::Array{});
    for (const Vec2 p : list) json.push(point(p));
    return json;
}

/// What `write` makes of each item.
template <class Items, class Write>
Json listJson(const Items& items, Write write) {
    Json list(Json::Array{});
    for (const auto& item : items) list.push(write(item));
    return list;
}

/// The same as a member; nothing at all for an empty list.
template <class Items, class Write>
void setList(Json& json, const char* key, const Items& items, Write write) {
    if (!items.empty()) json.set(key, listJson(items, write));
}

/// Adds those that we do not write ourselves.
void addUnknown(Json& json, const Json& unknown) {
    const auto* members = unknown.asObject();
    if (!members) return;
    std::set<std::string> ours;
    for (const auto& [key, value] : *json.asObject()) ours.insert(key);
    for (const auto& [key, value] : *members)
        if (!ours.contains(key)) json.add(key, value); // theirs differ from each other
}

Json vertexJson(const Vertex& vertex) {
    Json json;
    json.set("id", vertex.id.value).set("x", millimetres(vertex.position.x)).set("y", millimetres(vertex.position.y));
    return json;
}

Json edgeJson(const Edge& edge) {
    Json json;
    json.set("id", edge.id.value).set("shape", edgeShapeNames[edge.shape.index()]);
    if (const auto* cubic = std::get_if<geometry::CubicShape>(&edge.shape))
        json.set("control1", point(cubic->control1)).set("control2", point(cubic->control2));
    if (const auto* arc = std::get_if<geometry::ArcShape>(&edge.shape)) json.set("bulge", arc->bulge);
    if (edge.seamAllowance) json.set("seamAllowance", millimetres(*edge.seamAllowance));
    return json;
}

void setContour(Json& json, const Contour& contour) {
    json.set("vertices", listJson(contour.vertices, vertexJson)).set("edges", listJson(contour.edges, edgeJson));
}

Json holeJson(const Contour& hole) {
    Json json;
    setContour(json, hole);
    return json;
}

Json notchJson(const Notch& notch) {
    Json json;
    json.set("edge", notch.edge.value).set("position", notch.position).set("kind", nameIn(notchKindNames, notch.kind));
    if (notch.isDouble) json.set("double", true);
    return json;
}

Json borderPointJson(const BorderPoint& place) {
    Json json;
    return json.set("edge", place.edge.value).set("position", place.position);
}

Json foldJson(const Fold& fold) {
    Json json;
    json.set("id", fold.id.value).set("name", fold.name);
    json.set("from", borderPointJson(fold.ends[0])).set("to", borderPointJson(fold.ends[1]));
    if (!fold.between.empty()) json.set("between", points(fold.between));
    json.set("foldAngleDegrees", degrees(fold.angle)).set("stiffnessFactor", fold.stiffnessFactor);
    addUnknown(json, fold.unknown);
    return json;
}

Json internalLineJson(const InternalLine& line) {
    Json json;
    json.set("name", line.name).set("points", points(line.points));
    return json;
}

Json stiffnessJson(const StiffnessFactors& factors) {
    Json json;
    json.set("stretch", factors.stretch).set("shear", factors.shear).set("bending", factors.bending);
    return json;
}

Json regionJson(const Region& region) {
    Json json;
    json.set("id", region.id.value).set("name", region.name).set("refinement", region.refinement);
    if (!(region.stiffness == StiffnessFactors{})) json.set("stiffness", stiffnessJson(region.stiffness));
    json.set("outline", points(region.outline));
    setList(json, "holes", region.holes, points);
    addUnknown(json, region.unknown);
    return json;
}

Json bentJson(const BentLine& bent) {
    Json list(Json::Array{});
    for (const Vec3& p : bent.points)
        list.push(Json(Json::Array{millimetres(p.x), millimetres(p.y), millimetres(p.z)}));
    Json json;
    json.set("from", millimetres(bent.from)).set("points", std::move(list));
    return json;
}

Json placementJson(const Placement& placement) {
    const Transform& t = placement.transform;
    Json rows(Json::Array{});
    for (int i = 0; i < 3; ++i)
        rows.push(Json(Json::Array{t.axisX[i], t.axisY[i], t.axisZ[i], millimetres(t.origin[i])}));
    Json json;
    json.set("matrix", std::move(rows));
    if (placement.curl) {
        Json curl;
        curl.set("axis", Json(Json::Array{placement.curl->axis.x, placement.curl->axis.y}));
        curl.set("radius", millimetres(placement.curl->radius));
        if (placement.curl->bent) curl.set("bent", bentJson(*placement.curl->bent));
        json.set("curl", std::move(curl));
    }
    return json;
}

Json mirrorJson(const MirrorOf& mirror) {
    Json json;
    json.set("source", mirror.source.value).set("line", points({mirror.lineStart, mirror.lineEnd}));
    return json;
}

Json interfacingJson(const Interfacing& interfacing) {
    Json json;
    json.set("bendingFactor", interfacing.bendingFactor).set("arealDensity", interfacing.arealDensity);
    return json;
}

Json pieceJson(const Shared<Piece>& shared) {
    const Piece& piece = *shared;
    Json json;
    json.set("id", piece.id.value).set("name", piece.name).set("fabric", piece.fabric.value);
    if (piece.interfacing) json.set("interfacing", interfacingJson(*piece.interfacing));
    if (piece.plies != 1) json.set("plies", piece.plies);
    if (piece.layer != 0) json.set("layer", piece.layer);
    if (piece.pressure != 0) json.set("pressure", piece.pressure);
    if (piece.frozen) json.set("frozen", true);
    if (piece.strengthened) json.set("strengthened", true);
    json.set("spacing", millimetres(piece.spacing));
    json.set("grainDegrees", degrees(piece.grain)).set("seamAllowance", millimetres(piece.seamAllowance));
    json.set("rule", nameIn(lineRuleNames, piece.rule)).set("regionBorder", nameIn(regionBorderNames, piece.border));
    json.set("tablePosition", point(piece.tablePosition));
    if (piece.mirror) json.set("mirror", mirrorJson(*piece.mirror));
    if (piece.placement) json.set("placement", placementJson(*piece.placement));
    if (!piece.mirror) setContour(json, piece.outline);
    setList(json, "holes", piece.holes, holeJson);
    setList(json, "notches", piece.notches, notchJson);
    setList(json, "folds", piece.folds, foldJson);
    setList(json, "internalLines", piece.internalLines, internalLineJson);
    setList(json, "regions", piece.regions, regionJson);
    addUnknown(json, piece.unknown);
    return json;
}

Json seamPartJson(const SeamPart& part) {
    Json json;
    json.set("piece", part.piece.value).set("edge", part.edge.value).set("from", part.from).set("to", part.to);
    json.set("reversed", part.reversed);
    return json;
}

Json sectionJson(const SeamSection& section) {
    Json json;
    json.set("ease", millimetres(section.ease));
    if (section.gatherRatio) json.set("gatherRatio", *section.gatherRatio);
    return json;
}

Json elasticJson(const Elastic& elastic) {
    Json json;
    json.set("ratio", elastic.ratio).set("stiffness", elastic.stiffness);
    return json;
}

Json seamJson(const Seam& seam) {
    Json json;
    json.set("id", seam.id.value).set("name", seam.name);
    json.set("foldAngleDegrees", degrees(seam.foldAngle)).set("stiffnessFactor", seam.stiffnessFactor);
    json.set("order", seam.order);
    if (seam.elastic) json.set("elastic", elasticJson(*seam.elastic));
    setList(json, "sections", seam.sections, sectionJson);
    json.set("sideA", listJson(seam.sides[0], seamPartJson)).set("sideB", listJson(seam.sides[1], seamPartJson));
    addUnknown(json, seam.unknown);
    return json;
}

Json tensionJson(const material::TensionPoint& point) {
    Json json;
    json.set("strain", point.strain).set("modulusFactor", point.modulusFactor);
    return json;
}

Json fabricJson(const Shared<Fabric>& shared) {
    const Fabric& fabric = *shared;
    Json json;
    json.set("id", fabric.id.value).set("name", fabric.name).set("kind", nameIn(fabricKindNames, fabric.kind));
    json.set("arealDensity", fabric.arealDensity);
    json.set("warpStiffness", fabric.warpStiffness).set("weftStiffness", fabric.weftStiffness);
    json.set("shearStiffness", fabric.shearStiffness).set("coupling", fabric.coupling);
    json.set("warpBending", fabric.warpBending).set("weftBending", fabric.weftBending);
    json.set("biasBending", fabric.biasBending);
    json.set("thickness", millimetres(fabric.thickness)).set("friction", fabric.friction);
    setList(json, "warpTension", fabric.warpTension, tensionJson);
    setList(json, "weftTension", fabric.weftTension, tensionJson);
    json.set("source", fabric.source);
    addUnknown(json, fabric.unknown);
    return json;
}

Json pinJson(const Pin& pin) {
    Json json;
    json.set("id", pin.id.value).set("piece", pin.piece.value).set("vertex", pin.vertex.value);
    if (pin.toBody) json.set("toBody", true);
    return json;
}

Json clothPointJson(const ClothPoint& place) {
    Json json;
    json.set("piece", place.piece.value).set("point", point(place.point));
    return json;
}

Json tackJson(const Tack& tack) {
    Json json;
    json.set("id", tack.id.value).set("name", tack.name);
    json.set("a", clothPointJson(tack.ends[0])).set("b", clothPointJson(tack.ends[1]));
    if (tack.buttonDiameter) json.set("buttonDiameter", millimetres(*tack.buttonDiameter));
    json.set("order", tack.order);
    addUnknown(json, tack.unknown);
    return json;
}

Json sceneJson(const simulation::SceneSettings& scene, const Json& unknown) {
    Json json;
    json.set("gravity", Json(Json::Array{scene.gravity.x, scene.gravity.y, scene.gravity.z}));
    if (scene.air) {
        const Vec3& wind = scene.air->wind;
        Json air;
        air.set("wind", Json(Json::Array{wind.x, wind.y, wind.z})).set("drag", scene.air->drag);
        json.set("air", std::move(air));
    }
    json.set("damping", scene.damping);
    if (scene.strainDamping != 0) json.set("strainDamping", scene.strainDamping);
    json.set("skinOffset", millimetres(scene.skinOffset));
    json.set("bodyFriction", scene.bodyFriction).set("seamTime", scene.seamTime);
    json.set("frameStep", scene.frameStep).set("substeps", scene.substeps).set("selfContact", scene.selfContact);
    addUnknown(json, unknown);
    return json;
}

Json documentJson(const document::Document& document) {
    Json json;
    json.set("format", "toile").set("version", toileVersion).set("nextId", document.nextId);
    if (!document.avatarFile.empty()) json.set("avatar", document.avatarFile);
    json.set("scene", sceneJson(document.scene, document.unknownOfScene));
    setList(json, "fabrics", document.pattern.fabrics, fabricJson);
    setList(json, "pieces", document.pattern.pieces, pieceJson);
    setList(json, "seams", document.pattern.seams, seamJson);
    setList(json, "pins", document.pattern.pins, pinJson);
    setList(json, "tacks", document.pattern.tacks, tackJson);
    addUnknown(json, document.unknown);
    return json;
}

} // namespace

std::string toileText(const document::Document& document) {
    return toText(documentJson(document));
}

Result<document::Document> asWritten(const document::Document& document) {
    return documentFromText(toileText(document));
}

Result<void> writeToile(const document::Document& document, const std::string& path) {
    const std::string text = toileText(document);
    // A number that is not finite has become null: reading it back names the place.
    if (auto again = documentFromText(text, path); !again) {
        again.error().text = "The document cannot be saved: " + again.error().text;
        return tl::unexpected<Error>(std::move(again).error());
    }
    return writeFileAtomically(path, text);
}

} // namespace toile::io
