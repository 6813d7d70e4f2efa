// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/TrustedStep.h"
#include "tests/Suite.h"

#include "core/dynamics/BlockCholesky.h"

#include <Eigen/Dense>
#include <QTest>
#include <random>

using namespace toile;
using namespace toile::dynamics;

namespace {

constexpr int blocks = 12;
/// What a factor in single precision does to √(sᵀPs), relative: 6e-8 a number, of a matrix no worse than 1e2.
constexpr double single = 1e-5;

/// A + diag(shift·I) as a preconditioner.
RoundedFactor factorOf(BlockCholesky& matrix, double shift) {
    if (!matrix.factorize(std::vector<double>(blocks, shift))) qFatal("a matrix to precondition with is definite");
    RoundedFactor factor;
    factor.take(matrix.factor());
    return factor;
}

/// Two matrices on a ring of blocks: H, which may curve down, and P, which does not.
struct Quadratic {
    explicit Quadratic(unsigned seed, double softest) : hessian(blocks), preconditioner(blocks) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        h = p = Eigen::MatrixXd::Zero(3 * blocks, 3 * blocks);
        for (int b = 0; b < blocks; ++b) {
            const int ends[2] = {b, (b + 1) % blocks};
            Eigen::Matrix<double, 6, 6> part;
            for (double& value : part.reshaped()) value = normal(random);
            const Eigen::Matrix<double, 6, 6> up = part * part.transpose();
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    h.block<3, 3>(3 * ends[i], 3 * ends[j]) += up.block<3, 3>(3 * i, 3 * j);
                    p.block<3, 3>(3 * ends[i], 3 * ends[j]) += up.block<3, 3>(3 * i, 3 * j);
                }
        }
        for (int b = 0; b < blocks; b += 4) h.block<3, 3>(3 * b, 3 * b).diagonal().array() += softest;
        p.diagonal().array() += 0.5;
        give(h, hessian);
        give(p, preconditioner);
        for (int b = 0; b < blocks; ++b) forces.push_back({normal(random), normal(random), normal(random)});
    }

    static void give(const Eigen::MatrixXd& from, BlockMatrix& to) {
        for (int i = 0; i < blocks; ++i)
            for (int j = 0; j < blocks; ++j) {
                if (const int apart = (i - j + blocks) % blocks; apart > 1 && apart < blocks - 1) continue;
                double block[9];
                for (int k = 0; k < 9; ++k) block[k] = from(3 * i + k / 3, 3 * j + k % 3);
                to.add(i, j, block);
            }
        to.settlePattern();
    }

    [[nodiscard]] Eigen::VectorXd f() const { return Eigen::Map<const Eigen::VectorXd>(&forces[0].x, 3 * blocks); }
    [[nodiscard]] double fall(const Eigen::VectorXd& s) const { return f().dot(s) - 0.5 * s.dot(h * s); }
    /// The most the model falls within the radius: the multiplier that puts the step on its border is found by halving.
    [[nodiscard]] double bestFall(double radius) const {
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(h, p);
        const Eigen::VectorXd& lambda = spectrum.eigenvalues();
        const Eigen::VectorXd g = spectrum.eigenvectors().transpose() * f();
        const auto at = [&](double multiplier) { return Eigen::VectorXd(g.array() / (lambda.array() + multiplier)); };
        double low = std::max(0.0, -lambda[0]) + 1e-12, high = low + g.norm() / radius + 1;
        if (lambda[0] <= 0 || at(0).norm() > radius)
            for (int halving = 0; halving < 200; ++halving)
                (at((low + high) / 2).norm() > radius ? low : high) = (low + high) / 2;
        else high = 0;
        return fall(spectrum.eigenvectors() * at(high));
    }

    BlockMatrix hessian;
    BlockCholesky preconditioner;
    Eigen::MatrixXd h, p;
    std::vector<Vec3> forces;
};

Eigen::VectorXd vectorOf(const TrustedStep& step) {
    return Eigen::Map<const Eigen::VectorXd>(&step.move[0].x, 3 * blocks);
}

} // namespace

class tst_TrustedStep : public QObject {
    Q_OBJECT

private slots:
    void keepsItsRadiusAndItsWord_data() {
        QTest::addColumn<double>("softest");
        QTest::addColumn<double>("radius");
        QTest::newRow("valley, far") << 1.0 << 100.0;
        QTest::newRow("valley, near") << 1.0 << 0.3;
        QTest::newRow("saddle, far") << -4.0 << 20.0;
        QTest::newRow("saddle, near") << -4.0 << 0.3;
    }
    void keepsItsRadiusAndItsWord() {
        QFETCH(double, softest);
        QFETCH(double, radius);
        for (unsigned seed = 1; seed <= 20; ++seed) {
            Quadratic model(seed, softest);
            RoundedFactor factor = factorOf(model.preconditioner, 0.5);
            model.p.diagonal().array() += 0.5; // the shift of the factor
            const TrustedStep step = trustedStep(model.hessian, factor, model.forces, radius, {.forcing = 1e-9});
            const Eigen::VectorXd s = vectorOf(step);
            const double norm = std::sqrt(s.dot(model.p * s));
            QVERIFY2(std::abs(norm - step.norm) < single * step.norm, qPrintable(QString::number(norm)));
            QVERIFY(norm <= radius * (1 + single));
            QVERIFY(std::abs(model.fall(s) - step.expected) < 1e-8 * step.expected);
            // At least half of what is to be had where H is definite (Yuan 2000); at a saddle no worse than along P⁻¹f.
            const double best = model.bestFall(radius);
            QVERIFY(step.expected <= best * (1 + single));
            if (softest > 0) QVERIFY2(step.expected >= 0.5 * best, qPrintable(QString("seed %1").arg(seed)));
            const Eigen::VectorXd first = model.p.ldlt().solve(model.f());
            const double length = std::sqrt(first.dot(model.p * first));
            const double curvature = first.dot(model.h * first);
            double along = radius / length;
            if (curvature > 0) along = std::min(along, first.dot(model.f()) / curvature);
            QVERIFY(step.expected >= model.fall(along * first) * (1 - single));
            QVERIFY(!step.downwards || (softest < 0 && step.bounded));
        }
    }

    void isNewtonsStepWhereTrustIsWide() {
        Quadratic model(7, 1);
        RoundedFactor factor = factorOf(model.preconditioner, 0);
        const TrustedStep step = trustedStep(model.hessian, factor, model.forces, 1e6, {.forcing = 1e-10});
        const Eigen::VectorXd newton = model.h.ldlt().solve(model.f());
        QVERIFY((vectorOf(step) - newton).norm() < 1e-8 * newton.norm());
        QVERIFY(!step.bounded && !step.downwards);
    }

    void takesOneGradientWhereTheFactorIsOfTheHessian() {
        Quadratic model(3, 1);
        BlockCholesky own(blocks);
        Quadratic::give(model.h, own);
        RoundedFactor factor = factorOf(own, 0);
        QCOMPARE(trustedStep(model.hessian, factor, model.forces, 1e6, {.forcing = single}).iterations, 1);
    }
};

TOILE_TEST(tst_TrustedStep)
#include "tst_TrustedStep.moc"
