// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FactorKernels.h"
#include "core/dynamics/XpbdSweep.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>

using namespace toile;
using namespace toile::fixtures;
using dynamics::Eliminated;
using dynamics::SweepKernels;
using dynamics::XpbdSweep;

namespace {

constexpr double substep = 1.0 / 2400; ///< [s]

struct ShakenCloth {
    ClothModel model;
    std::vector<Vec3> positions;
};

ShakenCloth shaken(const QString& kind) {
    const auto lines = evenLines(0.1, 6);
    const Patch patch = kind.endsWith("triangles") ? trianglePatch(lines, lines) : gridPatch(lines, lines);
    ShakenCloth cloth;
    if (!cloth::appendPatch(cloth.model, patch, kind.startsWith("knit") ? knitFabric() : wovenFabric()))
        qFatal("a patch is a cloth");
    if (kind == "hinges")
        for (int a = 7; a < 35; ++a)
            if (a % 7 < 6) cloth.model.hinges.push_back({a, a + 1, a + 7, a - 7, 0.3, 1e-4});
    cloth.model.pinned = {0, 6};
    for (const Vec2& m : patch.material) cloth.positions.push_back({m.x, 0, m.y});
    shake(cloth.positions, 0.004);
    return cloth;
}

std::vector<Vec3> swept(const ClothModel& model, std::vector<Vec3> positions, const SweepKernels& kernels) {
    const Eliminated eliminated(model);
    const std::vector<double> inverseMass = eliminated.inverseMass();
    XpbdSweep sweep(model, eliminated, inverseMass, substep, 1, kernels);
    sweep.apply(positions);
    return positions;
}

/// The same element with its first corner on a slave, which lies on a new particle as heavy as the corner was and in
/// its place: the element takes the way of those that touch joints, and must move its corners by the same.
template <class Element, class Corner>
void isMovedAsBesideAJoint(const ShakenCloth& cloth, std::vector<Element> ClothModel::*elements, Corner firstCorner,
                           double tolerance) {
    QVERIFY(!(cloth.model.*elements).empty());
    for (Element element : cloth.model.*elements) {
        ClothModel alone{.mass = cloth.model.mass, .tensionCurves = cloth.model.tensionCurves};
        ClothModel joined = alone;
        (alone.*elements).push_back(element);
        const int corner = firstCorner(element), slave = alone.particleCount();
        joined.mass.push_back(0);
        joined.slaves.push_back({slave, {{corner, 1.0}}});
        firstCorner(element) = slave;
        (joined.*elements).push_back(element);
        std::vector<Vec3> start = cloth.positions;
        const auto free = swept(alone, start, dynamics::fastestKernels());
        start.push_back(start[corner]);
        const auto beside = swept(joined, start, dynamics::fastestKernels());
        double farthest = 0;
        for (std::size_t p = 0; p < free.size(); ++p) farthest = std::max(farthest, distance(free[p], start[p]));
        QVERIFY(farthest > 0);
        for (std::size_t p = 0; p < free.size(); ++p) QVERIFY(distance(free[p], beside[p]) <= tolerance);
    }
}

} // namespace

class tst_SweepKernels : public QObject {
    Q_OBJECT

private slots:
    void processorsHaveLoopsOfTheirOwn() { // else that they agree would say nothing
        const SweepKernels* fast = dynamics::avx2Kernels();
        if (!fast) return; // there is one kind here
        QVERIFY(fast->springs != dynamics::plainKernels().springs);
        QVERIFY(fast->level != dynamics::plainKernels().level);
        QVERIFY(dynamics::avx2FactorKernels()->forward != dynamics::plainFactorKernels().forward);
    }
    void everyProcessorGivesTheSameBits_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"springs", "triangles", "knit triangles", "knit cells", "hinges"})
            QTest::newRow(kind) << kind;
    }
    void everyProcessorGivesTheSameBits() {
        QFETCH(QString, kind);
        const SweepKernels* fast = dynamics::avx2Kernels();
        if (!fast) return; // there is one kind here
        const ShakenCloth cloth = shaken(kind);
        const auto plain = swept(cloth.model, cloth.positions, dynamics::plainKernels());
        QVERIFY(plain != cloth.positions);
        QCOMPARE(swept(cloth.model, cloth.positions, *fast), plain);
    }

    /// Of coarse levels: folded ones and ones that nothing is missing from among them.
    void everyProcessorPullsCoarseTrianglesAlike() {
        const SweepKernels* fast = dynamics::avx2Kernels();
        if (!fast) return; // there is one kind here
        std::vector<dynamics::Place> start(12);
        std::vector<Vec3> corners(start.size());
        shake(corners, 1);
        for (std::size_t p = 0; p < start.size(); ++p) {
            static_cast<Vec3&>(start[p]) = corners[p];
            start[p].inverseMass = 1 + static_cast<double>(p % 3);
        }
        dynamics::FourLevelTriangles four{.factors = {{{0.1, 0.2, 0.3, 0}, {0.2, 0.2, 0, 0.1}, {0.1, 0, 0.1, 0.1}}},
                                          .weft = {0.5, 0.3, 0.1, 0.2},
                                          .warp = {0.4, 0.2, 0.2, 0.1},
                                          .shear = {0.1, 0.1, -0.1, 0.2},
                                          .flatness = {1, 0, 0.5, 1}};
        for (int lane = 0; lane < 4; ++lane)
            for (int corner = 0; corner < 3; ++corner) {
                four.particles[corner][lane] = 3 * lane + corner;
                four.u[corner][lane] = std::array{-1.0, 1.0, 0.0}[corner];
                four.v[corner][lane] = std::array{-1.0, 0.0, 1.0}[corner];
            }
        std::vector<dynamics::Place> plain = start, quick = start;
        dynamics::plainKernels().level(plain.data(), std::span(&four, 1));
        fast->level(quick.data(), std::span(&four, 1));
        QVERIFY(plain == quick);
        QVERIFY(plain[0] != start[0]);
        for (int corner = 3; corner < 6; ++corner) QVERIFY(plain[corner] == start[corner]); // folded: left alone
    }

    /// The share of springs and stencils is rounded to 6e-8 of itself, and with it a move of some millimetres.
    void elementsMoveAsBesideAJoint() {
        constexpr double single = 5e-10, full = 1e-13; // [m]
        const ShakenCloth woven = shaken("springs"), triangles = shaken("triangles"), knit = shaken("knit cells");
        const auto a = [](auto& element) -> int& { return element.a; };
        const auto first = [](auto& element) -> int& { return element.particles[0]; };
        isMovedAsBesideAJoint(woven, &ClothModel::structural, a, single);
        isMovedAsBesideAJoint(woven, &ClothModel::bending, first, single);
        isMovedAsBesideAJoint(triangles, &ClothModel::bending, first, single);
        isMovedAsBesideAJoint(triangles, &ClothModel::triangles, first, full);
        isMovedAsBesideAJoint(shaken("knit triangles"), &ClothModel::triangles, first, full);
        isMovedAsBesideAJoint(knit, &ClothModel::cells, first, full);
        isMovedAsBesideAJoint(shaken("hinges"), &ClothModel::hinges, a, full);
    }

    void momentumStays() {
        for (const char* kind : {"springs", "triangles", "knit triangles", "knit cells", "hinges"}) {
            ShakenCloth cloth = shaken(kind);
            cloth.model.pinned.clear();
            const auto after = swept(cloth.model, cloth.positions, dynamics::fastestKernels());
            Vec3 sum;
            double size = 0;
            for (std::size_t p = 0; p < after.size(); ++p) {
                sum += cloth.model.mass[p] * (after[p] - cloth.positions[p]);
                size += cloth.model.mass[p] * distance(after[p], cloth.positions[p]);
            }
            QVERIFY(length(sum) < 1e-13 * size); // sums of some 1000 roundings
        }
    }

    void aSpringWithoutLengthPartsItsEnds() {
        const ClothModel model{.mass = {0.001, 0.001}, .structural = {{0, 1, 0.5, 1e9}}};
        const auto ends = swept(model, {{1, 2, 3}, {1, 2, 3}}, dynamics::fastestKernels());
        QVERIFY(std::abs(distance(ends[0], ends[1]) - 0.25) < 1e-6); // half of it: the cap
    }

    void anElementWithoutAreaIsLeftAlone() {
        ClothModel model{.mass = {0.001, 0.001, 0.001, 0.001}, .hinges = {{0, 1, 2, 3, 0.3, 1e-4}}};
        const std::vector<Vec3> start{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
        QCOMPARE(swept(model, start, dynamics::fastestKernels()), start);
    }
};

TOILE_TEST(tst_SweepKernels)
#include "tst_SweepKernels.moc"
