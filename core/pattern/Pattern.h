// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Id.h"
#include "core/base/Json.h"
#include "core/base/Shared.h"
#include "core/geometry/Curve.h"
#include "core/geometry/Polygon.h"
#include "core/material/Interfacing.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace toile::pattern {

using geometry::EdgeShape;
using geometry::Polygon;
using material::Fabric;
using material::FabricId;
using material::Interfacing;

struct PieceTag;
struct VertexTag;
struct EdgeTag;
struct RegionTag;
struct SeamTag;
struct PinTag;
struct TackTag;
struct FoldTag;
using PieceId = Id<PieceTag>;
using VertexId = Id<VertexTag>;
using EdgeId = Id<EdgeTag>;
using RegionId = Id<RegionTag>;
using SeamId = Id<SeamTag>;
using PinId = Id<PinTag>;
using TackId = Id<TackTag>;
using FoldId = Id<FoldTag>;

struct Vertex {
    VertexId id;
    Vec2 position; ///< [m]
    friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Runs from the vertex of its own index to the next one round the contour.
struct Edge {
    EdgeId id;
    EdgeShape shape;
    std::optional<double> seamAllowance; ///< [m]; absent = the piece's
    friend bool operator==(const Edge&, const Edge&) = default;
};

/// A closed stitching line: as many edges as vertices. Outlines run counter-clockwise seen from the right side
/// of the cloth, holes clockwise.
struct Contour {
    std::vector<Vertex> vertices;
    std::vector<Edge> edges;
    friend bool operator==(const Contour&, const Contour&) = default;
};

[[nodiscard]] geometry::Curve curveOf(const Contour& contour, std::size_t edge);

enum class NotchKind { slit, v, t, castle };

struct Notch {
    EdgeId edge;
    double position = 0.5; ///< fraction of the edge's arc length
    NotchKind kind = NotchKind::slit;
    bool isDouble = false; ///< the trade marks backs with two
    friend bool operator==(const Notch&, const Notch&) = default;
};

/// A place on a contour.
struct BorderPoint {
    EdgeId edge;
    double position = 0.5; ///< fraction of the edge's arc length
    friend bool operator==(const BorderPoint&, const BorderPoint&) = default;
};

/// A line from border to border along which the cloth is pressed.
struct Fold {
    FoldId id;
    std::string name;
    std::array<BorderPoint, 2> ends;
    std::vector<Vec2> between;  ///< where it turns, from the first end to the second
    double angle = 0;           ///< rest angle [rad]; 0 = flat, positive closes the right side
    double stiffnessFactor = 1; ///< bending along the fold, of the cloth's [–]
    Json unknown;               ///< keys of the file that we do not know; kept
    friend bool operator==(const Fold&, const Fold&) = default;
};

/// Drawn, not cut.
struct InternalLine {
    std::string name;
    std::vector<Vec2> points;
    friend bool operator==(const InternalLine&, const InternalLine&) = default;
};

/// Factors on the fabric's constants inside a region.
struct StiffnessFactors {
    double stretch = 1, shear = 1, bending = 1;
    friend bool operator==(const StiffnessFactors&, const StiffnessFactors&) = default;
};

/// A painted part of a piece, meshed at spacing / 2^refinement.
struct Region {
    RegionId id;
    std::string name;
    Polygon outline;
    std::vector<Polygon> holes;
    int refinement = 1;
    StiffnessFactors stiffness;
    Json unknown; ///< keys of the file that we do not know; kept
    friend bool operator==(const Region&, const Region&) = default;
};

/// Where the middle of a rolled piece runs when it follows a bent limb: each circle of the roll stands square to this
/// line, and keeps its radius. At the piece's origin it faces as without the line, and turns nowhere about it. Along
/// the line lengths stay in the middle; outside a bend the piece starts stretched by R/ρ, inside as much shortened,
/// with ρ the bend's radius.
struct BentLine {
    double from = 0;          ///< coordinate along the curl's axis of the line's first point [m]
    std::vector<Vec3> points; ///< in the frame of the placement, from the middle of the roll at the piece's origin [m];
                              ///< two at least. Beyond its ends the line goes on straight
    friend bool operator==(const BentLine&, const BentLine&) = default;
};

/// Rolls the flat piece round a line through its origin before it is placed; the right side faces outward, or inward.
/// A point at distance s from that line, across `axis`, goes to (R·sin(s/R), R·(cos(s/R) − 1)) in the plane
/// across the axis, the second coordinate along the right side's normal.
struct Curl {
    Vec2 axis{0, 1};                ///< unit direction, in the piece, of the lines that stay straight
    double radius = 1;              ///< R [m]; negative = the right side faces inward, as that of a turned-down collar
    std::optional<BentLine> bent{}; ///< absent = the middle of the roll is straight
    friend bool operator==(const Curl&, const Curl&) = default;
};

/// Where a piece starts: the flat piece lies at z = 0 with its right side towards +z, is curled, then moved.
struct Placement {
    Transform transform;
    std::optional<Curl> curl;
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// The point of space where a point of the flat piece starts.
[[nodiscard]] Vec3 placed(const Placement& placement, Vec2 point);

/// The piece is the mirror image of another one; its contour, notches, regions and grain come from there.
struct MirrorOf {
    PieceId source;
    Vec2 lineStart{0, 0}, lineEnd{0, 1};
    friend bool operator==(const MirrorOf&, const MirrorOf&) = default;
};

enum class LineRule { regular, features, paper };
enum class RegionBorder { snap, exact };

struct Piece {
    PieceId id;
    std::string name;
    Contour outline;
    std::vector<Contour> holes;
    double grain = 0; ///< direction of warp from +y, counter-clockwise [rad]
    FabricId fabric;
    std::optional<Interfacing> interfacing; ///< a mirror image has its own
    int plies = 1;         ///< that are cut and lie on one another, joined at their edges; a mirror image has its own
    int layer = 0;         ///< where pieces overlap, the higher lies outside; a mirror image has its own
    double pressure = 0;   ///< of air behind the cloth, towards its right side [Pa]; a mirror image has its own
    double spacing = 0.02; ///< ε_m [m]
    double seamAllowance = 0.01; ///< [m]
    std::vector<Region> regions;
    std::vector<Notch> notches;
    std::vector<Fold> folds;
    std::vector<InternalLine> internalLines;
    bool frozen = false;       ///< its cloth stays where it lies; a mirror image has its own
    bool strengthened = false; ///< stiffer to bend for the time being; a mirror image has its own
    std::optional<Placement> placement;
    std::optional<MirrorOf> mirror;
    LineRule rule = LineRule::regular;
    RegionBorder border = RegionBorder::snap;
    Vec2 tablePosition; ///< where the piece's origin lies on the pattern table, the plane of the 2D view [m];
                        ///< shape, mesh and placement do not depend on it
    Json unknown;       ///< keys of the file that we do not know; kept
    friend bool operator==(const Piece&, const Piece&) = default;
};

/// A stretch of an edge. from < to are fractions of the edge's arc length along the contour's direction;
/// a reversed part is walked from `to` to `from`. Edges of a mirror piece are addressed by the mirror piece's id
/// and the source's edge ids; fractions count along the source's edge.
struct SeamPart {
    PieceId piece;
    EdgeId edge;
    double from = 0, to = 1;
    bool reversed = false;
    friend bool operator==(const SeamPart&, const SeamPart&) = default;
};

/// One stretch between neighbouring notches, in the order of the seam.
struct SeamSection {
    double ease = 0;                   ///< wanted length of side A minus side B [m]
    std::optional<double> gatherRatio; ///< length A / length B wanted; then ease does not count
    friend bool operator==(const SeamSection&, const SeamSection&) = default;
};

/// A band that is sewn in along a seam and draws it up. T = stiffness·(l/l₀ − 1)  [N] with l₀ = ratio · sewn length.
struct Elastic {
    double ratio = 0.7;    ///< length at rest over the sewn length [–], between 0 and 1
    double stiffness = 40; ///< tension per strain of the band [N]
    friend bool operator==(const Elastic&, const Elastic&) = default;
};

/// Two chains of edges that are sewn together, walked so that first meets first and last meets last.
struct Seam {
    SeamId id;
    std::string name;
    std::array<std::vector<SeamPart>, 2> sides;
    std::vector<SeamSection> sections; ///< empty = no ease anywhere
    double foldAngle = 0;              ///< rest angle [rad]; 0 = flat
    double stiffnessFactor = 1;        ///< bending along the seam [–]
    int order = 0;                     ///< smaller is sewn first
    std::optional<Elastic> elastic;    ///< absent = none is sewn in
    Json unknown;                      ///< keys of the file that we do not know; kept
    friend bool operator==(const Seam&, const Seam&) = default;
};

/// Holds a vertex of a piece where it lies: at its starting place, or where it came to lie before it was pinned.
struct Pin {
    PinId id;
    PieceId piece;
    VertexId vertex;
    bool toBody = false; ///< carried along where the body moves
    friend bool operator==(const Pin&, const Pin&) = default;
};

/// A place of the cloth.
struct ClothPoint {
    PieceId piece;
    Vec2 point; ///< in the plane of the piece as it is seen: of a mirror image, in the image [m]
    friend bool operator==(const ClothPoint&, const ClothPoint&) = default;
};

/// Two places of the cloth that thread holds together: a tack, or a button and its hole.
struct Tack {
    TackId id;
    std::string name;
    std::array<ClothPoint, 2> ends;       ///< a button is sewn to the first
    std::optional<double> buttonDiameter; ///< [m]; absent = thread alone
    int order = 0;                        ///< smaller is closed first, with the seams of the same order
    Json unknown;                         ///< keys of the file that we do not know; kept
    friend bool operator==(const Tack&, const Tack&) = default;
};

/// All pieces with their seams and fabrics.
struct Pattern {
    std::vector<Shared<Piece>> pieces;
    std::vector<Seam> seams;
    std::vector<Shared<Fabric>> fabrics;
    std::vector<Pin> pins;
    std::vector<Tack> tacks{};
    friend bool operator==(const Pattern&, const Pattern&) = default;
};

[[nodiscard]] const Piece* findPiece(const Pattern& pattern, const PieceId& id);
[[nodiscard]] const Seam* findSeam(const Pattern& pattern, const SeamId& id);
[[nodiscard]] const Fabric* findFabric(const Pattern& pattern, const FabricId& id);

/// The piece with its own geometry: a mirror piece gets its source's contour, notches, folds, regions, internal lines
/// and grain reflected, with the same ids; the contour again runs counter-clockwise, so edges run against the source's
/// and fractions f of a source edge are 1 − f of the reflected one. Other pieces come back as they are.
[[nodiscard]] Piece resolved(const Pattern& pattern, const Piece& piece);

} // namespace toile::pattern
