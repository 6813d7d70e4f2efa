// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "core/collision/Intersections.h"
#include "core/simulation/ClothParts.h"
#include "tests/Suite.h"
#include "tests/collision/Shapes.h"
#include "tests/simulation/Tubes.h"

#include <set>

using namespace toile;
using namespace toile::simulation;
using geometry::TriangleMesh;

namespace {

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
    const int first = static_cast<int>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + first, j + first, k + first});
    return a;
}

/// How often the mesh winds round a point just before a triangle, all triangles summed up.
long windingBefore(const TriangleMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3 &A = mesh.vertices[a], &B = mesh.vertices[b], &C = mesh.vertices[c];
    return std::lround(shapes::windingNumber(mesh, (A + B + C) / 3 + 1e-7 * normalized(cross(B - A, C - A))));
}

std::set<std::size_t> sizesOf(const std::vector<std::vector<int>>& regions) {
    std::set<std::size_t> sizes;
    for (const auto& region : regions) sizes.insert(region.size());
    return sizes;
}

} // namespace

/// What of the cloth hangs together.
class tst_ClothParts : public QObject {
    Q_OBJECT
private slots:
    void aMoebiusBandKeepsATurnedEdge();
    void whatNothingPassesThroughIsOneRegion();
    void surfacesThroughEachOtherAreDividedWhereTheyCross();
    void whatIsPiercedBesideACommonCornerIsAlone();
    void noRegionGoesAcrossATurnedOrABranchedEdge();
};

void tst_ClothParts::aMoebiusBandKeepsATurnedEdge() {
    std::vector<geometry::TriangleIndices> band; // eight cells; the last is sewn to the first with its ends swapped
    const auto corner = [](int i, int side) { return i < 8 ? 2 * i + side : 1 - side; };
    for (int i = 0; i < 8; ++i) {
        band.push_back({corner(i, 0), corner(i + 1, 0), corner(i, 1)});
        band.push_back({corner(i + 1, 0), corner(i + 1, 1), corner(i, 1)});
    }
    const auto parts = partsOf(band);
    QCOMPARE(parts.size(), std::size_t(1));
    ClothPart alike = parts.front();
    const std::vector<bool> turned = turnedAgainstFirst(alike);
    for (std::size_t t = 0; t < alike.size(); ++t)
        if (turned[t]) std::swap(alike[t][1], alike[t][2]);
    const auto runs = [&](int from, int to) {
        return std::ranges::count_if(alike, [&](const auto& t) {
            return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
        });
    };
    int turnedEdges = 0;
    for (int a = 0; a < 16; ++a)
        for (int b = 0; b < 16; ++b) turnedEdges += runs(a, b) > 1;
    QCOMPARE(turnedEdges, 1);
}

void tst_ClothParts::whatNothingPassesThroughIsOneRegion() {
    const TriangleMesh inner = shapes::bumpySphere(12, 20);
    TriangleMesh outer = inner;
    for (Vec3& p : outer.vertices) p *= 3;
    const auto regions = unpiercedRegions(together(inner, outer));
    QCOMPARE(regions.size(), std::size_t(2));
    for (const auto& region : regions) QCOMPARE(region.size(), inner.triangles.size());
}

void tst_ClothParts::surfacesThroughEachOtherAreDividedWhereTheyCross() {
    TriangleMesh moved = shapes::bumpySphere(24, 40);
    const TriangleMesh mesh = [&] {
        const TriangleMesh still = moved;
        for (Vec3& p : moved.vertices) p += Vec3{0.613, 0.271, 0.107};
        return together(still, moved);
    }();
    std::set<int> crossing;
    for (const auto& [a, b] : collision::selfIntersectingTriangles(mesh)) crossing.insert({a, b});
    QVERIFY(!crossing.empty());
    int alone = 0, whole = 0;
    std::vector<int> seen(mesh.triangles.size(), 0);
    for (const auto& region : unpiercedRegions(mesh)) {
        alone += region.size() == 1;
        whole += region.size() > 1;
        for (const int t : region) ++seen[t];
        if (region.size() == 1) continue;
        for (const int t : region) {
            QVERIFY(!crossing.contains(t));
            QCOMPARE(windingBefore(mesh, t), windingBefore(mesh, region.front()));
        }
    }
    QVERIFY(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    QVERIFY(whole >= 4); // of each sphere what is in the other, and what is not
    QVERIFY(alone >= static_cast<int>(crossing.size()));
}

void tst_ClothParts::whatIsPiercedBesideACommonCornerIsAlone() {
    // The second triangle begins in a corner of the first and passes through it: that is no pair of
    // selfIntersecting…().
    TriangleMesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1.5, 1.5, -1}, {4, 4, 0}}, {{0, 1, 2}, {1, 5, 2}}};
    QCOMPARE(unpiercedRegions(mesh).size(), std::size_t(1));
    mesh.triangles.push_back({0, 3, 4});
    QVERIFY(collision::selfIntersectingTriangles(mesh).empty());
    QCOMPARE(unpiercedRegions(mesh).size(), std::size_t(3));
}

void tst_ClothParts::noRegionGoesAcrossATurnedOrABranchedEdge() {
    const TriangleMesh alike{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}}, {{0, 1, 2}, {1, 3, 2}}};
    TriangleMesh turned = alike, branched = alike;
    std::swap(turned.triangles[1][1], turned.triangles[1][2]);
    branched.triangles.push_back({1, 4, 2});
    QCOMPARE(sizesOf(unpiercedRegions(alike)), std::set<std::size_t>{2});
    QCOMPARE(sizesOf(unpiercedRegions(turned)), std::set<std::size_t>{1});
    QCOMPARE(sizesOf(unpiercedRegions(branched)), std::set<std::size_t>{1});
}

TOILE_TEST(tst_ClothParts)
#include "tst_ClothParts.moc"
