// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#ifndef Q_MOC_RUN // moc stumbles over the library's concepts
#include "core/base/Index.h"
#include "core/meshing/DelaunayFlips.h"
#include "core/meshing/FlatTriangles.h"
#include "core/meshing/StripSweep.h"
#include "tests/Suite.h"
#include "tests/meshing/ConstrainedDelaunay.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#endif

using namespace toile;
using namespace toile::meshing;

class tst_StripTriangles : public QObject {
    Q_OBJECT
private slots:
    void orientationIsExactAtTheLimitOfTheGrid();
    void theSweepFillsWhatWallsEnclose();
    void flipsGiveWhatTheRefereeGives();
    void collinearAndCocircularPointsAreFilled();
    void theOrderOfPointsDoesNotMatter();
    void cellsThatTouchAtCornersAreFilledApart();
    void aFlatTriangleOnTheBorderIsTurned();
};

namespace {

struct Drawing {
    std::vector<GridPoint> points;
    std::vector<Wall> walls;
};

/// Adds a star-shaped ring of n corners round a centre, counter-clockwise or clockwise.
void addStar(std::mt19937& random, Drawing& drawing, GridPoint centre, int n, double least, double most, bool hole) {
    std::uniform_real_distribution<double> radius(least, most);
    const int first = static_cast<int>(drawing.points.size());
    for (int i = 0; i < n; ++i) {
        const double r = radius(random), angle = 2 * M_PI * i / n;
        drawing.points.push_back(
            {centre.x + static_cast<int>(r * std::cos(angle)), centre.y + static_cast<int>(r * std::sin(angle))});
        const int here = first + i, next = first + (i + 1) % n;
        drawing.walls.push_back(hole ? Wall{next, here} : Wall{here, next});
    }
}

/// A spiky ring with holes and free points in it.
Drawing randomDrawing(unsigned seed) {
    std::mt19937 random(seed);
    Drawing drawing;
    const int n = 3 + static_cast<int>(random() % 100);
    addStar(random, drawing, {0, 0}, n, 4e4, seed % 3 == 0 ? 4.2e4 : 1e5, false);
    if (n < 6) return drawing; // too narrow for anything inside
    for (int hole = 0; hole < static_cast<int>(random() % 5); ++hole)
        addStar(random, drawing, {hole * 9000 - 18000, hole % 2 * 7000 - 3000}, 3 + static_cast<int>(random() % 40),
                300, 3900, true);
    std::uniform_int_distribution<int> any(-17000, 17000);
    for (int i = 0; i < static_cast<int>(random() % 60); ++i)
        drawing.points.push_back({any(random), 13000 + any(random) / 8});
    return drawing;
}

/// 9 × 9 points, every cell's on a circle; and their border.
Drawing squareGrid() {
    Drawing drawing;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) drawing.points.push_back({x * 1000, y * 1000});
    std::vector<int> ring;
    for (int i = 0; i < 8; ++i) ring.push_back(i);
    for (int i = 0; i < 8; ++i) ring.push_back(i * 9 + 8);
    for (int i = 8; i > 0; --i) ring.push_back(72 + i);
    for (int i = 8; i > 0; --i) ring.push_back(i * 9);
    for (std::size_t i = 0; i < ring.size(); ++i) drawing.walls.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return drawing;
}

TriangleSides swept(const Drawing& drawing) {
    TriangleSides sides;
    StripSweep().run(drawing.points, drawing.walls, sides);
    return sides;
}

TriangleSides triangulated(const Drawing& drawing) {
    TriangleSides sides = swept(drawing);
    DelaunayFlips().run(drawing.points, sides);
    return sides;
}

/// Triangles from their least corner on, rising; corners are renumbered.
std::vector<std::array<int, 3>> canonical(std::vector<std::array<int, 3>> triangles, const std::vector<int>& numbers) {
    for (auto& t : triangles) {
        for (int& corner : t) corner = numbers[at(corner)];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

std::vector<std::array<int, 3>> trianglesOf(const TriangleSides& sides) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < sides.triangles(); ++t) triangles.push_back(sides.corners(t));
    return triangles;
}

std::vector<int> itself(std::size_t count) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

std::vector<std::array<int, 3>> refereed(const Drawing& drawing) {
    std::vector<referee::Constraint> constraints;
    for (const Wall& wall : drawing.walls) constraints.push_back({wall.from, wall.to, true});
    return referee::constrainedDelaunay(drawing.points, constraints);
}

std::int64_t enclosedArea(const Drawing& drawing) {
    std::int64_t sum = 0;
    for (const Wall& wall : drawing.walls) {
        const GridPoint p = drawing.points[at(wall.from)], q = drawing.points[at(wall.to)];
        sum += std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x;
    }
    return sum;
}

/// Every triangle is counter-clockwise, twins are one segment both ways, sides without a twin are the walls, and the
/// areas add up: then nothing is missing and nothing lies twice.
QString fault(const Drawing& drawing, const TriangleSides& sides) {
    std::int64_t area = 0;
    for (int t = 0; t < sides.triangles(); ++t) {
        const auto [a, b, c] = sides.corners(t);
        const std::int64_t own = orientation(drawing.points[at(a)], drawing.points[at(b)], drawing.points[at(c)]);
        if (own <= 0) return QStringLiteral("a triangle is turned over");
        area += own;
    }
    if (area != enclosedArea(drawing)) return QStringLiteral("areas differ");
    std::multiset<std::pair<int, int>> open, walls;
    for (int side = 0; side < static_cast<int>(sides.start.size()); ++side) {
        const int twin = sides.twinOf(side);
        if (twin < 0) open.insert({sides.startOf(side), sides.endOf(side)});
        else if (sides.twinOf(twin) != side || sides.startOf(twin) != sides.endOf(side) ||
                 sides.endOf(twin) != sides.startOf(side))
            return QStringLiteral("twins do not match");
    }
    for (const Wall& wall : drawing.walls) walls.insert({wall.from, wall.to});
    return open == walls ? QString() : QStringLiteral("walls are no sides");
}

} // namespace

void tst_StripTriangles::orientationIsExactAtTheLimitOfTheGrid() {
    constexpr int far = gridLimit - 1; // one unit beside a line as long as the grid
    static_assert(orientation({-far, -far}, {far, far}, {0, 0}) == 0);
    static_assert(orientation({-far, -far}, {far, far}, {0, 1}) > 0);
    static_assert(circleSide({far, 0}, {0, far}, {-far, 0}, {0, -far}) == 0); // on the circle is not inside
    static_assert(circleSide({far, 0}, {0, far}, {-far, 0}, {0, -far + 1}) > 0);
    static_assert(circleSide({far - 1, 0}, {0, far - 1}, {1 - far, 0}, {0, -far}) < 0);
}

void tst_StripTriangles::theSweepFillsWhatWallsEnclose() {
    for (unsigned seed = 1; seed <= 500; ++seed) {
        const Drawing drawing = randomDrawing(seed);
        const QString found = fault(drawing, swept(drawing));
        QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(found)));
    }
}

void tst_StripTriangles::flipsGiveWhatTheRefereeGives() {
    for (unsigned seed = 1; seed <= 500; ++seed) {
        const Drawing drawing = randomDrawing(seed);
        const TriangleSides sides = triangulated(drawing);
        const QString found = fault(drawing, sides);
        QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(found)));
        const std::vector<int> same = itself(drawing.points.size());
        QVERIFY2(canonical(trianglesOf(sides), same) == canonical(refereed(drawing), same),
                 qPrintable(QString::number(seed)));
    }
}

void tst_StripTriangles::collinearAndCocircularPointsAreFilled() {
    const Drawing drawing = squareGrid();
    const TriangleSides sides = triangulated(drawing);
    QCOMPARE(sides.triangles(), 128);
    QCOMPARE(fault(drawing, sides), QString());
    QVERIFY(canonical(trianglesOf(sides), itself(81)) == canonical(refereed(drawing), itself(81)));
}

void tst_StripTriangles::theOrderOfPointsDoesNotMatter() {
    const Drawing drawing = squareGrid();
    const auto expected = canonical(trianglesOf(triangulated(drawing)), itself(81));
    std::mt19937 random(3);
    std::vector<int> order = itself(81);
    for (int trial = 0; trial < 10; ++trial) {
        std::shuffle(order.begin(), order.end(), random); // points[order[i]] becomes point i
        Drawing shuffled;
        std::vector<int> placeOf(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            placeOf[at(order[i])] = static_cast<int>(i);
            shuffled.points.push_back(drawing.points[at(order[i])]);
        }
        for (const Wall& wall : drawing.walls) shuffled.walls.push_back({placeOf[at(wall.from)], placeOf[at(wall.to)]});
        std::shuffle(shuffled.walls.begin(), shuffled.walls.end(), random);
        QVERIFY(canonical(trianglesOf(triangulated(shuffled)), order) == expected);
    }
}

void tst_StripTriangles::cellsThatTouchAtCornersAreFilledApart() {
    // Two squares that share a corner lie in a larger one: four walls meet there.
    Drawing drawing{
        {{0, 0}, {40, 0}, {40, 40}, {0, 40}, {10, 10}, {20, 10}, {20, 20}, {10, 20}, {30, 20}, {30, 30}, {20, 30}},
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {5, 4}, {6, 5}, {7, 6}, {4, 7}, {8, 6}, {9, 8}, {10, 9}, {6, 10}}};
    QCOMPARE(fault(drawing, triangulated(drawing)), QString());
    // And squares of the strip that share one.
    for (Wall& wall : drawing.walls) std::swap(wall.from, wall.to);
    drawing.walls.erase(drawing.walls.begin(), drawing.walls.begin() + 4);
    drawing.points.erase(drawing.points.begin(), drawing.points.begin() + 4);
    for (Wall& wall : drawing.walls) wall = {wall.from - 4, wall.to - 4};
    QCOMPARE(fault(drawing, triangulated(drawing)), QString());
}

void tst_StripTriangles::aFlatTriangleOnTheBorderIsTurned() {
    // The middle node of a straight edge lies one unit beside it.
    const std::vector<GridPoint> points{{0, 0}, {1000, -1}, {2000, 0}, {1000, 1500}};
    TriangleSides sides{{0, 1, 2, 0, 2, 3}, {-1, -1, 3, 2, -1, -1}};
    turnFlatTriangles(std::array{0, 1}, points, sides);
    for (const auto& t : trianglesOf(sides)) {
        QVERIFY(orientation(points[at(t[0])], points[at(t[1])], points[at(t[2])]) > 1000000);
        QVERIFY(std::find(t.begin(), t.end(), 1) != t.end() && std::find(t.begin(), t.end(), 3) != t.end());
    }
    const std::vector<int> before = sides.start; // nothing flat: nothing changes
    turnFlatTriangles(std::array{0, 1}, points, sides);
    QVERIFY(sides.start == before);
}

TOILE_TEST(tst_StripTriangles)
#include "tst_StripTriangles.moc"
