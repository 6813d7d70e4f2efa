// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/meshing/MeshInput.h"

#include <fmt/format.h>

/// Inputs of the mesher as JSON, for the corpus of inputs that once failed. Numbers come back bit for bit.
namespace toile::meshing {

inline Json jsonOf(Vec2 p) {
    return Json(Json::Array{p.x, p.y});
}

inline Json jsonOf(const Polygon& polygon) {
    Json json{Json::Array{}};
    for (const Vec2 p : polygon) json.push(jsonOf(p));
    return json;
}

inline Json jsonOf(const BoundaryLoop& loop) {
    Json edges{Json::Array{}};
    for (const BoundaryEdge& edge : loop) {
        Json json, notches{Json::Array{}};
        for (const double notch : edge.notches) notches.push(notch);
        json.set("start", jsonOf(edge.curve.start)).set("end", jsonOf(edge.curve.end)).set("notches", notches);
        if (const auto* arc = std::get_if<geometry::ArcShape>(&edge.curve.shape)) json.set("bulge", arc->bulge);
        if (const auto* cubic = std::get_if<geometry::CubicShape>(&edge.curve.shape))
            json.set("control1", jsonOf(cubic->control1)).set("control2", jsonOf(cubic->control2));
        edges.push(json);
    }
    return edges;
}

inline Json jsonOf(const FoldInput& fold) {
    Json json, ends{Json::Array{}};
    for (const FoldEndInput& end : fold.ends) {
        Json one;
        ends.push(one.set("loop", end.loop).set("edge", end.edge).set("fraction", end.fraction));
    }
    return json.set("points", jsonOf(fold.points)).set("ends", ends);
}

inline Json jsonOf(const PieceInput& piece) {
    Json json, holes{Json::Array{}}, regions{Json::Array{}}, folds{Json::Array{}};
    for (const FoldInput& fold : piece.folds) folds.push(jsonOf(fold));
    for (const BoundaryLoop& hole : piece.holes) holes.push(jsonOf(hole));
    for (const RegionInput& region : piece.regions) {
        Json one, regionHoles{Json::Array{}};
        for (const Polygon& hole : region.holes) regionHoles.push(jsonOf(hole));
        regions.push(
            one.set("outline", jsonOf(region.outline)).set("holes", regionHoles).set("refinement", region.refinement));
    }
    json.set("spacing", piece.spacing).set("grain", piece.grain).set("rule", static_cast<int>(piece.rule));
    json.set("border", static_cast<int>(piece.border)).set("mirrored", piece.mirrored);
    return json.set("outline", jsonOf(piece.outline)).set("holes", holes).set("regions", regions).set("folds", folds);
}

inline Json jsonOf(const SeamInput& seam) {
    Json sides{Json::Array{}}, sections{Json::Array{}};
    for (const auto& side : seam.sides) {
        Json parts{Json::Array{}};
        for (const SeamPartInput& part : side) {
            Json json;
            json.set("piece", part.piece).set("loop", part.loop).set("edge", part.edge).set("from", part.from);
            parts.push(json.set("to", part.to).set("reversed", part.reversed));
        }
        sides.push(parts);
    }
    for (const SeamSectionInput& section : seam.sections) {
        Json json;
        json.set("ease", section.ease);
        if (section.gatherRatio) json.set("gatherRatio", *section.gatherRatio);
        sections.push(json);
    }
    Json json;
    return json.set("sides", sides).set("sections", sections);
}

inline Json jsonOf(const MeshInput& input) {
    Json pieces{Json::Array{}}, seams{Json::Array{}}, json;
    for (const PieceInput& piece : input.pieces) pieces.push(jsonOf(piece));
    for (const SeamInput& seam : input.seams) seams.push(jsonOf(seam));
    return json.set("pieces", pieces).set("seams", seams);
}

/// Reads what jsonOf wrote; a file of the corpus that is not such a text is a bug of ours.
struct InputReader {
    static double number(const Json& json, const char* key) { return *json.find(key)->asNumber(); }
    static int whole(const Json& json, const char* key) { return static_cast<int>(number(json, key)); }
    static const Json::Array& items(const Json& json, const char* key) { return *json.find(key)->asArray(); }
    static Vec2 point(const Json& json) { return {*(*json.asArray())[0].asNumber(), *(*json.asArray())[1].asNumber()}; }

    static Polygon polygon(const Json& json) {
        Polygon polygon;
        for (const Json& p : *json.asArray()) polygon.push_back(point(p));
        return polygon;
    }

    static BoundaryLoop loop(const Json& json) {
        BoundaryLoop loop;
        for (const Json& edge : *json.asArray()) {
            BoundaryEdge read{
                {point(*edge.find("start")), point(*edge.find("end")), {}}, {}, fmt::format("e{}", loop.size())};
            for (const Json& notch : items(edge, "notches")) read.notches.push_back(*notch.asNumber());
            if (edge.find("bulge")) read.curve.shape = geometry::ArcShape{number(edge, "bulge")};
            if (edge.find("control1"))
                read.curve.shape = geometry::CubicShape{point(*edge.find("control1")), point(*edge.find("control2"))};
            loop.push_back(std::move(read));
        }
        return loop;
    }

    static FoldInput fold(const Json& json, std::size_t index) {
        FoldInput fold{fmt::format("f{}", index), polygon(*json.find("points")), {}};
        for (std::size_t end = 0; end < 2; ++end) {
            const Json& one = items(json, "ends")[end];
            fold.ends[end] = {whole(one, "loop"), whole(one, "edge"), number(one, "fraction")};
        }
        return fold;
    }

    static PieceInput piece(const Json& json, std::string label) {
        PieceInput piece;
        piece.label = std::move(label);
        piece.outline = loop(*json.find("outline"));
        for (const Json& hole : items(json, "holes")) piece.holes.push_back(loop(hole));
        piece.spacing = number(json, "spacing");
        piece.grain = number(json, "grain");
        piece.rule = static_cast<LineRule>(whole(json, "rule"));
        piece.border = static_cast<RegionBorder>(whole(json, "border"));
        piece.mirrored = *json.find("mirrored")->asBool();
        for (const Json& region : items(json, "regions")) {
            RegionInput read{fmt::format("r{}", piece.regions.size()),
                             polygon(*region.find("outline")),
                             {},
                             whole(region, "refinement")};
            for (const Json& hole : items(region, "holes")) read.holes.push_back(polygon(hole));
            piece.regions.push_back(std::move(read));
        }
        if (json.find("folds")) // older texts have none
            for (const Json& one : items(json, "folds")) piece.folds.push_back(fold(one, piece.folds.size()));
        return piece;
    }

    static SeamInput seam(const Json& json, std::string label) {
        SeamInput seam{std::move(label), {}, {}};
        for (std::size_t side = 0; side < 2; ++side)
            for (const Json& part : *items(json, "sides")[side].asArray())
                seam.sides[side].push_back({whole(part, "piece"), whole(part, "loop"), whole(part, "edge"),
                                            number(part, "from"), number(part, "to"),
                                            *part.find("reversed")->asBool()});
        for (const Json& section : items(json, "sections")) {
            seam.sections.push_back({number(section, "ease"), {}});
            if (section.find("gatherRatio")) seam.sections.back().gatherRatio = number(section, "gatherRatio");
        }
        return seam;
    }

    static MeshInput input(const Json& json) {
        MeshInput input;
        for (const Json& one : items(json, "pieces"))
            input.pieces.push_back(piece(one, fmt::format("P{}", input.pieces.size())));
        for (const Json& one : items(json, "seams"))
            input.seams.push_back(seam(one, fmt::format("s{}", input.seams.size())));
        return input;
    }
};

} // namespace toile::meshing
