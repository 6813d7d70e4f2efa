// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Statics.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <functional>

/// Loops of a strip whose ends are clamped together: Peirce's tests. docs/study.md
namespace toile::study::validation {
namespace {

constexpr double pi = std::numbers::pi;

/// Half a loop, from the clamp at the origin to its lowest point: there it runs level and inward. A pear leaves the
/// clamp downwards, a heart upwards.
struct Loop {
    const char* name;
    double start; ///< direction at the clamp, from level outwards [rad]
    double gamma; ///< ρ g L³ / B of the whole loop
};

/// The elastica of half a loop of length 1 [–], for a level pull and a curvature at the clamp.
struct Elastica {
    double x = 0, y = 0, direction = 0, curvature = 0;
};

Elastica elasticaOf(const Loop& loop, double pull, double curvature, double upTo = 1) {
    constexpr int steps = 2000;
    const double weight = loop.gamma / 8; // ρ g ℓ³ / B of the half
    const auto slopes = [&](double s, const Elastica& e) {
        const double below = -weight * (1 - s); // what hangs below s pulls down
        return Elastica{std::cos(e.direction), std::sin(e.direction), e.curvature,
                        pull * std::sin(e.direction) - below * std::cos(e.direction)};
    };
    const auto moved = [](const Elastica& e, const Elastica& k, double h) {
        return Elastica{e.x + h * k.x, e.y + h * k.y, e.direction + h * k.direction, e.curvature + h * k.curvature};
    };
    Elastica e{0, 0, loop.start, curvature};
    constexpr double h = 1.0 / steps;
    for (int i = 0; i < upTo * steps; ++i) { // RK4
        const double s = i * h;
        const Elastica a = slopes(s, e), b = slopes(s + h / 2, moved(e, a, h / 2)),
                       c = slopes(s + h / 2, moved(e, b, h / 2)), d = slopes(s + h, moved(e, c, h));
        e = moved(moved(e, a, h / 6), moved(moved({}, b, 2), c, 2), h / 6);
        e = moved(e, d, h / 6);
    }
    return e;
}

/// Newton's method on where the half loop ends: at its lowest point, level. What is left of the miss.
double shoot(const Loop& loop, Eigen::Vector2d& unknown) {
    const auto missOf = [&](const Eigen::Vector2d& u) {
        const Elastica e = elasticaOf(loop, u[0], u[1]);
        return Eigen::Vector2d{e.x, e.direction + pi};
    };
    Eigen::Vector2d miss = missOf(unknown);
    for (int i = 0; i < 50 && miss.norm() > 1e-12; ++i) {
        Eigen::Matrix2d slope;
        for (int k : {0, 1}) {
            Eigen::Vector2d beside = unknown;
            beside[k] += 1e-6;
            slope.col(k) = (missOf(beside) - miss) / 1e-6;
        }
        const Eigen::Vector2d step = slope.fullPivLu().solve(miss), before = unknown;
        double fraction = 1;
        do {
            unknown = before - fraction * step;
            fraction /= 2;
        } while (missOf(unknown).norm() > miss.norm() && fraction > 1e-6);
        miss = missOf(unknown);
    }
    return miss.norm();
}

/// A loop that hangs and bulges, and not another equilibrium of the same ends.
bool isSimple(const Loop& loop, const Eigen::Vector2d& unknown) {
    const double height = -elasticaOf(loop, unknown[0], unknown[1]).y / 2;
    const Elastica half = elasticaOf(loop, unknown[0], unknown[1], 0.5);
    return height > 0.05 && height < 0.5 && half.x > 0 && half.direction > -pi;
}

/// Height of the loop over its length: found without weight from one of several guesses, then the weight grows.
double heightByElastica(Findings& found, Loop loop) {
    const double full = loop.gamma;
    loop.gamma = 0;
    Eigen::Vector2d unknown;
    const auto finds = [&] {
        for (const double pull : {3.0, 12.0, 0.0, -6.0, 24.0})
            for (const double curvature : {1.0, 3.0, 6.0, -1.0, -3.0, -6.0}) {
                unknown = {pull, curvature};
                if (shoot(loop, unknown) < 1e-10 && isSimple(loop, unknown)) return true;
            }
        return false;
    };
    bool good = finds();
    for (int part = 1; part <= 40 && good; ++part) {
        loop.gamma = full * part / 40;
        good = shoot(loop, unknown) < 1e-8 && isSimple(loop, unknown);
    }
    if (!good) found.stop("The elastica was not found.");
    return -elasticaOf(loop, unknown[0], unknown[1]).y / 2;
}

/// Directions along half a loop that closes: a guess to begin with.
std::function<double(double)> guessOf(const Loop& loop) {
    const auto direction = [start = loop.start](double s, double bulge) {
        return start + bulge * std::sin(pi * s) - (start + pi) * s;
    };
    const bool isHeart = loop.start > 0;
    double low = isHeart ? -3 : 0, high = isHeart ? 0 : 3; // a wider bulge ends farther out
    for (int i = 0; i < 50; ++i) {
        const double bulge = 0.5 * (low + high);
        double x = 0;
        for (int k = 0; k < 400; ++k) x += std::cos(direction((k + 0.5) / 400, bulge)) / 400;
        (x < 0 ? low : high) = bulge;
    }
    return [direction, low](double s) { return direction(s, low); };
}

/// The same of a strip of cells, 0.2 m long, clamped over two columns of nodes at either end.
double heightOfStrip(Findings& found, const Loop& loop, int cells) {
    constexpr double all = 0.2;
    Fabric fabric = unequalWeave();
    fabric.warpStiffness = fabric.weftStiffness = 2e4; // nearly inextensible
    fabric.shearStiffness = 1000;
    const double bending = fabric.arealDensity * standardGravity * all * all * all / loop.gamma;
    fabric.warpBending = fabric.weftBending = bending;
    fabric.biasBending = bending / 2; // no twist
    const double h = all / cells;
    std::vector<double> columns;
    for (int i = -1; i <= cells + 1; ++i) columns.push_back(i * h);
    const Patch patch = gridPatch(columns, evenLines(h, 1));
    ClothModel model = modelOf(patch, fabric);

    const auto direction = guessOf(loop);
    std::vector<Vec2> half{{0, 0}};
    for (int i = 0; i < cells / 2; ++i) {
        const double along = direction((i + 0.5) * 2 / cells);
        half.push_back(half.back() + Vec2{h * std::cos(along), h * std::sin(along)});
    }
    const Vec2 beforeClamp{-h * std::cos(loop.start), -h * std::sin(loop.start)};
    ParticleState state;
    for (const Vec2& m : patch.material) {
        const int i = static_cast<int>(std::lround(m.x / h));
        const bool isLeft = i <= cells / 2;
        const int k = isLeft ? i : cells - i;
        const Vec2 at = k < 0 ? beforeClamp : half[k];
        state.positions.push_back({isLeft ? at.x : -at.x, at.y, m.y});
    }
    for (int p = 0; p < model.particleCount(); ++p)
        if (patch.material[p].x < h / 2 || patch.material[p].x > all - h / 2) model.pinned.push_back(p);
    cloth::doubleBendingAtClampedRows(model);
    const auto rest = dynamics::solveStatic(model, state, downward, {}, {.tolerance = 1e-5, .maximumIterations = 2000});
    if (found.ran(rest) && !rest->newton.converged) found.stop("The loop did not come to rest.");
    return -state.positions[cells / 2 + 1].y / all;
}

/// Hearts of strips heavy enough for them: a light one stands up.
void v28Loops(Findings& found) {
    for (const Loop& loop : {Loop{"pear", -pi / 2, 1},
                             {"pear", -pi / 2, 50},
                             {"pear", -pi / 2, 400},
                             {"heart", pi / 2, 200},
                             {"heart", pi / 2, 400},
                             {"heart", pi / 2, 300}}) {
        const double exact = heightByElastica(found, loop);
        found.within(fmt::format("{} loop, ρgL³/B = {:g}, 64 cells: height over length", loop.name, loop.gamma), exact,
                     heightOfStrip(found, loop, 64), 0.01);
    }
}

} // namespace

std::vector<Case> loopCases() {
    return {{"V28", "loops", "heart and pear loop", v28Loops}};
}

} // namespace toile::study::validation
