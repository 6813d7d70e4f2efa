// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Curvature.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>
#include <functional>
#include <numbers>

using namespace toile;
using namespace toile::fixtures;

namespace {

constexpr double spacing = 0.01; // [m]
constexpr int cells = 20;

/// Of a sheet whose height over the plane is a function of the material point; along weft, then along warp.
std::vector<cloth::Curvature> curvaturesOf(const std::function<double(Vec2)>& height, double side = spacing) {
    const Patch patch = gridPatch(evenLines(cells * side, cells), evenLines(cells * side, cells));
    std::vector<Vec3> positions;
    for (const Vec2 p : patch.material) positions.push_back({p.x, p.y, height(p)});
    return cloth::curvatures(patch, positions);
}

constexpr int counted = (cells - 1) * (cells - 3); // inner nodes whose neighbours on the line are inner nodes

} // namespace

class tst_Curvature : public QObject {
    Q_OBJECT
private slots:
    void ofAValleyItIsOneOverItsRadius() {
        const auto all = curvaturesOf([](Vec2 p) { return 0.5 * p.x * p.x; }); // radius 1 m at x = 0, 1.06 m at its end
        QCOMPARE(int(all.size()), 2 * counted);
        for (int k = 0; k < counted; ++k) {
            QVERIFY(all[k].value > 0.96 && all[k].value <= 1.0); // the height's second derivative is 1, its slope ≤ 0.2
            QVERIFY(std::abs(all[k].alternating) < 1e-3);
            QVERIFY(std::abs(all[k].area - spacing * spacing) < 1e-15);
        }
        for (int k = counted; k < 2 * counted; ++k) QVERIFY(std::abs(all[k].value) < 1e-12);
    }

    void aZigzagAlternates() {
        const double a = 1e-5;
        const auto all = curvaturesOf([&](Vec2 p) { return std::lround(p.y / spacing) % 2 == 0 ? a : -a; });
        for (int k = counted; k < 2 * counted; ++k) {
            QVERIFY(std::abs(std::abs(all[k].value) - 4 * a / (spacing * spacing)) < 1e-9);
            QVERIFY(std::abs(all[k].alternating - all[k].value) < 1e-9);
        }
    }

    void aFoldThatTheMeshResolvesHardlyAlternates() {
        const double wave = 8 * spacing;
        double squares = 0, alternating = 0;
        for (const auto& c : curvaturesOf(
                 [&](Vec2 p) { return 1e-5 * std::sin(2 * std::numbers::pi * (p.x + 0.3 * spacing) / wave); })) {
            squares += c.value * c.value;
            alternating += c.alternating * c.alternating;
        }
        const double part = (1 - std::cos(2 * std::numbers::pi / 8)) / 2; // 0.15
        QVERIFY(std::abs(std::sqrt(alternating / squares) - part) < 1e-6);
    }

    void rowsOfAnyHeightWillDo() {
        const Patch patch = gridPatch(evenLines(0.06, 6), {0, 0.01, 0.025, 0.033, 0.05, 0.07, 0.08});
        std::vector<Vec3> positions;
        for (const Vec2 p : patch.material) positions.push_back({p.x, p.y, 0.5e-3 * p.y * p.y});
        const auto all = cloth::curvatures(patch, positions);
        for (std::size_t k = all.size() / 2; k < all.size(); ++k) QVERIFY(std::abs(all[k].value - 1e-3) < 1e-9);
    }
};

TOILE_TEST(tst_Curvature)
#include "tst_Curvature.moc"
