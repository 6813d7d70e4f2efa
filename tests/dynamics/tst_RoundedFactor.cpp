// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/RoundedFactor.h"
#include "tests/Suite.h"

#include "core/dynamics/BlockCholesky.h"
#include "core/dynamics/BlockVectors.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace toile;
using namespace toile::dynamics;

namespace {

constexpr int latticeSide = 90; ///< large enough for subtrees and parts of a product to be shared out

/// Springs in three directions between neighbours of a square lattice, on a soft ground.
void give(BlockMatrix& matrix, double ground) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    const auto join = [&](int a, int b) {
        const Vec3 n{normal(random), normal(random), normal(random)};
        double block[9], opposite[9];
        for (int k = 0; k < 9; ++k) {
            block[k] = n[k / 3] * n[k % 3] + (k % 4 == 0 ? 0.1 : 0);
            opposite[k] = -block[k];
        }
        matrix.add(a, a, block);
        matrix.add(b, b, block);
        matrix.add(std::max(a, b), std::min(a, b), opposite);
    };
    for (int row = 0; row < latticeSide; ++row)
        for (int column = 0; column < latticeSide; ++column) {
            const int at = row * latticeSide + column;
            if (column + 1 < latticeSide) join(at, at + 1);
            if (row + 1 < latticeSide) join(at, at + latticeSide);
            if (row + 1 < latticeSide && column + 1 < latticeSide) join(at, at + latticeSide + 1);
            const double own[9] = {ground, 0, 0, 0, ground, 0, 0, 0, ground};
            matrix.add(at, at, own);
        }
    matrix.settlePattern();
}

std::vector<Vec3> vectors(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Vec3> some(latticeSide * latticeSide);
    for (Vec3& v : some) v = {normal(random), normal(random), normal(random)};
    return some;
}

struct Lattice {
    explicit Lattice(double ground) : matrix(latticeSide * latticeSide) {
        give(matrix, ground);
        if (!matrix.factorize(std::vector<double>(latticeSide * latticeSide, 0.0)))
            qFatal("a lattice on a ground is definite");
        factor.take(matrix.factor());
    }
    BlockCholesky matrix;
    RoundedFactor factor;
};

double distanceOf(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += squaredLength(a[i] - b[i]);
    return std::sqrt(sum / dotOf(b, b));
}

} // namespace

class tst_RoundedFactor : public QObject {
    Q_OBJECT

private slots:
    /// Rounding each number by 6e-8 moves a solution by no more than the condition, 1e2, times as much.
    void solvesAsTheFactorItRounds() {
        Lattice lattice(0.1);
        const auto b = vectors(1);
        QVERIFY(distanceOf(lattice.factor.solve(b), *lattice.matrix.solve(b)) < 1e-5);
    }

    /// Also where rounding reaches the softest directions: a preconditioner has to be, and is, whatever was rounded.
    void isSymmetricAndDefinite() {
        Lattice lattice(1e-9);
        const auto a = vectors(2), b = vectors(3);
        const auto toA = lattice.factor.solve(a), toB = lattice.factor.solve(b);
        const double ab = dotOf(b, toA), aa = dotOf(a, toA), bb = dotOf(b, toB);
        QVERIFY(std::abs(ab - dotOf(a, toB)) < 1e-10 * std::sqrt(aa * bb));
        QVERIFY(aa > 0 && bb > 0);
    }

    void theBitsAreTheSameForAnyTeamAndProcessor() {
        Lattice lattice(0.1);
        const auto b = vectors(4), alone = lattice.factor.solve(b);
        Team two(2), three(3);
        QCOMPARE(lattice.factor.solve(b, &two), alone);
        QCOMPARE(lattice.factor.solve(b, &three), alone);
        RoundedFactor plain(plainFactorKernels());
        plain.take(lattice.matrix.factor());
        QCOMPARE(plain.solve(b), alone);
    }

    void aProductIsTheSameForAnyTeamAndUndoesASolution() {
        Lattice lattice(0.1);
        const auto b = vectors(5), x = *lattice.matrix.solve(b);
        const std::vector<double> unshifted(b.size(), 0.0);
        std::vector<Vec3> alone(b.size()), shared(b.size());
        lattice.matrix.multiply(unshifted, x, alone);
        QVERIFY(distanceOf(alone, b) < 1e-12);
        Team two(2), three(3);
        lattice.matrix.multiply(unshifted, x, shared, &two);
        QCOMPARE(shared, alone);
        lattice.matrix.multiply(unshifted, x, shared, &three);
        QCOMPARE(shared, alone);
    }

    /// A small matrix has no subtrees to share; columns need not come in threes.
    void aMatrixOfOneBlockIsDivision() {
        BlockCholesky matrix(1);
        const double four[9] = {4, 0, 0, 0, 4, 0, 0, 0, 4};
        matrix.add(0, 0, four);
        QVERIFY(matrix.factorize(std::vector<double>{0.0}));
        RoundedFactor factor;
        factor.take(matrix.factor());
        QCOMPARE(factor.solve(std::vector<Vec3>{{8, -4, 2}}), (std::vector<Vec3>{{2, -1, 0.5}}));
    }
};

TOILE_TEST(tst_RoundedFactor)
#include "tst_RoundedFactor.moc"
