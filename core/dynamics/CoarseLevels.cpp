// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/CoarseLevels.h"

#include "core/base/Contracts.h"
#include "core/dynamics/Colouring.h"

#include <algorithm>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double unknown = -1; ///< flatness, before anything is measured
/// A coarse particle that follows a pinned one so closely is pinned [–].
constexpr double samePlace = 0.9;
/// Cloth whose mean stretch is less is folded and left to the finer levels, cloth whose is more is flat; in between a
/// part of a level acts, for a fold that comes and goes with what acts on it would tremble for ever [–].
constexpr double folded = 0.6, flat = 0.8;
/// Part that the frame steps before have in what is measured [–].
constexpr double remembered = 0.8;

template <class Positions>
Vec3 weighted(const std::array<double, 3>& weights, const std::array<int, 3>& particles, const Positions& x) {
    return weights[0] * x[particles[0]] + weights[1] * x[particles[1]] + weights[2] * x[particles[2]];
}

/// Of which a thread's part holds at least so many: it takes some microseconds.
struct LeastLevelShare {
    int particles, centres, triangles;
};
constexpr LeastLevelShare leastLevelShare{750, 200, 30}; ///< triangles in fours

constexpr int lanes = 4, corners = 3;

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
    : kernels_(fastestKernels()), mass_(mass.begin(), mass.end()),
      inverseMass_(inverseMass.begin(), inverseMass.end()) {
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

        const std::vector<int> parents = parentsOf(*finer, mesh);
        std::vector<double> held(level.triangles.size(), 0);
        for (std::size_t t = 0; t < finerTriangles.size(); ++t) {
            finerTriangles[t].parent = parents[t];
            held[finerTriangles[t].parent] += finerTriangles[t].area;
        }
        for (Triangle& t : finerTriangles) t.share = t.area / held[t.parent];
        for (std::size_t t = 0; t < held.size(); ++t) level.triangles[t].area = held[t];
        putInSeries(finerTriangles, level.triangles);
        compile(level, mesh.particles);
        level.before.resize(mesh.particles);
        level.meanU.resize(level.triangles.size());
        level.meanV.resize(level.triangles.size());
        levels_.push_back(std::move(level));
        finer = &mesh;
    }
}

/// A coarse triangle is as soft as the soft cloth in it lets it be: a narrow region is not held by what is round it.
void CoarseLevels::putInSeries(std::span<const Triangle> finer, std::span<Triangle> coarse) {
    std::vector<PerStrain> compliance(coarse.size(), PerStrain{});
    for (const Triangle& t : finer)
        for (int k = 0; k < 3; ++k) compliance[t.parent][k] += t.share / t.modulus[k];
    for (std::size_t t = 0; t < coarse.size(); ++t)
        for (int k = 0; k < 3; ++k) coarse[t].modulus[k] = 1 / compliance[t][k];
}

/// Fours of triangles that share no particle. A lane without one has corners of its own, and nothing to do.
void CoarseLevels::compile(Level& level, int particles) {
    level.places.resize(particles + lanes * corners);
    for (int c = 0; c < particles; ++c) level.places[c].inverseMass = level.inverseMass[c];
    const ColouredGroups coloured =
        colouredGroups(level.triangles, particles, lanes, [](const Triangle& t) { return t.particles; });
    level.borders = coloured.borders;
    level.seats.resize(level.triangles.size());
    for (const auto& group : coloured.groups) {
        FourLevelTriangles& four = level.fours.emplace_back();
        four.flatness.fill(unknown);
        for (int lane = 0; lane < lanes; ++lane) {
            for (int k = 0; k < corners; ++k) four.particles[k][lane] = particles + lane * corners + k;
            if (lane >= std::ssize(group)) continue;
            const Triangle& t = level.triangles[group[lane]];
            level.seats[group[lane]] = {static_cast<int>(level.fours.size()) - 1, lane};
            for (int k = 0; k < corners; ++k) {
                four.particles[k][lane] = t.particles[k];
                four.u[k][lane] = t.u[k];
                four.v[k][lane] = t.v[k];
            }
        }
    }
}

void CoarseLevels::forget() {
    for (Level& level : levels_)
        for (FourLevelTriangles& four : level.fours) {
            four.weft.fill(0);
            four.flatness.fill(unknown);
        }
}

double CoarseLevels::lightest() const {
    double least = infinite;
    for (const Level& level : levels_) {
        std::vector<double> sorted = level.mass;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::ranges::nth_element(sorted, middle);
        for (const double m : level.mass) least = std::min(least, m / *middle);
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
            const auto [at, lane] = level.seats[t];
            for (int k = 0; k < 3; ++k) {
                wanted[t][k] = std::min(wanted[t][k], triangle.modulus[k]);
                double& factor = level.fours[at].factors[k][lane];
                factor = 0;
                if (!(wanted[t][k] > 0) || !(w[k] > 0) || !(triangle.area > 0)) continue;
                const double compliance = std::max(1 / (wanted[t][k] * triangle.area * h * h), w[k] / cap);
                factor = 1 / (w[k] + compliance);
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
    const auto gatherFrom = [team](const auto& from, Level& level) {
        inParts(team, level.centres.count(), leastLevelShare.centres, [&](int begin, int end) {
            for (int c = begin; c < end; ++c) {
                Vec3 sum;
                for (const auto& [finer, share] : level.centres.of(c)) sum += share * from[finer];
                static_cast<Vec3&>(level.places[c]) = level.before[c] = sum;
            }
        });
    };
    gatherFrom(positions, levels_[0]);
    for (std::size_t l = 1; l < levels_.size(); ++l) gatherFrom(levels_[l - 1].places, levels_[l]);
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
            const double flatness = std::clamp((std::min(weft, warp) - folded) / (flat - folded), 0.0, 1.0);
            const Vec3 u = weighted(t.u, t.particles, level.places), v = weighted(t.v, t.particles, level.places);
            const double shear = dot(u, v) - dot(level.meanU[i], level.meanV[i]);
            FourLevelTriangles& four = level.fours[level.seats[i].four];
            const int lane = level.seats[i].lane;
            const double old = four.flatness[lane] == unknown ? 0 : remembered;
            four.flatness[lane] = mixed(four.flatness[lane], flatness, old);
            if (flatness == 0) continue;
            // What was never measured, folded as it was, is taken as it is.
            const double known = four.weft[lane] > 0 ? old : 0;
            four.weft[lane] = mixed(four.weft[lane], length(u) / weft, known);
            four.warp[lane] = mixed(four.warp[lane], length(v) / warp, known);
            four.shear[lane] = mixed(four.shear[lane], shear, known);
        }
    }
}

void CoarseLevels::correct(std::span<Vec3> positions, Team* team) {
    gather(positions, team);
    for (std::size_t l = levels_.size(); l-- > 0;) {
        Level& level = levels_[l];
        byColours(team, level.borders, leastLevelShare.triangles, [&](int begin, int end) {
            kernels_.level(level.places.data(), std::span(level.fours).subspan(begin, end - begin));
        });
        for (std::size_t c = 0; c < level.before.size(); ++c) level.before[c] = level.places[c] - level.before[c];
        if (l > 0) carryDown(level, levels_[l - 1].places, levels_[l - 1].inverseMass, team);
        else carryDown(level, positions, inverseMass_, team);
    }
}

template <class Positions>
void CoarseLevels::carryDown(const Level& level, Positions& finer, std::span<const double> inverseMass, Team* team) {
    inParts(team, level.toFiner.count(), leastLevelShare.particles, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            if (inverseMass[p] == 0) continue;
            Vec3 move;
            for (const auto& [coarse, weight] : level.toFiner.of(p)) move += weight * level.before[coarse];
            finer[p] += move;
        }
    });
}

std::size_t CoarseLevels::bytes() const {
    std::size_t sum =
        fine_.capacity() * sizeof(Triangle) + (mass_.capacity() + inverseMass_.capacity()) * sizeof(double);
    for (const Level& level : levels_)
        sum +=
            (level.mass.capacity() + level.inverseMass.capacity()) * sizeof(double) +
            level.triangles.capacity() * sizeof(Triangle) + level.seats.capacity() * sizeof(Seat) +
            level.fours.capacity() * sizeof(FourLevelTriangles) + level.places.capacity() * sizeof(Place) +
            (level.toFiner.begin.capacity() + level.centres.begin.capacity() + level.borders.capacity()) * sizeof(int) +
            (level.toFiner.terms.capacity() + level.centres.terms.capacity()) * sizeof(Prolongation::Term) +
            (level.before.capacity() + level.meanU.capacity() + level.meanV.capacity()) * sizeof(Vec3);
    return sum;
}

} // namespace toile::dynamics
