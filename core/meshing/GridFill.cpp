// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/GridFill.h"

#include "core/meshing/Crossings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

constexpr int sameNode = 2; ///< border and lattice nodes this near are one [units]
constexpr std::uint8_t unused = 255;

struct Segment {
    GridPoint a, b;
    int nodeA = 0, nodeB = 0;
};

/// Integer coordinates of the main lines, and which interval an integer coordinate lies in.
struct IntegerLines {
    std::vector<std::int32_t> x, y;

    IntegerLines(const PieceFrame& frame, const Lattice& lattice) {
        for (const double line : lattice.mainX()) x.push_back(frame.gridOf({line, 0}).x);
        for (const double line : lattice.mainY()) y.push_back(frame.gridOf({0, line}).y);
    }
    static int interval(const std::vector<std::int32_t>& lines, std::int64_t value) {
        const auto above = std::upper_bound(lines.begin(), lines.end(), value);
        return std::clamp(static_cast<int>(above - lines.begin()) - 1, 0, static_cast<int>(lines.size()) - 2);
    }
};

std::vector<Segment> segmentsOfRings(const BoundaryNodes& boundary) {
    std::vector<Segment> segments;
    for (const auto& ring : boundary.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const int a = ring[i], b = ring[(i + 1) % ring.size()];
            segments.push_back({boundary.grid[at(a)], boundary.grid[at(b)], a, b});
        }
    return segments;
}

std::vector<std::vector<int>> segmentsByRow(const std::vector<Segment>& segments, const IntegerLines& lines) {
    std::vector<std::vector<int>> byRow(lines.y.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const auto [low, high] = std::minmax(segments[s].a.y, segments[s].b.y);
        const int last = IntegerLines::interval(lines.y, high);
        for (int row = IntegerLines::interval(lines.y, low); row <= last; ++row)
            byRow[at(row)].push_back(static_cast<int>(s));
    }
    return byRow;
}

/// The first integer x to the right of each crossing of the line y, rising; half-open rule y_min ≤ y < y_max.
void crossingsOf(std::int32_t y, const std::vector<int>& candidates, const std::vector<Segment>& segments,
                 std::vector<std::int64_t>& firstRight) {
    firstRight.clear();
    for (const int s : candidates) {
        GridPoint a = segments[at(s)].a, b = segments[at(s)].b;
        if (a.y > b.y) std::swap(a, b);
        if (y < a.y || y >= b.y) continue;
        const std::int64_t numerator = (std::int64_t{y} - a.y) * (std::int64_t{b.x} - a.x),
                           height = std::int64_t{b.y} - a.y;
        std::int64_t quotient = numerator / height;
        if (numerator % height < 0) --quotient; // towards minus infinity
        firstRight.push_back(a.x + quotient + 1);
    }
    std::sort(firstRight.begin(), firstRight.end());
}

bool insideAt(const std::vector<std::int64_t>& firstRight, std::int64_t x) {
    return (std::upper_bound(firstRight.begin(), firstRight.end(), x) - firstRight.begin()) % 2 == 1;
}

/// Tells for rising x whether it lies inside.
class InsideSweep {
public:
    explicit InsideSweep(const std::vector<std::int64_t>& firstRight) : firstRight_(firstRight) {}
    bool operator()(std::int64_t x) {
        while (passed_ < firstRight_.size() && firstRight_[passed_] <= x) ++passed_;
        return passed_ % 2 == 1;
    }

private:
    const std::vector<std::int64_t>& firstRight_;
    std::size_t passed_ = 0;
};

class Filler {
public:
    Filler(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, double cleared)
        : frame_(frame), boundary_(boundary), lattice_(lattice), cleared_(cleared), lines_(frame, lattice),
          segments_(segmentsOfRings(boundary)), byRow_(segmentsByRow(segments_, lines_)) {}

    GridFill run() {
        placeNodes();
        markInside();
        alignBoundary();
        clearNearBorder();
        numberInner();
        blockCells();
        fillCells();
        return std::move(fill_);
    }

private:
    template <class Use>
    void forEachActiveCell(Use use) const {
        for (int row = 0; row < lattice_.rows(); ++row)
            for (int column = 0; column < lattice_.columns(); ++column)
                if (const int u = lattice_.activeDivision(column, row); u > 0) use(column, row, u);
    }

    /// Coordinates, and the coarsest division that has the node: its spacing counts for clearing.
    void placeNodes() {
        fill_.at.assign(at(lattice_.nodeCount()), {});
        coarsest_.assign(at(lattice_.nodeCount()), 0);
        position_.assign(at(lattice_.nodeCount()), {});
        kept_.assign(at(lattice_.nodeCount()), 0);
        if (lattice_.isUniform()) return placeCorners();
        forEachActiveCell([&](int column, int row, int u) {
            for (int b = 0; b <= u; ++b)
                for (int a = 0; a <= u; ++a) {
                    const std::size_t node = at(lattice_.nodeAt(column, row, a, b));
                    if (coarsest_[node] == 0) {
                        position_[node] = {lattice_.xAt(column, a, u), lattice_.yAt(row, b, u)};
                        fill_.at[node] = frame_.gridOf(position_[node]);
                        coarsest_[node] = u;
                    }
                    coarsest_[node] = std::min(coarsest_[node], u);
                }
        });
    }

    /// The same when no main cell is divided: nodes lie in rows.
    void placeCorners() {
        for (int row = 0; row < lattice_.rows(); ++row)
            for (int column = 0; column < lattice_.columns(); ++column) {
                if (!lattice_.active[at(lattice_.cell(column, row))]) continue;
                int* low = coarsest_.data() + lattice_.nodeAt(column, row, 0, 0);
                int* high = low + lattice_.columns() + 1;
                low[0] = low[1] = high[0] = high[1] = 1;
            }
        std::size_t node = 0;
        for (std::size_t row = 0; row < lines_.y.size(); ++row)
            for (std::size_t column = 0; column < lines_.x.size(); ++column, ++node) {
                if (coarsest_[node] == 0) continue;
                position_[node] = {lattice_.mainX()[column], lattice_.mainY()[row]};
                fill_.at[node] = {lines_.x[column], lines_.y[row]};
            }
    }

    void markCorners() {
        std::vector<std::int64_t> crossings;
        std::size_t node = 0;
        for (std::size_t row = 0; row < lines_.y.size(); ++row) {
            crossingsOf(lines_.y[row], byRow_[row], segments_, crossings);
            InsideSweep inside(crossings);
            for (const std::int32_t x : lines_.x) {
                kept_[node] = inside(x) && coarsest_[node] > 0;
                ++node;
            }
        }
    }

    void markInside() {
        if (lattice_.isUniform()) return markCorners();
        std::vector<std::int64_t> crossings;
        for (int row = 0; row < lattice_.rows(); ++row) {
            int finest = 1;
            for (int column = 0; column < lattice_.columns(); ++column)
                for (const int r : {row, row - 1}) finest = std::max(finest, lattice_.activeDivision(column, r));
            for (int b = 0; b < finest; ++b) {
                const std::int32_t y = frame_.gridOf({0, lattice_.yAt(row, b, finest)}).y;
                crossingsOf(y, byRow_[at(row)], segments_, crossings);
                if (!crossings.empty()) markRow(row, b, finest, crossings);
            }
        }
    }

    void markRow(int row, int b, int finest, const std::vector<std::int64_t>& crossings) {
        const auto mark = [&](int node) {
            if (coarsest_[at(node)] > 0) kept_[at(node)] = insideAt(crossings, fill_.at[at(node)].x);
        };
        for (int column = 0; column <= lattice_.columns(); ++column) {
            if (b == 0) {
                const int u = column < lattice_.columns() ? lattice_.horizontalDivision(column, row) : 1;
                if (column == lattice_.columns()) mark(lattice_.verticalNode(column, row, 0));
                else
                    for (int k = 0; k < u; ++k) mark(lattice_.horizontalNode(column, row, k));
                continue;
            }
            const int side = lattice_.verticalDivision(column, row);
            if (b * side % finest == 0) mark(lattice_.verticalNode(column, row, b * side / finest));
            const int u = lattice_.activeDivision(column, row);
            if (u > 0 && b * u % finest == 0)
                for (int a = 1; a < u; ++a) mark(lattice_.nodeAt(column, row, a, b * u / finest));
        }
    }

    /// Boundary nodes that lie on lattice nodes are those nodes and stay.
    void alignBoundary() {
        fill_.node.assign(at(lattice_.nodeCount()), -1);
        const auto gap = [](std::int32_t a, std::int32_t b) { return std::abs(std::int64_t{a} - b); };
        for (std::size_t i = 0; i < boundary_.grid.size(); ++i) {
            const GridPoint p = boundary_.grid[i];
            const int left = IntegerLines::interval(lines_.x, std::int64_t{p.x} - sameNode);
            const int right = IntegerLines::interval(lines_.x, std::int64_t{p.x} + sameNode);
            const int below = IntegerLines::interval(lines_.y, std::int64_t{p.y} - sameNode);
            const int above = IntegerLines::interval(lines_.y, std::int64_t{p.y} + sameNode);
            for (int column = left; column <= right; ++column)
                for (int row = below; row <= above; ++row) {
                    const int u = lattice_.activeDivision(column, row);
                    if (u == 0) continue;
                    const int a = partOf(p.x, lines_.x[at(column)], lines_.x[at(column) + 1], u);
                    const int b = partOf(p.y, lines_.y[at(row)], lines_.y[at(row) + 1], u);
                    const std::size_t node = at(lattice_.nodeAt(column, row, a, b));
                    if (fill_.node[node] >= 0 || gap(fill_.at[node].x, p.x) > sameNode ||
                        gap(fill_.at[node].y, p.y) > sameNode)
                        continue;
                    fill_.node[node] = static_cast<int>(i);
                    fill_.at[node] = p;
                    fill_.aligned.emplace_back(static_cast<int>(i), position_[node]);
                }
        }
    }

    static int partOf(std::int32_t value, std::int32_t low, std::int32_t high, int u) {
        const double part =
            static_cast<double>(std::int64_t{value} - low) / static_cast<double>(std::int64_t{high} - low);
        return std::clamp(static_cast<int>(std::lround(part * u)), 0, u);
    }

    void clearNearBorder() {
        for (int column = 0; column < lattice_.columns(); ++column)
            perUnitX_.push_back(frame_.unit / lattice_.width(column));
        for (int row = 0; row < lattice_.rows(); ++row) perUnitY_.push_back(frame_.unit / lattice_.height(row));
        for (const Segment& segment : segments_) {
            const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
            const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
            const int column0 = IntegerLines::interval(lines_.x, lowX),
                      column1 = IntegerLines::interval(lines_.x, highX);
            const int row0 = IntegerLines::interval(lines_.y, lowY), row1 = IntegerLines::interval(lines_.y, highY);
            for (int row = std::max(0, row0 - 1); row <= std::min(lattice_.rows() - 1, row1 + 1); ++row)
                for (int column = std::max(0, column0 - 1); column <= std::min(lattice_.columns() - 1, column1 + 1);
                     ++column)
                    clearCell(segment, column, row);
        }
    }

    /// Distances are measured in cells, so that oblong cells are cleared alike both ways.
    void clearCell(const Segment& segment, int column, int row) {
        const int u = lattice_.activeDivision(column, row);
        if (u == 0) return;
        const double x0 = lines_.x[at(column)], y0 = lines_.y[at(row)];
        const double scaleX = perUnitX_[at(column)], scaleY = perUnitY_[at(row)];
        const Vec2 a{(segment.a.x - x0) * scaleX, (segment.a.y - y0) * scaleY};
        const Vec2 b{(segment.b.x - x0) * scaleX, (segment.b.y - y0) * scaleY};
        const auto range = [&](double low, double high) { // of node lines
            const double first = (low - cleared_) * u, last = (high + cleared_) * u;
            if (u > 1)
                return std::pair(std::max(0, static_cast<int>(std::ceil(first))),
                                 std::min(u, static_cast<int>(std::floor(last))));
            return std::pair(first <= 0 ? 0 : first <= 1 ? 1 : 2, last < 0 ? -1 : last < 1 ? 0 : 1); // the same, faster
        };
        const auto [a0, a1] = range(std::min(a.x, b.x), std::max(a.x, b.x));
        const auto [b0, b1] = range(std::min(a.y, b.y), std::max(a.y, b.y));
        for (int j = b0; j <= b1; ++j)
            for (int i = a0; i <= a1; ++i) {
                const std::size_t node = at(lattice_.nodeAt(column, row, i, j));
                if (!kept_[node]) continue;
                const Vec2 p{static_cast<double>(i) / u, static_cast<double>(j) / u};
                const double radius = cleared_ / coarsest_[node];
                if (squaredLength(p - geometry::closestOnSegment(a, b, p)) < radius * radius * (1 - 1e-9))
                    kept_[node] = 0;
            }
    }

    void numberInner() {
        int next = static_cast<int>(boundary_.points.size());
        const auto most = static_cast<std::size_t>(std::count(kept_.begin(), kept_.end(), char{1}));
        fill_.inner.reserve(most);
        fill_.innerGrid.reserve(most);
        for (std::size_t node = 0; node < fill_.node.size(); ++node) {
            if (fill_.node[node] >= 0 || !kept_[node]) continue;
            fill_.node[node] = next++;
            fill_.inner.push_back(position_[node]);
            fill_.innerGrid.push_back(fill_.at[node]);
        }
    }

    /// Cells that hold or touch a border segment in any way but by sharing a side or a corner are blocked.
    void blockCells() {
        blocked_.assign(at(lattice_.cellCount()), 0);
        for (const Segment& segment : segments_) {
            const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
            const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
            const int column0 = IntegerLines::interval(lines_.x, std::int64_t{lowX} - sameNode - 1);
            const int column1 = IntegerLines::interval(lines_.x, std::int64_t{highX} + sameNode + 1);
            const int row0 = IntegerLines::interval(lines_.y, std::int64_t{lowY} - sameNode - 1);
            const int row1 = IntegerLines::interval(lines_.y, std::int64_t{highY} + sameNode + 1);
            for (int row = row0; row <= row1; ++row)
                for (int column = column0; column <= column1; ++column) blockIn(segment, column, row);
        }
    }

    void blockIn(const Segment& segment, int column, int row) {
        const int u = lattice_.activeDivision(column, row);
        if (u == 0) return;
        const auto range = [&](std::int32_t p, std::int32_t q, std::int32_t low, std::int32_t high) {
            if (u == 1) return std::pair(0, 0);
            const double size = static_cast<double>(std::int64_t{high} - low) / u;
            const double first = (static_cast<double>(std::min(p, q)) - low - sameNode) / size;
            const double last = (static_cast<double>(std::max(p, q)) - low + sameNode) / size;
            return std::pair(std::clamp(static_cast<int>(std::floor(first)), 0, u - 1),
                             std::clamp(static_cast<int>(std::floor(last)), 0, u - 1));
        };
        const auto [a0, a1] = range(segment.a.x, segment.b.x, lines_.x[at(column)], lines_.x[at(column) + 1]);
        const auto [b0, b1] = range(segment.a.y, segment.b.y, lines_.y[at(row)], lines_.y[at(row) + 1]);
        for (int b = b0; b <= b1; ++b)
            for (int a = a0; a <= a1; ++a) {
                char& flag = blocked_[at(lattice_.firstCell(column, row) + b * u + a)];
                if (!flag) flag = disturbs(segment, column, row, a, b);
            }
    }

    [[nodiscard]] std::array<int, 4> cornersOf(int column, int row, int a, int b) const {
        return {lattice_.nodeAt(column, row, a, b), lattice_.nodeAt(column, row, a + 1, b),
                lattice_.nodeAt(column, row, a + 1, b + 1), lattice_.nodeAt(column, row, a, b + 1)};
    }

    [[nodiscard]] bool disturbs(const Segment& segment, int column, int row, int a, int b) const {
        const std::array<int, 4> corners = cornersOf(column, row, a, b);
        std::array<GridPoint, 4> quad;
        for (std::size_t i = 0; i < 4; ++i) quad[i] = fill_.at[at(corners[i])];
        const auto cornerAt = [&](GridPoint p) {
            for (int i = 0; i < 4; ++i)
                if (quad[at(i)] == p) return i;
            return -1;
        };
        const auto holds = [&](GridPoint p) { // or on a side, which lies beside the nodes on it as its corners do
            for (std::size_t i = 0; i < 4; ++i) {
                const GridPoint from = quad[i], to = quad[(i + 1) % 4];
                const std::int64_t length = std::max(std::abs(std::int64_t{to.x} - from.x), //
                                                     std::abs(std::int64_t{to.y} - from.y));
                if (orientation(from, to, p) < -sameNode * length) return false;
            }
            return true;
        };
        const int ca = cornerAt(segment.a), cb = cornerAt(segment.b);
        if ((ca < 0 && holds(segment.a)) || (cb < 0 && holds(segment.b))) return true;
        if (ca >= 0 && cb >= 0) return (ca + cb) % 2 == 0; // a diagonal
        for (int i = 0; i < 4; ++i) {
            if (i != ca && i != cb && onSegment(segment.a, segment.b, quad[at(i)])) return true;
            const int j = (i + 1) % 4;
            const bool shares = i == ca || i == cb || j == ca || j == cb;
            if (!shares && segmentsMeet(segment.a, segment.b, quad[at(i)], quad[at(j)])) return true;
        }
        return false;
    }

    void fillCells() {
        ringNeighbours();
        fill_.filled.assign(at(lattice_.cellCount()), 0);
        if (lattice_.isUniform()) return fillUniform();
        forEachActiveCell([&](int column, int row, int u) {
            for (int b = 0; b < u; ++b)
                for (int a = 0; a < u; ++a) {
                    const std::size_t cell = at(lattice_.firstCell(column, row) + b * u + a);
                    fill_.filled[cell] = !blocked_[cell] && isFilled(cornersOf(column, row, a, b));
                }
        });
    }

    void fillUniform() {
        const int* node = fill_.node.data();
        const int width = lattice_.columns() + 1;
        std::size_t cell = 0;
        for (int row = 0; row < lattice_.rows(); ++row)
            for (int column = 0; column < lattice_.columns(); ++column) {
                if (!lattice_.active[at(lattice_.cell(column, row))]) continue;
                const int low = row * width + column, high = low + width;
                const bool used = (node[low] | node[low + 1] | node[high] | node[high + 1]) >= 0; // no sign bit is set
                fill_.filled[cell] = used && !blocked_[cell] && isFilled({low, low + 1, high + 1, high});
                ++cell;
            }
    }

    void ringNeighbours() {
        before_.assign(boundary_.grid.size(), -1);
        after_ = before_;
        for (const Segment& segment : segments_) {
            after_[at(segment.nodeA)] = segment.nodeB;
            before_[at(segment.nodeB)] = segment.nodeA;
        }
    }

    [[nodiscard]] bool isFilled(const std::array<int, 4>& corners) const {
        const int boundaryCount = static_cast<int>(boundary_.grid.size());
        int onBorder = -1;
        for (int i = 0; i < 4; ++i) {
            const int node = fill_.node[at(corners[at(i)])];
            if (node < 0) return false;
            if (node < boundaryCount) onBorder = i;
            else return everyCornerUsed(corners); // strictly inside, and nothing comes between
        }
        const auto cornerNode = [&](int i) { return at(fill_.node[at(corners[at(i % 4)])]); };
        const std::size_t node = cornerNode(onBorder);
        return insideCorner(boundary_.grid[at(before_[node])], boundary_.grid[node], boundary_.grid[at(after_[node])],
                            boundary_.grid[cornerNode(onBorder + 2)]);
    }

    [[nodiscard]] bool everyCornerUsed(const std::array<int, 4>& corners) const {
        return std::all_of(corners.begin(), corners.end(), [&](int corner) { return fill_.node[at(corner)] >= 0; });
    }

    const PieceFrame& frame_;
    const BoundaryNodes& boundary_;
    const Lattice& lattice_;
    double cleared_; ///< of the spacing [–]
    IntegerLines lines_;
    std::vector<Segment> segments_;
    std::vector<std::vector<int>> byRow_;
    GridFill fill_;
    std::vector<int> coarsest_; ///< smallest u among the main cells that have the node; 0 = none is active
    std::vector<Vec2> position_;
    std::vector<char> kept_, blocked_;
    std::vector<double> perUnitX_, perUnitY_; ///< part of a main column's (row's) size [–]
    std::vector<int> before_, after_;
};

} // namespace

void markActiveCells(const PieceFrame& frame, const std::vector<std::vector<GridPoint>>& rings, Lattice& lattice) {
    const IntegerLines lines(frame, lattice);
    std::vector<Segment> segments;
    for (const RingSegment& s : segmentsOf(rings)) segments.push_back({s.a, s.b, 0, 0});
    const std::vector<std::vector<int>> byRow = segmentsByRow(segments, lines);
    std::vector<std::int32_t> middles;
    for (std::size_t column = 0; column + 1 < lines.x.size(); ++column)
        middles.push_back(lines.x[column] + (lines.x[column + 1] - lines.x[column]) / 2);
    std::vector<std::int64_t> crossings;
    std::size_t cell = 0;
    for (int row = 0; row < lattice.rows(); ++row) {
        const std::int32_t middle = lines.y[at(row)] + (lines.y[at(row) + 1] - lines.y[at(row)]) / 2;
        crossingsOf(middle, byRow[at(row)], segments, crossings);
        InsideSweep inside(crossings);
        for (const std::int32_t x : middles) lattice.active[cell++] = inside(x);
    }
    for (const Segment& segment : segments) {
        const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
        const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
        const int row1 = IntegerLines::interval(lines.y, std::int64_t{highY} + sameNode);
        const int column1 = IntegerLines::interval(lines.x, std::int64_t{highX} + sameNode);
        for (int row = IntegerLines::interval(lines.y, std::int64_t{lowY} - sameNode); row <= row1; ++row)
            for (int column = IntegerLines::interval(lines.x, std::int64_t{lowX} - sameNode); column <= column1;
                 ++column)
                lattice.active[at(lattice.cell(column, row))] = 1;
    }
}

GridFill fillLattice(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice, double cleared) {
    return Filler(frame, boundary, lattice, cleared).run();
}

} // namespace toile::meshing
