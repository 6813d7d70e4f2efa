// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/RegularFile.h"
#include "core/io/JsonNode.h"
#include "core/io/ToileFile.h"
#include "core/io/ToileNames.h"
#include "core/pattern/Ids.h"
#include "core/pattern/PatternPlacement.h"
#include "core/simulation/SceneCheck.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::io {
namespace {

using namespace pattern;

constexpr double longest = 1e9;                      ///< [mm]
constexpr std::uint64_t largestDocument = 256 << 20; ///< [bytes]; a blouse has some 50 000

template <class IdType>
IdType idOf(const JsonNode& node) {
    IdType id(node.text());
    if (node.exists() && id.empty()) node.refuse("An id cannot be empty.");
    return id;
}

double lengthOf(const JsonNode& node, double missing = 0) {
    if (!node.exists()) return missing;
    const double value = node.number();
    if (!(std::abs(value) <= longest))
        node.refuse(fmt::format("Expected a length in millimetres, but {} is out of all measure.", value));
    return metres(value);
}
double angleOf(const JsonNode& node) {
    return radians(node.number());
}

Vec2 pointOf(const JsonNode& node) {
    const auto xy = node.items(2);
    return xy.empty() ? Vec2{} : Vec2{lengthOf(xy[0]), lengthOf(xy[1])};
}

/// What `read` makes of each item.
template <class Read>
auto listOf(const JsonNode& node, Read read) {
    std::vector<decltype(read(std::declval<JsonNode&>()))> list;
    for (JsonNode& item : node.items()) list.push_back(read(item));
    return list;
}

std::vector<Vec2> pointsOf(const JsonNode& node) {
    return listOf(node, [](JsonNode& item) { return pointOf(item); });
}

Vertex vertexOf(JsonNode& node) {
    return {idOf<VertexId>(node.required("id")), {lengthOf(node.required("x")), lengthOf(node.required("y"))}};
}

EdgeShape shapeOf(JsonNode& node) {
    switch (node.required("shape").choice(edgeShapeNames, 0)) {
    case 1: return geometry::CubicShape{pointOf(node.required("control1")), pointOf(node.required("control2"))};
    case 2: return geometry::ArcShape{node.required("bulge").number()};
    default: return geometry::LineShape{};
    }
}

std::optional<double> optionalLength(const JsonNode& node) {
    return node.exists() ? std::optional(lengthOf(node)) : std::nullopt;
}

Edge edgeOf(JsonNode& node) {
    return {idOf<EdgeId>(node.required("id")), shapeOf(node), optionalLength(node["seamAllowance"])};
}

Contour contourOf(JsonNode& node) {
    const JsonNode edges = node.required("edges");
    Contour contour{listOf(node.required("vertices"), vertexOf), listOf(edges, edgeOf)};
    if (contour.vertices.size() != contour.edges.size())
        edges.refuse(fmt::format("Expected as many edges as vertices, but found {} edges and {} vertices.",
                                 contour.edges.size(), contour.vertices.size()));
    return contour;
}

Notch notchOf(JsonNode& node) {
    return {idOf<EdgeId>(node.required("edge")), node.required("position").number(),
            static_cast<NotchKind>(node["kind"].choice(notchKindNames, 0)), node["double"].truth()};
}

BorderPoint borderPointOf(JsonNode node) {
    return {idOf<EdgeId>(node.required("edge")), node.required("position").number()};
}

Fold foldOf(JsonNode& node) {
    Fold fold;
    fold.id = idOf<FoldId>(node.required("id"));
    fold.name = node["name"].text(fold.id.value);
    fold.ends = {borderPointOf(node.required("from")), borderPointOf(node.required("to"))};
    if (const JsonNode between = node["between"]; between.exists()) fold.between = pointsOf(between);
    fold.angle = angleOf(node["foldAngleDegrees"]);
    fold.stiffnessFactor = node["stiffnessFactor"].number(fold.stiffnessFactor);
    fold.unknown = node.unknown();
    return fold;
}

InternalLine internalLineOf(JsonNode& node) {
    return {node["name"].text(), pointsOf(node.required("points"))};
}

StiffnessFactors stiffnessOf(JsonNode node) {
    return {node["stretch"].number(1), node["shear"].number(1), node["bending"].number(1)};
}

Region regionOf(JsonNode& node) {
    Region region;
    region.id = idOf<RegionId>(node.required("id"));
    region.name = node["name"].text();
    region.refinement = node["refinement"].integer(1, 0, 16);
    region.stiffness = stiffnessOf(node["stiffness"]);
    region.outline = pointsOf(node.required("outline"));
    region.holes = listOf(node["holes"], [](JsonNode& hole) { return pointsOf(hole); });
    region.unknown = node.unknown();
    return region;
}

BentLine bentOf(JsonNode node) {
    BentLine bent;
    bent.from = lengthOf(node.required("from"));
    bent.points = listOf(node.required("points"), [](JsonNode& point) {
        const auto xyz = point.items(3);
        return xyz.empty() ? Vec3{} : Vec3{lengthOf(xyz[0]), lengthOf(xyz[1]), lengthOf(xyz[2])};
    });
    if (!isLine(bent)) node.refuse("A bent middle needs two points at least, and no two neighbours in one place.");
    return bent;
}

Curl curlOf(JsonNode node) {
    Curl curl;
    if (const auto axis = node.required("axis").items(2); !axis.empty())
        curl.axis = {axis[0].number(), axis[1].number()};
    curl.radius = lengthOf(node.required("radius"));
    if (const JsonNode bent = node["bent"]; bent.exists()) curl.bent = bentOf(bent);
    return curl;
}

Placement placementOf(JsonNode node) {
    Placement placement;
    Transform& t = placement.transform;
    const auto rows = node.required("matrix").items(3);
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const auto row = rows[static_cast<std::size_t>(i)].items(4);
        if (row.empty()) break;
        t.axisX[i] = row[0].number();
        t.axisY[i] = row[1].number();
        t.axisZ[i] = row[2].number();
        t.origin[i] = lengthOf(row[3]);
    }
    if (const JsonNode curl = node["curl"]; curl.exists()) placement.curl = curlOf(curl);
    return placement;
}

MirrorOf mirrorOf(JsonNode node) {
    MirrorOf mirror{idOf<PieceId>(node.required("source"))};
    if (const auto line = node.required("line").items(2); !line.empty()) {
        mirror.lineStart = pointOf(line[0]);
        mirror.lineEnd = pointOf(line[1]);
    }
    return mirror;
}

Interfacing interfacingOf(JsonNode node) {
    Interfacing interfacing;
    interfacing.bendingFactor = node["bendingFactor"].number(interfacing.bendingFactor);
    interfacing.arealDensity = node["arealDensity"].number(interfacing.arealDensity);
    return interfacing;
}

Shared<Piece> pieceOf(JsonNode& node) {
    Piece piece;
    piece.id = idOf<PieceId>(node.required("id"));
    piece.name = node["name"].text(piece.id.value);
    piece.fabric = FabricId(node["fabric"].text());
    if (const JsonNode fused = node["interfacing"]; fused.exists()) piece.interfacing = interfacingOf(fused);
    piece.plies = node["plies"].integer(1, -1'000'000, 1'000'000);
    piece.layer = node["layer"].integer(0, -1'000'000, 1'000'000);
    piece.pressure = node["pressure"].number(piece.pressure);
    piece.frozen = node["frozen"].truth();
    piece.strengthened = node["strengthened"].truth();
    piece.spacing = lengthOf(node["spacing"], piece.spacing);
    piece.grain = angleOf(node["grainDegrees"]);
    piece.seamAllowance = lengthOf(node["seamAllowance"], piece.seamAllowance);
    piece.rule = static_cast<LineRule>(node["rule"].choice(lineRuleNames, 0));
    piece.border = static_cast<RegionBorder>(node["regionBorder"].choice(regionBorderNames, 0));
    if (const JsonNode position = node["tablePosition"]; position.exists()) piece.tablePosition = pointOf(position);
    if (const JsonNode mirror = node["mirror"]; mirror.exists()) piece.mirror = mirrorOf(mirror);
    else piece.outline = contourOf(node);
    if (const JsonNode placement = node["placement"]; placement.exists()) piece.placement = placementOf(placement);
    piece.holes = listOf(node["holes"], contourOf);
    piece.notches = listOf(node["notches"], notchOf);
    piece.folds = listOf(node["folds"], foldOf);
    piece.internalLines = listOf(node["internalLines"], internalLineOf);
    piece.regions = listOf(node["regions"], regionOf);
    piece.unknown = node.unknown();
    return piece;
}

SeamPart seamPartOf(JsonNode& node) {
    return {idOf<PieceId>(node.required("piece")), idOf<EdgeId>(node.required("edge")), node["from"].number(0),
            node["to"].number(1), node["reversed"].truth()};
}

SeamSection sectionOf(JsonNode& node) {
    SeamSection section{lengthOf(node["ease"])};
    if (const JsonNode ratio = node["gatherRatio"]; ratio.exists()) section.gatherRatio = ratio.number();
    return section;
}

Elastic elasticOf(JsonNode node) {
    Elastic elastic;
    elastic.ratio = node["ratio"].number(elastic.ratio);
    elastic.stiffness = node["stiffness"].number(elastic.stiffness);
    return elastic;
}

Seam seamOf(JsonNode& node) {
    Seam seam;
    seam.id = idOf<SeamId>(node.required("id"));
    seam.name = node["name"].text(seam.id.value);
    seam.foldAngle = angleOf(node["foldAngleDegrees"]);
    seam.stiffnessFactor = node["stiffnessFactor"].number(seam.stiffnessFactor);
    seam.order = node["order"].integer(0, -1'000'000, 1'000'000);
    if (const JsonNode elastic = node["elastic"]; elastic.exists()) seam.elastic = elasticOf(elastic);
    seam.sections = listOf(node["sections"], sectionOf);
    seam.sides = {listOf(node.required("sideA"), seamPartOf), listOf(node.required("sideB"), seamPartOf)};
    seam.unknown = node.unknown();
    return seam;
}

material::TensionPoint tensionOf(JsonNode& node) {
    return {node.required("strain").number(), node.required("modulusFactor").number()};
}

Shared<Fabric> fabricOf(JsonNode& node) {
    Fabric fabric;
    fabric.id = idOf<FabricId>(node.required("id"));
    fabric.name = node["name"].text(fabric.id.value);
    fabric.kind = static_cast<material::FabricKind>(node["kind"].choice(fabricKindNames, 0));
    fabric.arealDensity = node.required("arealDensity").number();
    fabric.warpStiffness = node.required("warpStiffness").number();
    fabric.weftStiffness = node.required("weftStiffness").number();
    fabric.shearStiffness = node.required("shearStiffness").number();
    fabric.coupling = node["coupling"].number(fabric.coupling);
    fabric.warpBending = node.required("warpBending").number();
    fabric.weftBending = node.required("weftBending").number();
    fabric.biasBending = node.required("biasBending").number();
    fabric.thickness = lengthOf(node["thickness"], fabric.thickness);
    fabric.friction = node["friction"].number(fabric.friction);
    fabric.warpTension = listOf(node["warpTension"], tensionOf);
    fabric.weftTension = listOf(node["weftTension"], tensionOf);
    fabric.source = node["source"].text();
    fabric.unknown = node.unknown();
    return fabric;
}

Pin pinOf(JsonNode& node) {
    return {idOf<PinId>(node.required("id")), idOf<PieceId>(node.required("piece")),
            idOf<VertexId>(node.required("vertex")), node["toBody"].truth()};
}

ClothPoint clothPointOf(JsonNode node) {
    return {idOf<PieceId>(node.required("piece")), pointOf(node.required("point"))};
}

Tack tackOf(JsonNode& node) {
    Tack tack;
    tack.id = idOf<TackId>(node.required("id"));
    tack.name = node["name"].text(tack.id.value);
    tack.ends = {clothPointOf(node.required("a")), clothPointOf(node.required("b"))};
    tack.buttonDiameter = optionalLength(node["buttonDiameter"]);
    tack.order = node["order"].integer(0, -1'000'000, 1'000'000);
    tack.unknown = node.unknown();
    return tack;
}

simulation::Air airOf(JsonNode node) {
    simulation::Air air;
    if (const auto w = node["wind"].items(3); !w.empty()) air.wind = {w[0].number(), w[1].number(), w[2].number()};
    air.drag = node["drag"].number(air.drag);
    return air;
}

simulation::SceneSettings sceneOf(JsonNode& node) {
    simulation::SceneSettings scene;
    if (const auto g = node["gravity"].items(3); !g.empty())
        scene.gravity = {g[0].number(), g[1].number(), g[2].number()};
    if (const JsonNode air = node["air"]; air.exists()) scene.air = airOf(air);
    scene.damping = node["damping"].number(scene.damping);
    scene.strainDamping = node["strainDamping"].number(scene.strainDamping);
    scene.skinOffset = lengthOf(node["skinOffset"], scene.skinOffset);
    scene.bodyFriction = node["bodyFriction"].number(scene.bodyFriction);
    scene.seamTime = node["seamTime"].number(scene.seamTime);
    scene.frameStep = node["frameStep"].number(scene.frameStep);
    scene.substeps = node["substeps"].integer(scene.substeps, 0, simulation::mostSubsteps);
    scene.selfContact = node["selfContact"].truth(scene.selfContact);
    return scene;
}

/// Is this a document at all, and one that we can read?
void readHeader(JsonNode& root) {
    const JsonNode format = root.required("format");
    if (format.exists() && format.text() != "toile") format.refuse("Expected \"toile\": this is not a Toile document.");
    const JsonNode version = root.required("version");
    if (version.exists() && version.number() > toileVersion)
        version.refuse(
            fmt::format("This document has version {}, but this program reads up to version {}: please use a "
                        "newer program.",
                        version.number(), toileVersion),
            ErrorCode::unsupported);
    (void)version.integer(toileVersion, 1, toileVersion);
}

document::Document documentOf(JsonNode& root) {
    document::Document document;
    readHeader(root);
    document.nextId = root["nextId"].integer(1, 1, 2'000'000'000);
    document.avatarFile = root["avatar"].text();
    JsonNode scene = root["scene"];
    document.scene = sceneOf(scene);
    document.unknownOfScene = scene.unknown();
    document.pattern.fabrics = listOf(root["fabrics"], fabricOf);
    document.pattern.pieces = listOf(root["pieces"], pieceOf);
    document.pattern.seams = listOf(root["seams"], seamOf);
    document.pattern.pins = listOf(root["pins"], pinOf);
    document.pattern.tacks = listOf(root["tacks"], tackOf);
    document.unknown = root.unknown();
    document.nextId = std::max(document.nextId, firstFreeNumber(document.pattern));
    return document;
}

} // namespace

Result<document::Document> documentFromText(std::string_view text, const std::string& file) {
    auto json = parseJson(text, file);
    if (!json) return tl::unexpected<Error>(json.error());
    JsonReading reading{file, {}};
    JsonNode root(&*json, {}, reading);
    document::Document document = documentOf(root);
    if (reading.error) return tl::unexpected<Error>(*reading.error);
    return document;
}

Result<document::Document> readToile(const std::string& path) {
    return readRegularFile(path, largestDocument).and_then([&](const std::string& text) {
        return documentFromText(text, path);
    });
}

} // namespace toile::io
