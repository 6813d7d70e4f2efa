// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/meshing/MeshFixtures.h"

#include <cstdint>
#include <fmt/format.h>

/// Random garments: a seed means the same input everywhere.
namespace toile::meshing {

/// SplitMix64 (Steele 2014): neighbouring seeds have nothing in common.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double operator()(double low, double high) {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        z ^= z >> 31;
        return low + (high - low) * static_cast<double>(z >> 11) / 9007199254740992.0;
    }
    int whole(int low, int high) { return low + static_cast<int>((*this)(0, 1) * (high - low + 1)); }
    bool chance(double probability) { return (*this)(0, 1) < probability; }

private:
    std::uint64_t state_;
};

class RandomMeshInput {
public:
    explicit RandomMeshInput(std::uint64_t seed) : random_(seed) {}

    MeshInput operator()() {
        MeshInput input;
        for (int n = random_.whole(1, 3); n > 0; --n)
            input.pieces.push_back(piece(static_cast<int>(input.pieces.size())));
        if (random_.chance(0.1)) {
            const double factor = std::pow(10.0, random_(-2, 2));
            for (PieceInput& each : input.pieces) scale(each, factor);
        }
        if (random_.chance(0.6))
            for (int n = random_.whole(1, 3); n > 0; --n) input.seams.push_back(seam(input));
        return input;
    }

private:
    PieceInput piece(int number) {
        PieceInput piece;
        switch (random_.whole(0, 12)) {
        case 0: piece.outline = loopThrough(star({0, 0}, random_.whole(3, 14))); break;
        case 1: piece.outline = loopThrough(box(random_(0.02, 0.6), random_(0.004, 0.5))); break;
        case 2: piece.outline = loopThrough(stairs()); break;
        case 3: piece.outline = loopThrough(slitBox()); break;
        case 4: piece.outline = loopThrough(digitised(random_.whole(50, 250))); break;
        case 5: piece.outline = circleLoop({random_(-1, 1), random_(-1, 1)}, random_(0.02, 0.3)); break;
        case 6: piece.outline = loopThrough(garbage()); break;
        default:
            piece.outline = loopThrough(star({random_(-1, 1), random_(-1, 1)}, random_.whole(3, 20), 0.1, 0.3));
            break;
        }
        piece.label = fmt::format("P{}", number);
        // Mostly coarse: what goes wrong goes wrong among few cells, and a hundred thousand of these take minutes.
        piece.spacing = std::pow(10.0, random_(random_.chance(0.1) ? -1.9 : -1.4, -0.7));
        curve(piece);
        for (BoundaryEdge& edge : piece.outline)
            if (random_.chance(0.15)) edge.notches = {random_(0.05, 0.5), random_(0.5, 0.95)};
        for (int n = random_.chance(0.3) ? random_.whole(1, 3) : 0; n > 0; --n)
            piece.holes.push_back(hole(within(piece)));
        for (int n = random_.chance(0.4) ? random_.whole(1, 3) : 0; n > 0; --n)
            piece.regions.push_back(region(n, within(piece)));
        for (int n = random_.chance(0.15) ? random_.whole(1, 2) : 0; n > 0; --n) piece.folds.push_back(fold(n, piece));
        piece.grain = random_.chance(0.5) ? 0 : random_(-4, 4);
        piece.rule = static_cast<LineRule>(random_.chance(0.6) ? 0 : random_.whole(0, 2));
        piece.border = static_cast<RegionBorder>(random_.whole(0, 1));
        piece.mirrored = random_.chance(0.3);
        // A giant sewn to a dwarf asks for a million nodes: rarely, for the time they take.
        if (random_.chance(0.005)) scale(piece, std::pow(10.0, random_(-2, 2)));
        return piece;
    }

    /// Star-shaped about the centre, hence simple.
    std::vector<Vec2> star(Vec2 centre, int corners, double least = 0.05, double most = 0.4) {
        std::vector<Vec2> points;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * (i + random_(-0.3, 0.3)) / corners, r = random_(least, most);
            points.push_back(centre + Vec2{r * std::cos(angle), r * std::sin(angle)});
        }
        return points;
    }

    static std::vector<Vec2> box(double width, double height) {
        return {{0, 0}, {width, 0}, {width, height}, {0, height}};
    }

    /// Straight along the grain, with steps.
    std::vector<Vec2> stairs() {
        std::vector<Vec2> points{{0, 0}};
        double x = 0, y = random_(0.2, 0.5);
        const int steps = random_.whole(1, 5);
        for (int i = 0; i < steps; ++i) x += random_(0.02, 0.15);
        points.push_back({x, 0});
        for (int i = 0; i < steps; ++i) {
            points.push_back({x, y});
            x = i + 1 == steps ? 0 : x * random_(0.3, 0.9);
            points.push_back({x, y});
            y *= random_(0.6, 1.3);
        }
        return points;
    }

    /// A box with a slit or a dart of any width.
    std::vector<Vec2> slitBox() {
        const double width = random_(0.1, 0.5), height = random_(0.1, 0.5), at = random_(0.2, 0.8) * width;
        const double half = std::pow(10.0, random_(-6, -1.5)) * width, depth = random_(0.1, 0.95) * height;
        std::vector<Vec2> points{{0, 0}, {at - half, 0}};
        if (random_.chance(0.5)) points.push_back({at + random_(-1, 1) * half, depth});
        else points.insert(points.end(), {{at - half, depth}, {at + half, depth}});
        points.insert(points.end(), {{at + half, 0}, {width, 0}, {width, height}, {0, height}});
        return points;
    }

    std::vector<Vec2> digitised(int points) {
        std::vector<Vec2> outline;
        const double waves = random_.whole(2, 7), depth = random_(0, 0.1), noise = std::pow(10.0, random_(-7, -3.5));
        for (int i = 0; i < points; ++i) {
            const double angle = 2 * std::numbers::pi * i / points,
                         r = 0.3 + depth * std::sin(waves * angle) + random_(-noise, noise);
            outline.push_back({r * std::cos(angle), 0.7 * r * std::sin(angle)});
        }
        return outline;
    }

    /// Corners on a coarse grid: double points, overlaps, crossings.
    std::vector<Vec2> garbage() {
        std::vector<Vec2> points;
        for (int n = random_.whole(1, 8); n > 0; --n)
            points.push_back({0.05 * random_.whole(0, 5), 0.05 * random_.whole(0, 5)});
        return points;
    }

    void curve(PieceInput& piece) {
        if (!random_.chance(0.3)) return;
        for (BoundaryEdge& edge : piece.outline) {
            if (!std::holds_alternative<geometry::LineShape>(edge.curve.shape) || !random_.chance(0.3)) continue;
            const Vec2 along = edge.curve.end - edge.curve.start;
            if (random_.chance(0.5)) edge.curve.shape = geometry::ArcShape{random_(-0.1, 0.1)};
            else
                edge.curve.shape = geometry::CubicShape{
                    edge.curve.start + along * random_(0.1, 0.5) + leftOf(along) * random_(-0.06, 0.06),
                    edge.curve.start + along * random_(0.5, 0.9) + leftOf(along) * random_(-0.06, 0.06)};
        }
    }

    /// Mostly a point inside the outline.
    Vec2 within(const PieceInput& piece) {
        Polygon outline;
        for (const BoundaryEdge& edge : piece.outline) outline.push_back(edge.curve.start);
        if (piece.outline.size() == 2) return lerp(outline[0], outline[1], random_(0.2, 0.8)); // a circle
        const geometry::Box2 box = geometry::boundsOf(outline);
        Vec2 point;
        for (int attempt = 0; attempt < 12; ++attempt) {
            point = {random_(box.low.x, box.high.x), random_(box.low.y, box.high.y)};
            if (geometry::windingNumber(outline, point) != 0) break;
        }
        return point;
    }

    BoundaryLoop hole(Vec2 centre) {
        const double size = std::pow(10.0, random_(-3, -1.2));
        if (random_.chance(0.4)) return circleLoop(centre, size, true);
        std::vector<Vec2> corners = star(centre, random_.whole(3, 8), 0.3 * size, size);
        std::reverse(corners.begin(), corners.end());
        return loopThrough(corners);
    }

    RegionInput region(int number, Vec2 centre) {
        RegionInput region{fmt::format("r{}", number), {}, {}, random_.whole(0, 3)};
        const double size = random_(0.03, 0.2);
        region.outline = star(centre, random_.whole(3, 9), 0.6 * size, size);
        if (random_.chance(0.5))
            region.outline = {centre, centre + Vec2{size, 0}, centre + Vec2{size, size}, centre + Vec2{0, size}};
        if (random_.chance(0.3)) region.holes.push_back(star(centre, 5, 0.005, 0.03));
        return region;
    }

    /// Between any two places of any border; most that are bent, or of a star, leave the piece.
    FoldInput fold(int number, const PieceInput& piece) {
        const auto loopOf = [&](int loop) -> const BoundaryLoop& {
            return loop == 0 ? piece.outline : piece.holes[static_cast<std::size_t>(loop - 1)];
        };
        const auto end = [&] {
            const int loop = random_.chance(0.8) ? 0 : random_.whole(0, static_cast<int>(piece.holes.size()));
            const int edge = random_.whole(0, static_cast<int>(loopOf(loop).size()) - 1);
            return FoldEndInput{loop, edge, random_.chance(0.2) ? 0 : random_(0, 1)};
        };
        const auto pointAt = [&](const FoldEndInput& at) {
            return geometry::ArcLength(loopOf(at.loop)[static_cast<std::size_t>(at.edge)].curve).pointAt(at.fraction);
        };
        const FoldEndInput a = end(), b = end();
        const Vec2 from = pointAt(a), to = pointAt(b);
        FoldInput fold{fmt::format("f{}", number), {from}, {a, b}};
        if (random_.chance(0.3)) fold.points.push_back(lerp(from, to, 0.5) + Vec2{random_(-0.02, 0.02), 0});
        fold.points.push_back(to);
        return fold;
    }

    static void scale(PieceInput& piece, double factor) {
        const auto scaleLoop = [&](BoundaryLoop& loop) {
            for (BoundaryEdge& edge : loop) {
                edge.curve.start = edge.curve.start * factor;
                edge.curve.end = edge.curve.end * factor;
                if (auto* cubic = std::get_if<geometry::CubicShape>(&edge.curve.shape))
                    *cubic = {cubic->control1 * factor, cubic->control2 * factor};
            }
        };
        scaleLoop(piece.outline);
        for (BoundaryLoop& loop : piece.holes) scaleLoop(loop);
        for (RegionInput& region : piece.regions) {
            for (Vec2& p : region.outline) p = p * factor;
            for (Polygon& polygon : region.holes)
                for (Vec2& p : polygon) p = p * factor;
        }
        for (FoldInput& fold : piece.folds)
            for (Vec2& p : fold.points) p = p * factor;
        piece.spacing *= factor;
    }

    /// A chain of one to three neighbouring edges; now and then of nonsense.
    std::vector<SeamPartInput> chain(const MeshInput& input) {
        const int piece = random_.whole(0, static_cast<int>(input.pieces.size()) - 1);
        const int edges = static_cast<int>(input.pieces[static_cast<std::size_t>(piece)].outline.size());
        const int first = random_.whole(0, edges - 1), count = std::min(edges, random_.whole(1, 3));
        const bool reversed = random_.chance(0.5);
        std::vector<SeamPartInput> parts;
        for (int i = 0; i < count; ++i)
            parts.push_back({piece, 0, ((reversed ? first - i : first + i) + edges) % edges, 0, 1, reversed});
        if (count == 1 && random_.chance(0.4)) {
            parts[0].from = random_(0, 0.45);
            parts[0].to = random_(0.55, 1);
        }
        if (random_.chance(0.03)) parts[0].reversed = !parts[0].reversed;
        if (random_.chance(0.02)) parts[0].edge = edges + 3;
        return parts;
    }

    SeamInput seam(const MeshInput& input) {
        SeamInput seam{"s", {chain(input), chain(input)}, {}};
        const auto lengthOf = [&](const std::vector<SeamPartInput>& parts) {
            double sum = 0;
            for (const SeamPartInput& part : parts) {
                const auto& outline = input.pieces[static_cast<std::size_t>(part.piece)].outline;
                if (part.edge < static_cast<int>(outline.size()))
                    sum += (part.to - part.from) * geometry::length(outline[static_cast<std::size_t>(part.edge)].curve);
            }
            return sum;
        };
        const double a = lengthOf(seam.sides[0]), b = lengthOf(seam.sides[1]);
        if (b > 0 && random_.chance(0.95)) seam.sections = {{0, a / b}}; // of the whole seam: notches may not fit
        return seam;
    }

    Random random_;
};

} // namespace toile::meshing
