// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/RegularFile.h"
#include "core/io/GarmentCodeFile.h"
#include "core/io/JsonNode.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternPieces.h"
#include "core/pattern/PatternSeams.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <set>

namespace toile::io {
namespace {

using namespace pattern;
using geometry::ArcShape;
using geometry::CubicShape;
using geometry::Curve;

constexpr std::uint64_t largestGarmentCode = 64 << 20; // [bytes]

constexpr double fewestPerMetre = 1e-3, mostPerMetre = 1e6; // kilometres, micrometres
constexpr double largestNumber = 1e12; ///< of a point, in units: shapes of such points have finite lengths

/// What all panels of a file share.
struct Units {
    double perMetre = 100;
    bool relative = true; ///< control points in the frame of their edge
};

/// A panel as it became a piece: stitches name its edges by index.
struct Panel {
    PieceId piece;
    std::vector<EdgeId> edges;
    std::vector<std::string> labels;
};

double coordinateOf(const JsonNode& node) {
    const double value = node.number();
    if (std::abs(value) <= largestNumber) return value;
    node.refuse(fmt::format("Expected a coordinate of at most {:g} units, but found {:g}.", largestNumber, value));
    return 0;
}

Vec2 pairOf(const JsonNode& node) {
    const auto xy = node.items(2);
    return xy.empty() ? Vec2{} : Vec2{coordinateOf(xy[0]), coordinateOf(xy[1])};
}

Vec3 tripleOf(const JsonNode& node) {
    const auto xyz = node.items(3);
    return xyz.empty() ? Vec3{} : Vec3{coordinateOf(xyz[0]), coordinateOf(xyz[1]), coordinateOf(xyz[2])};
}

double unitsInMetre(const JsonNode& node) {
    constexpr double centimetres = 100;
    const double perMetre = node.number(centimetres);
    if (perMetre >= fewestPerMetre && perMetre <= mostPerMetre) return perMetre;
    node.refuse(fmt::format("Expected a positive number of units in a metre, from {:g} to {:g}, but found {:g}.",
                            fewestPerMetre, mostPerMetre, perMetre));
    return centimetres; // reading goes on
}

Units unitsOf(JsonNode root, std::vector<Warning>& warnings) {
    JsonNode properties = root["properties"];
    Units units;
    const JsonNode perMetre = properties["units_in_meter"];
    units.perMetre = unitsInMetre(perMetre);
    if (!perMetre.exists()) warnings.push_back({"units", "the file does not say its unit: centimetres are assumed."});
    static constexpr std::array names{"relative", "absolute"};
    units.relative = properties["curvature_coords"].choice(names, 0) == 0;
    return units;
}

/// A control point: relative ones count along the edge and to its left, in lengths of the edge.
Vec2 controlOf(const JsonNode& node, const Curve& edge, const Units& units) {
    const Vec2 p = pairOf(node);
    if (!units.relative) return p / units.perMetre;
    const Vec2 along = edge.end - edge.start;
    return edge.start + along * p.x + geometry::leftOf(along) * p.y;
}

CubicShape raised(const Curve& edge, Vec2 quadraticControl) {
    return {geometry::lerp(edge.start, quadraticControl, 2.0 / 3), geometry::lerp(edge.end, quadraticControl, 2.0 / 3)};
}

/// Radius, large arc?, bulging to the right of the way from start to end?
EdgeShape arcOf(const JsonNode& params, const Curve& edge, const Units& units) {
    const auto values = params.items(3);
    if (values.empty()) return geometry::LineShape{};
    const auto flag = [](const JsonNode& node) { return node.json()->asBool() ? node.truth() : node.number() != 0; };
    const double radius = coordinateOf(values[0]) / units.perMetre,
                 half = 0.5 * geometry::distance(edge.start, edge.end);
    if (!(radius >= 0.99 * half))
        values[0].refuse("The radius is too small: the arc does not reach from one end of the edge to the other.");
    const double minor = 2 * std::asin(std::min(1.0, half / radius));
    const double sweep = flag(values[1]) ? 2 * std::numbers::pi - minor : minor;
    return ArcShape{(flag(values[2]) ? 1 : -1) * std::tan(sweep / 4)}; // turning left bulges to the right
}

EdgeShape shapeOf(JsonNode curvature, const Curve& edge, const Units& units) {
    if (!curvature.exists() || curvature.json()->isNull()) return geometry::LineShape{};
    if (curvature.json()->asArray()) return raised(edge, controlOf(curvature, edge, units)); // the old way
    static constexpr std::array kinds{"quadratic", "cubic", "circle"};
    const int kind = curvature.required("type").choice(kinds, 0);
    const JsonNode params = curvature.required("params");
    if (kind == 2) return arcOf(params, edge, units);
    const auto points = params.items(kind == 0 ? 1 : 2);
    if (points.empty()) return geometry::LineShape{};
    if (kind == 0) return raised(edge, controlOf(points[0], edge, units));
    return CubicShape{controlOf(points[0], edge, units), controlOf(points[1], edge, units)};
}

/// R = Rz·Ry·Rx of angles in degrees.
Transform rotationOf(const Vec3& degrees) {
    const auto turn = [](double angle, int axis) {
        const double a = angle * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
        Transform t;
        if (axis == 0) t = {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
        if (axis == 1) t = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
        if (axis == 2) t = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
        return t;
    };
    return composed(turn(degrees.z, 2), composed(turn(degrees.y, 1), turn(degrees.x, 0)));
}

/// Seen from the back: a clockwise panel becomes counter-clockwise, its right side comes to +z.
void turnOver(Piece& piece) {
    const Vec2 a{0, 0}, b{0, 1};
    Contour& contour = piece.outline;
    for (Edge& edge : contour.edges) {
        if (auto* cubic = std::get_if<CubicShape>(&edge.shape))
            *cubic = {geometry::mirrored(cubic->control1, a, b), geometry::mirrored(cubic->control2, a, b)};
        if (auto* arc = std::get_if<ArcShape>(&edge.shape)) arc->bulge = -arc->bulge;
    }
    for (Vertex& vertex : contour.vertices) vertex.position = geometry::mirrored(vertex.position, a, b);
    Transform& t = piece.placement->transform;
    t.axisX = -t.axisX;
    t.axisZ = -t.axisZ;
}

/// The vertices in the order of the edges, which must form one closed loop.
std::vector<Vec2> loopOf(const std::vector<JsonNode>& edges, const std::vector<Vec2>& vertices,
                         std::vector<JsonNode>& ends) {
    std::vector<Vec2> loop;
    std::vector<std::array<int, 2>> endpoints;
    const int last = static_cast<int>(vertices.size()) - 1;
    for (JsonNode edge : edges) {
        ends.push_back(edge.required("endpoints"));
        const auto pair = ends.back().items(2);
        if (pair.empty()) return {};
        endpoints.push_back({pair[0].integer(0, 0, last), pair[1].integer(0, 0, last)});
    }
    for (std::size_t i = 0; i < endpoints.size(); ++i) {
        if (endpoints[i][1] != endpoints[(i + 1) % endpoints.size()][0])
            ends[i].refuse("The edges of a panel must follow each other round one closed loop.");
        loop.push_back(vertices[static_cast<std::size_t>(std::max(0, endpoints[i][0]))]);
    }
    return loop;
}

struct ReadPiece {
    Piece piece;
    Panel panel;
};

ReadPiece pieceOf(JsonNode node, const std::string& name, const Units& units, IdSource& ids) {
    ReadPiece read;
    Piece& piece = read.piece;
    piece.id = ids.take<PieceId>();
    piece.name = name;
    std::vector<Vec2> vertices;
    for (const JsonNode& vertex : node.required("vertices").items())
        vertices.push_back(pairOf(vertex) / units.perMetre);
    auto edges = node.required("edges").items();
    std::vector<JsonNode> ends;
    const std::vector<Vec2> loop = loopOf(edges, vertices, ends);
    if (loop.size() < 3) {
        node.refuse("A panel needs at least three edges.");
        return read;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Curve straight{loop[i], loop[(i + 1) % loop.size()], geometry::LineShape{}};
        piece.outline.vertices.push_back({ids.take<VertexId>(), loop[i]});
        piece.outline.edges.push_back({ids.take<EdgeId>(), shapeOf(edges[i]["curvature"], straight, units), {}});
        read.panel.edges.push_back(piece.outline.edges.back().id);
        const JsonNode label = edges[i]["label"];
        read.panel.labels.push_back(label.exists() && label.json()->asString() ? label.text() : std::string());
    }
    piece.placement = Placement{rotationOf(tripleOf(node["rotation"])), {}};
    piece.placement->transform.origin = tripleOf(node["translation"]) / units.perMetre;
    read.panel.piece = piece.id;
    return read;
}

/// The names of the panels, in the order they are to be listed.
std::vector<std::string> panelNames(JsonNode& pattern, JsonNode& panels) {
    std::vector<std::string> names, all;
    if (panels.exists() && panels.json()->asObject())
        for (const auto& member : *panels.json()->asObject()) all.push_back(member.first);
    for (const JsonNode& name : pattern["panel_order"].items()) names.push_back(name.text());
    const std::set<std::string> sortedNames(names.begin(), names.end()), sortedAll(all.begin(), all.end());
    return names.size() == all.size() && sortedNames == sortedAll ? names : all;
}

/// One edge of one panel; null where the stitch names none that exists.
const EdgeId* edgeOf(JsonNode locator, const std::map<std::string, Panel>& panels, const Panel*& panel,
                     std::string& label) {
    const JsonNode name = locator.required("panel"), index = locator.required("edge");
    const auto found = panels.find(name.text());
    if (found == panels.end()) {
        name.refuse(fmt::format("There is no panel \"{}\".", name.text()));
        return nullptr;
    }
    panel = &found->second;
    const auto edge = static_cast<std::size_t>(index.integer(0, 0, static_cast<int>(panel->edges.size()) - 1));
    if (edge >= panel->edges.size()) return nullptr;
    label = panel->labels[edge];
    return &panel->edges[edge];
}

Seam seamOf(const JsonNode& stitch, const std::map<std::string, Panel>& panels, IdSource& ids,
            std::vector<Warning>& warnings) {
    Seam seam;
    seam.id = ids.take<SeamId>();
    const auto locators = stitch.items();
    if (locators.size() < 2 || locators.size() > 3) {
        stitch.refuse(fmt::format("A stitch joins two edges, but {} are given.", locators.size()));
        return seam;
    }
    std::array<std::string, 2> labels, names;
    for (std::size_t side = 0; side < 2; ++side) {
        const Panel* panel = nullptr;
        const EdgeId* edge = edgeOf(locators[side], panels, panel, labels[side]);
        if (!edge) return seam;
        // The end of the first edge meets the start of the second one: B is walked backwards.
        seam.sides[side].push_back({panel->piece, *edge, 0, 1, side == 1});
        names[side] = JsonNode(locators[side])["panel"].text();
    }
    static constexpr std::array kinds{"right_wrong"};
    if (locators.size() == 3 && locators[2].choice(kinds, 0) == 0) seam.sides[1][0].reversed = false;
    seam.name = fmt::format("{} – {}", names[0], names[1]);
    if (!labels[0].empty() && !labels[1].empty() && labels[0] != labels[1])
        warnings.push_back(
            {fmt::format("seam \"{}\"", seam.name),
             fmt::format("its edges are labelled \"{}\" and \"{}\": is it meant?", labels[0], labels[1])});
    return seam;
}

/// Edges of different length are sewn with the difference as ease, as the format leaves the ratio free.
void declareEase(Pattern& pattern, std::vector<Warning>& warnings) {
    constexpr double silent = 0.001; // [m]; as pattern::SeamTolerance
    for (const Seam& seam : std::vector(pattern.seams)) {
        const auto sections = sectionsOf(pattern, seam);
        if (!sections || std::abs(sections->front().mismatch()) <= silent) continue;
        pattern = *easeAway(pattern, seam.id);
        warnings.push_back({fmt::format("seam \"{}\"", seam.name),
                            fmt::format("its sides are {:.1f} and {:.1f} mm long: the difference is taken as ease.",
                                        1000 * sections->front().a, 1000 * sections->front().b)});
    }
}

void judgeSize(const Pattern& pattern, std::vector<Warning>& warnings) {
    double largest = 0;
    for (const auto& piece : pattern.pieces) {
        const geometry::Box2 box = geometry::boundsOf(flattened(piece->outline, 1e-3));
        largest = std::max({largest, box.high.x - box.low.x, box.high.y - box.low.y});
    }
    if (largest < 0.02 || largest > 3)
        warnings.push_back(
            {"units", fmt::format("the largest piece is {:.1f} mm long: is the unit right?", 1000 * largest)});
}

material::Fabric defaultFabric(IdSource& ids) {
    material::Fabric fabric;
    fabric.id = ids.take<FabricId>();
    fabric.name = "Medium cotton";
    fabric.source = "the program's default: the imported file names no fabric";
    return fabric;
}

Imported importedOf(JsonNode root) {
    Imported imported;
    IdSource ids;
    const Units units = unitsOf(root, imported.warnings);
    JsonNode pattern = root.required("pattern");
    JsonNode panels = pattern.required("panels");
    Pattern& made = imported.document.pattern;
    made.fabrics = {defaultFabric(ids)};
    imported.warnings.push_back({"fabrics", "the file names none: all pieces are cut from a default one."});
    std::map<std::string, Panel> panelByName;
    for (const std::string& name : panelNames(pattern, panels)) {
        auto [piece, panel] = pieceOf(panels[name], name, units, ids);
        if (piece.outline.vertices.empty()) return imported; // refused
        piece.fabric = made.fabrics.front()->id;
        if (geometry::signedArea(flattened(piece.outline, 1e-4)) < 0) turnOver(piece);
        made.pieces.emplace_back(std::move(piece));
        panelByName.emplace(name, std::move(panel));
    }
    std::set<EdgeId> sewn;
    for (const JsonNode& stitch : pattern["stitches"].items()) {
        made.seams.push_back(seamOf(stitch, panelByName, ids, imported.warnings));
        for (const auto& side : made.seams.back().sides)
            for (const SeamPart& part : side)
                if (!sewn.insert(part.edge).second) stitch.refuse("An edge can be stitched only once.");
    }
    declareEase(made, imported.warnings);
    judgeSize(made, imported.warnings);
    made = laidOut(made);
    imported.document.nextId = ids.next;
    return imported;
}

} // namespace

bool isGarmentCode(const Json& json) {
    const Json* pattern = json.find("pattern");
    return pattern && pattern->find("panels");
}

Result<Imported> garmentCodeFromText(std::string_view text, const std::string& file) {
    const auto json = parseJson(text, file);
    if (!json) return tl::unexpected<Error>(json.error());
    JsonReading reading{file, {}};
    Imported imported = importedOf(JsonNode(&*json, {}, reading));
    if (reading.error) return tl::unexpected<Error>(*reading.error);
    return imported;
}

Result<Imported> readGarmentCode(const std::string& path) {
    return readRegularFile(path, largestGarmentCode).and_then([&](const std::string& text) {
        return garmentCodeFromText(text, path);
    });
}

} // namespace toile::io
