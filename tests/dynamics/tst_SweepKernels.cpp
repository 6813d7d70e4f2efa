// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SweepKernels.h"

#include <QTest>
#include <random>

using namespace toile;
using dynamics::Linear;
using dynamics::Place;
using dynamics::SweepKernels;

namespace {

constexpr int count = 24; ///< places

struct Random {
    std::mt19937 engine{7};
    double number() { return std::uniform_real_distribution(-1.0, 1.0)(engine); }
    std::vector<Place> places() {
        std::vector<Place> places(count);
        for (Place& place : places) static_cast<Vec3&>(place) = {number(), number(), number()};
        return places;
    }
    std::array<double, 4> numbers() { return {number(), number(), number(), number()}; }
};

std::vector<dynamics::FourSprings> springs(Random& random) {
    std::vector<dynamics::FourSprings> fours;
    for (int i = 0; i < 200; ++i) {
        const int shift = i % count;
        auto& four = fours.emplace_back();
        four.restLength = random.numbers();
        four.correctionA = random.numbers();
        four.correctionB = random.numbers();
        for (int lane = 0; lane < 4; ++lane) {
            four.a[lane] = (shift + 2 * lane) % count;
            four.b[lane] = (shift + 2 * lane + 1 + 8 * (i % 2)) % count;
        }
    }
    return fours;
}

template <int N>
std::vector<Linear<N>> stencils(Random& random) {
    std::vector<Linear<N>> stencils(200);
    for (int i = 0; i < 200; ++i)
        for (int k = 0; k < N; ++k) {
            stencils[i].particles[k] = (i + 5 * k) % count;
            stencils[i].coefficients[k] = random.number();
            stencils[i].corrections[k] = 0.1 * random.number();
        }
    return stencils;
}

} // namespace

class tst_SweepKernels : public QObject {
    Q_OBJECT

private slots:
    void everyProcessorGivesTheSameBits() {
        const SweepKernels *plain = &dynamics::plainKernels(), *fast = dynamics::avx2Kernels();
        if (!fast) return; // there is one kind here
        Random random;
        const auto someSprings = springs(random);
        const auto three = stencils<3>(random);
        const auto four = stencils<4>(random);
        const auto start = random.places();
        std::array<std::vector<Place>, 2> ends{start, start};
        for (int i = 0; i < 2; ++i) {
            const SweepKernels& kernels = i == 0 ? *plain : *fast;
            kernels.springs(ends[i].data(), someSprings);
            kernels.threePoint(ends[i].data(), three);
            kernels.fourPoint(ends[i].data(), four);
        }
        QVERIFY(ends[0] != start);
        for (int p = 0; p < count; ++p) QCOMPARE(ends[0][p], ends[1][p]);
    }

    void aSpringMovesItsEndsAsTheFormulaSays() {
        std::vector<Place> places(8);
        for (int p = 0; p < 8; ++p) static_cast<Vec3&>(places[p]) = {1.0 * p, 0.1 * p, 0.3 * p * p};
        const std::vector<Place> start = places;
        dynamics::FourSprings four{.restLength = {0.5, 1, 2, 3},
                                   .correctionA = {0.5, 0.25, 0, 0.125},
                                   .correctionB = {0.25, 0.5, 0.75, 0},
                                   .a = {0, 1, 2, 3},
                                   .b = {4, 5, 6, 7}};
        dynamics::fastestKernels().springs(places.data(), std::span(&four, 1));
        for (int i = 0; i < 4; ++i) {
            const Vec3 d = start[i + 4] - start[i];
            const Vec3 change = d * (1 - four.restLength[i] / length(d));
            QVERIFY(distance(places[i], start[i] + change * four.correctionA[i]) < 1e-15);
            QVERIFY(distance(places[i + 4], start[i + 4] - change * four.correctionB[i]) < 1e-15);
        }
    }

    void aSpringWithoutLengthPartsItsEnds() {
        std::vector<Place> places(8);
        for (int p = 0; p < 8; ++p) static_cast<Vec3&>(places[p]) = {1.0 * (p / 2), 0, 0};
        dynamics::FourSprings four{.restLength = {0.5, 0.5, 0.5, 0.5},
                                   .correctionA = {0.5, 0.5, 0.5, 0.5},
                                   .correctionB = {0.5, 0.5, 0.5, 0.5},
                                   .a = {0, 2, 4, 6},
                                   .b = {1, 3, 5, 7}};
        dynamics::fastestKernels().springs(places.data(), std::span(&four, 1));
        for (int p = 0; p < 8; p += 2) QVERIFY(std::abs(distance(places[p], places[p + 1]) - 0.5) < 1e-11);
    }
};

QTEST_APPLESS_MAIN(tst_SweepKernels)
#include "tst_SweepKernels.moc"
