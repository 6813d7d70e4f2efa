// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/CoarseLevels.h"

#include "core/base/Contracts.h"
#include "core/dynamics/Colouring.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace toile::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// A coarse particle that follows a pinned one so closely is pinned [–].
constexpr double samePlace = 0.9;
/// Cloth whose mean stretch is less is folded, and is left to the finer levels for the frame step [–].
constexpr double flatEnough = 0.7;
/// Part that the frame steps before have in what is measured [–].
constexpr double remembered = 0.8;

Vec3 weighted(const std::array<double, 3>& weights, const std::array<int, 3>& particles, std::span<const Vec3> x) {
    return weights[0] * x[particles[0]] + weights[1] * x[particles[1]] + weights[2] * x[particles[2]];
}

Vec3 weighted(const std::array<double, 3>& weights, const std::array<Vec3, 3>& x) {
    return weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2];
}

/// Of which a thread's part holds at least so many: it takes some microseconds.
struct LeastShare {
    int particles, centres, triangles;
};
constexpr LeastShare leastShare{1500, 400, 120};

/// Each coarse particle as the centre of mass of what follows it: the same weights, by coarse particle.
Prolongation centresOf(const Prolongation& toFiner, std::span<const double> finerMass, std::span<const double> mass) {
    std::vector<std::vector<Prolongation::Term>> rows(mass.size());
    for (int p = 0; p < toFiner.count(); ++p)
        for (const auto& [coarse, weight] : toFiner.of(p))
            if (mass[coarse] > 0) rows[coarse].push_back({p, weight * finerMass[p] / mass[coarse]});
    Prolongation centres{{0}, {}};
    for (const auto& row : rows) {
        centres.terms.insert(centres.terms.end(), row.begin(), row.end());
        centres.begin.push_back(static_cast<int>(centres.terms.size()));
    }
    return centres;
}

double mixed(double before, double now, double old) {
    return old > 0 ? old * before + (1 - old) * now : now;
}

} // namespace

CoarseLevels::CoarseLevels(const LevelMesh& fine, std::span<const LevelMesh> coarser, std::span<const double> mass,
                           std::span<const double> inverseMass)
    : mass_(mass.begin(), mass.end()), inverseMass_(inverseMass.begin(), inverseMass.end()) {
    expects(!coarser.empty(), "a hierarchy has a coarse level");
    expects(mass.size() == inverseMass.size() && static_cast<int>(mass.size()) == fine.particles, "one per particle");
    const auto compiled = [](const LevelMesh& mesh) {
        std::vector<Triangle> triangles;
        for (const LevelTriangle& t : mesh.triangles) {
            const Vec2 p = t.material[1] - t.material[0], q = t.material[2] - t.material[0];
            const double whole = cross(p, q); // inverse of [p q]: rows (q.y, −q.x), (−p.y, p.x) over this
            triangles.push_back({t.particles,
                                 {(p.y - q.y) / whole, q.y / whole, -p.y / whole},
                                 {(q.x - p.x) / whole, -q.x / whole, p.x / whole},
                                 areaOf(t),
                                 -1,
                                 0,
                                 {t.weft, t.warp, t.shear}});
        }
        return triangles;
    };
    fine_ = compiled(fine);
    const LevelMesh* finer = &fine;
    std::vector<int> finerOrder(fine_.size()); // of the triangles as they are kept, in their mesh
    std::iota(finerOrder.begin(), finerOrder.end(), 0);
    for (const LevelMesh& mesh : coarser) {
        std::vector<Triangle>& finerTriangles = levels_.empty() ? fine_ : levels_.back().triangles;
        const std::vector<double>& finerMass = levels_.empty() ? mass_ : levels_.back().mass;
        const std::vector<double>& finerInverse = levels_.empty() ? inverseMass_ : levels_.back().inverseMass;
        Level level;
        level.toFiner = prolongation(*finer, mesh);
        level.mass.assign(mesh.particles, 0);
        std::vector<char> pinned(mesh.particles, 0);
        for (int p = 0; p < finer->particles; ++p)
            for (const auto& [coarse, weight] : level.toFiner.of(p)) {
                level.mass[coarse] += weight * finerMass[p];
                if (finerMass[p] > 0 && finerInverse[p] == 0 && weight > samePlace) pinned[coarse] = 1;
            }
        for (int c = 0; c < mesh.particles; ++c)
            level.inverseMass.push_back(pinned[c] || level.mass[c] <= 0 ? 0 : 1 / level.mass[c]);

        level.triangles = compiled(mesh);
        level.centres = centresOf(level.toFiner, finerMass, level.mass);

        const std::vector<int> colours =
            coloursOf(level.triangles, mesh.particles, [](const Triangle& t) { return t.particles; });
        const std::vector<int> order = orderByColour(colours);
        level.borders = bordersOfColours(colours);
        std::vector<int> placeOf(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) placeOf[order[i]] = static_cast<int>(i);
        level.triangles = inOrder(level.triangles, order);
        const std::vector<int> parents = parentsOf(*finer, mesh);
        std::vector<double> held(level.triangles.size(), 0);
        for (std::size_t t = 0; t < finerTriangles.size(); ++t) {
            finerTriangles[t].parent = placeOf[parents[finerOrder[t]]];
            held[finerTriangles[t].parent] += finerTriangles[t].area;
        }
        for (Triangle& t : finerTriangles) t.share = t.area / held[t.parent];
        for (std::size_t t = 0; t < held.size(); ++t) level.triangles[t].area = held[t];
        level.actions.assign(level.triangles.size(), {.weft = infinite, .warp = infinite});
        level.positions.resize(mesh.particles);
        level.before.resize(mesh.particles);
        level.meanU.resize(level.triangles.size());
        level.meanV.resize(level.triangles.size());
        levels_.push_back(std::move(level));
        finer = &mesh;
        finerOrder = order;
    }
}

void CoarseLevels::forget() {
    for (Level& level : levels_)
        for (Action& action : level.actions) action.weft = action.warp = infinite;
}

double CoarseLevels::lightest() const {
    double least = infinite;
    for (const Level& level : levels_) {
        const double mean = std::accumulate(level.mass.begin(), level.mass.end(), 0.0) / double(level.mass.size());
        for (const double m : level.mass) least = std::min(least, m / mean);
    }
    return least;
}

void CoarseLevels::beginStep(std::span<const Vec3> positions, double h, double cap) {
    compileFor(h, cap);
    gather(positions);
    measure(positions);
}

/// Every level may be as stiff as the cap lets it, and no stiffer than what is still missing from the fabric: all
/// together are never stiffer than the cloth.
void CoarseLevels::compileFor(double h, double cap) {
    if (std::abs(h - compiledStep_) <= 1e-12 * h && cap == compiledCap_) return;
    compiledStep_ = h;
    compiledCap_ = cap;
    const auto worksOn = [](const Triangle& t, std::span<const double> inverseMass) { // w of each strain
        PerStrain w{};
        for (int i = 0; i < 3; ++i) {
            const double mobility = inverseMass[t.particles[i]];
            w[0] += mobility * t.u[i] * t.u[i];
            w[1] += mobility * t.v[i] * t.v[i];
            w[2] += mobility * (t.u[i] * t.u[i] + t.v[i] * t.v[i]);
        }
        return w;
    };
    std::vector<PerStrain> missing; // [N/m]
    for (const Triangle& t : fine_) {
        const PerStrain w = worksOn(t, inverseMass_);
        PerStrain left{};
        for (int k = 0; k < 3; ++k) // ½: a fine spring serves the triangles on either side
            left[k] = w[k] > 0 ? std::max(0.0, t.modulus[k] - 0.5 * cap / (w[k] * h * h * t.area)) : 0;
        missing.push_back(left);
    }
    std::span<const Triangle> finer = fine_;
    for (Level& level : levels_) {
        std::vector<PerStrain> wanted(level.triangles.size(), PerStrain{});
        for (std::size_t t = 0; t < finer.size(); ++t)
            for (int k = 0; k < 3; ++k) wanted[finer[t].parent][k] += finer[t].share * missing[t][k];
        for (std::size_t t = 0; t < level.triangles.size(); ++t) {
            const Triangle& triangle = level.triangles[t];
            const PerStrain w = worksOn(triangle, level.inverseMass);
            for (int k = 0; k < 3; ++k) {
                level.actions[t].factors[k] = 0;
                if (!(wanted[t][k] > 0) || !(w[k] > 0) || !(triangle.area > 0)) continue;
                const double compliance = std::max(1 / (wanted[t][k] * triangle.area * h * h), w[k] / cap);
                level.actions[t].factors[k] = 1 / (w[k] + compliance);
                wanted[t][k] = std::max(0.0, wanted[t][k] - 1 / (compliance * triangle.area * h * h));
            }
        }
        missing = std::move(wanted);
        finer = level.triangles;
    }
}

/// A coarse particle is the centre of mass of what follows it. Then a force between coarse particles along the line
/// between them turns nothing: angular momentum is kept, and a tube on a smooth body does not begin to spin.
void CoarseLevels::gather(std::span<const Vec3> positions, Team* team) {
    std::span<const Vec3> from = positions;
    for (Level& level : levels_) {
        inParts(team, level.centres.count(), leastShare.centres, [&](int begin, int end) {
            for (int c = begin; c < end; ++c) {
                Vec3 sum;
                for (const auto& [finer, share] : level.centres.of(c)) sum += share * from[finer];
                level.positions[c] = level.before[c] = sum;
            }
        });
        from = level.positions;
    }
}

/// Beside a border centres of mass lie nearer together than the corners they stand for. By how much does not depend on
/// folds, which bring both together: it is the ratio of the corners' stretch to the mean one of the cloth. What a frame
/// step finds changes where the cloth goes in it; most is kept of the steps before, or cloth that presses on a
/// body would flip between two states for ever.
void CoarseLevels::measure(std::span<const Vec3> positions) {
    for (Level& level : levels_) {
        std::ranges::fill(level.meanU, Vec3{});
        std::ranges::fill(level.meanV, Vec3{});
    }
    for (const Triangle& t : fine_) {
        levels_[0].meanU[t.parent] += t.share * weighted(t.u, t.particles, positions);
        levels_[0].meanV[t.parent] += t.share * weighted(t.v, t.particles, positions);
    }
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        Level& level = levels_[l];
        for (std::size_t i = 0; i < level.triangles.size(); ++i) {
            const Triangle& t = level.triangles[i];
            if (l + 1 < levels_.size()) {
                levels_[l + 1].meanU[t.parent] += t.share * level.meanU[i];
                levels_[l + 1].meanV[t.parent] += t.share * level.meanV[i];
            }
            const double weft = length(level.meanU[i]), warp = length(level.meanV[i]);
            const bool folded = weft < flatEnough || warp < flatEnough;
            const Vec3 u = weighted(t.u, t.particles, level.positions), v = weighted(t.v, t.particles, level.positions);
            const double shear = dot(u, v) - dot(level.meanU[i], level.meanV[i]);
            Action& action = level.actions[i];
            const double old = action.weft == infinite ? 0 : remembered;
            action.weft = folded ? infinite : mixed(action.weft, length(u) / weft, old);
            action.warp = folded ? infinite : mixed(action.warp, length(v) / warp, old);
            action.shear = mixed(action.shear, shear, old);
        }
    }
}

void CoarseLevels::correct(std::span<Vec3> positions, Team* team) {
    gather(positions, team);
    for (std::size_t l = levels_.size(); l-- > 0;) {
        Level& level = levels_[l];
        byColours(team, level.borders, leastShare.triangles, [&](int begin, int end) { sweep(level, begin, end); });
        for (std::size_t c = 0; c < level.positions.size(); ++c) level.before[c] = level.positions[c] - level.before[c];
        const std::span<const double> inverseMass = l > 0 ? levels_[l - 1].inverseMass : inverseMass_;
        const std::span<Vec3> finer = l > 0 ? std::span<Vec3>(levels_[l - 1].positions) : positions;
        inParts(team, level.toFiner.count(), leastShare.particles, [&](int begin, int end) {
            for (int p = begin; p < end; ++p) {
                if (inverseMass[p] == 0) continue;
                Vec3 move;
                for (const auto& [coarse, weight] : level.toFiner.of(p)) move += weight * level.before[coarse];
                finer[p] += move;
            }
        });
    }
}

void CoarseLevels::sweep(Level& level, int begin, int end) {
    for (int i = begin; i < end; ++i) {
        const Triangle& t = level.triangles[i];
        const Action& action = level.actions[i];
        if (action.weft == infinite) continue;
        std::array<Vec3, 3> x;
        for (int k = 0; k < 3; ++k) x[k] = level.positions[t.particles[k]];
        const auto move = [&](double lambda, const std::array<double, 3>& weights, const Vec3& direction) {
            for (int k = 0; k < 3; ++k) x[k] += (lambda * weights[k] * level.inverseMass[t.particles[k]]) * direction;
        };
        // A fold brings corners nearer and is no compression: only what is taut pulls.
        const auto pull = [&](double factor, double flat, const std::array<double, 3>& weights) {
            const Vec3 f = weighted(weights, x);
            const double stretch = length(f);
            if (stretch > flat) move(-factor * (stretch - flat) / stretch, weights, f);
        };
        if (action.factors[0] > 0) pull(action.factors[0], action.weft, t.u);
        if (action.factors[1] > 0) pull(action.factors[1], action.warp, t.v);
        if (action.factors[2] > 0) {
            const Vec3 u = weighted(t.u, x), v = weighted(t.v, x);
            const double lambda = -action.factors[2] * (dot(u, v) - action.shear);
            move(lambda, t.u, v);
            move(lambda, t.v, u);
        }
        for (int k = 0; k < 3; ++k) level.positions[t.particles[k]] = x[k];
    }
}

std::size_t CoarseLevels::bytes() const {
    std::size_t sum =
        fine_.capacity() * sizeof(Triangle) + (mass_.capacity() + inverseMass_.capacity()) * sizeof(double);
    for (const Level& level : levels_)
        sum +=
            (level.mass.capacity() + level.inverseMass.capacity()) * sizeof(double) +
            level.triangles.capacity() * sizeof(Triangle) + level.actions.capacity() * sizeof(Action) +
            (level.toFiner.begin.capacity() + level.centres.begin.capacity() + level.borders.capacity()) * sizeof(int) +
            (level.toFiner.terms.capacity() + level.centres.terms.capacity()) * sizeof(Prolongation::Term) +
            (level.positions.capacity() + level.before.capacity() + level.meanU.capacity() + level.meanV.capacity()) *
                sizeof(Vec3);
    return sum;
}

} // namespace toile::dynamics
