// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"

#include <numbers>

namespace toile::tests {

/// A document in which every field of the format differs from its default at least once.
inline document::Document everyField() {
    using namespace pattern;
    Piece front;
    front.id = PieceId("front");
    front.name = "Front \"left\"";
    front.fabric = FabricId("poplin");
    front.interfacing = Interfacing{8, 0.03};
    front.plies = 2;
    front.layer = 1;
    front.pressure = 12.5;
    front.frozen = front.strengthened = true;
    front.spacing = 0.015;
    front.grain = std::numbers::pi / 6;
    front.seamAllowance = 0.012;
    front.rule = LineRule::features;
    front.border = RegionBorder::exact;
    front.tablePosition = {0.5, -0.25};
    front.outline.vertices = {
        {VertexId("v1"), {0, 0}}, {VertexId("v2"), {0.3, 0}}, {VertexId("v3"), {0.3, 0.4}}, {VertexId("v4"), {0, 0.4}}};
    front.outline.edges = {{EdgeId("e1"), geometry::LineShape{}, 0.02},
                           {EdgeId("e2"), geometry::CubicShape{{0.31, 0.1}, {0.29, 0.3}}, std::nullopt},
                           {EdgeId("e3"), geometry::ArcShape{0.1}, std::nullopt},
                           {EdgeId("e4"), geometry::LineShape{}, std::nullopt}};
    Contour hole;
    hole.vertices = {{VertexId("v5"), {0.1, 0.1}}, {VertexId("v6"), {0.1, 0.15}}, {VertexId("v7"), {0.15, 0.1}}};
    hole.edges = {{EdgeId("e5"), {}, {}}, {EdgeId("e6"), {}, {}}, {EdgeId("e7"), {}, {}}};
    front.holes = {hole};
    front.notches = {{EdgeId("e2"), 1.0 / 3, NotchKind::castle, true}, {EdgeId("e4"), 0.5, NotchKind::slit, false}};
    Fold crease;
    crease.id = FoldId("l1");
    crease.name = "crease";
    crease.ends = {{{EdgeId("e4"), 0.375}, {EdgeId("e2"), 0.625}}};
    crease.between = {{0.15, 0.26}};
    crease.angle = -0.5;
    crease.stiffnessFactor = 4;
    front.folds = {crease};
    front.internalLines = {{"pocket", {{0.2, 0.2}, {0.25, 0.2}}}};
    Region region;
    region.id = RegionId("r1");
    region.name = "shoulder";
    region.outline = {{0.2, 0.3}, {0.3, 0.3}, {0.3, 0.4}, {0.2, 0.4}};
    region.holes = {{{0.22, 0.32}, {0.22, 0.34}, {0.24, 0.32}}};
    region.refinement = 2;
    region.stiffness = {1.5, 0.5, 3};
    front.regions = {region};
    front.placement = Placement{{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0.1, 1.2, 0.3}},
                                Curl{{0, 1}, 0.15, BentLine{-0.2, {{0, -0.2, 0}, {0, 0, 0}, {0, 0.1, 0.02}}}}};

    Piece mirror;
    mirror.id = PieceId("frontRight");
    mirror.name = "Front right";
    mirror.fabric = FabricId("poplin");
    mirror.mirror = MirrorOf{PieceId("front"), {0, 0}, {0, 0.4}};

    material::Fabric poplin;
    poplin.id = FabricId("poplin");
    poplin.name = "Poplin";
    poplin.kind = material::FabricKind::knit;
    poplin.arealDensity = 0.12;
    poplin.warpStiffness = 1500;
    poplin.weftStiffness = 1200;
    poplin.shearStiffness = 35;
    poplin.coupling = 12;
    poplin.warpBending = 11e-6;
    poplin.weftBending = 9e-6;
    poplin.biasBending = 7e-6;
    poplin.thickness = 0.25e-3;
    poplin.friction = 0.35;
    poplin.warpTension = {{0.02, 1.2}, {0.1, 2}};
    poplin.weftTension = {{0.05, 1.1}};
    poplin.source = "measured by us";

    Seam seam;
    seam.id = SeamId("s1");
    seam.name = "centre front";
    seam.sides[0] = {{PieceId("front"), EdgeId("e4"), 0.125, 1, false}};
    seam.sides[1] = {{PieceId("frontRight"), EdgeId("e4"), 0.125, 1, true}};
    seam.sections = {{-0.005, {}}, {0, 1.5}};
    seam.foldAngle = 0.25;
    seam.stiffnessFactor = 2;
    seam.order = 3;
    seam.elastic = Elastic{.ratio = 0.65, .stiffness = 25};

    Tack button;
    button.id = TackId("t1");
    button.name = "top button";
    button.ends = {{{PieceId("front"), {0.05, 0.35}}, {PieceId("frontRight"), {-0.05, 0.35}}}};
    button.buttonDiameter = 0.011;
    button.order = 2;

    document::Document document;
    document.pattern = {
        {front, mirror}, {seam}, {poplin}, {{PinId("n1"), PieceId("front"), VertexId("v3"), true}}, {button}};
    document.avatarFile = "bodies/woman.glb";
    document.scene = {
        {0, -9.8, 0.1}, 0.7, 0.006, 0.004, 0.25, 0.8, 1.0 / 50, 7, true, simulation::Air{{1.5, 0, -2}, 1.1}};
    document.nextId = 42;
    return document;
}

} // namespace toile::tests
