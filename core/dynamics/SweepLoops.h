// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of a sweep. Compiled once for each kind of processor by Kernels.cpp and KernelsAvx2.cpp.
#ifdef TOILE_SWEEP_LOOPS
#error "Two kinds of processor in one compilation would be the same one."
#endif
#define TOILE_SWEEP_LOOPS

#include "core/cloth/FoldAngle.h"
#include "core/cloth/Forces.h"
#include "core/dynamics/SweepKernels.h"
#include "core/dynamics/SweepLanes.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace toile::dynamics {
namespace {

void sweepSprings(Place* places, std::span<const FourSprings> springs) {
    constexpr double shortest = 1e-12; // [m]; a shorter spring has no direction of its own
    for (const FourSprings& s : springs) {
        Four a[4], b[4], d[4], squares[4];
        for (int i = 0; i < 4; ++i) {
            a[i] = load(places[s.a[i]]);
            b[i] = load(places[s.b[i]]);
            d[i] = vectorOf(b[i] - a[i]);
            squares[i] = d[i] * d[i];
        }
        transpose(squares[0], squares[1], squares[2], squares[3]);
        Four length = squareRoot(squares[0] + squares[1] + squares[2]);
        if (any(length < shortest)) [[unlikely]]
            for (int i = 0; i < 4; ++i)
                if (length[i] < shortest) {
                    const Vec3 own = cloth::ownDirection(s.a[i], s.b[i]);
                    d[i] = Four{shortest * own.x, shortest * own.y, shortest * own.z, 0};
                    length[i] = shortest;
                }
        const Four factor = load(s.share) * (length - load(s.restLength)) / length;
        for (int i = 0; i < 4; ++i) {
            const Four push = all(factor[i]) * d[i];
            store(places[s.a[i]], a[i] + inverseMassOf(a[i]) * push);
            store(places[s.b[i]], b[i] - inverseMassOf(b[i]) * push);
        }
    }
}

template <int N>
void sweepLinear(Place* places, std::span<const LinearElement<N>> elements) {
    for (const LinearElement<N>& e : elements) {
        Four x[N], c[N];
        for (int i = 0; i < N; ++i) x[i] = load(places[e.particles[i]]);
        Four value{};
        c[N - 1] = Four{};
        for (int i = 0; i < N - 1; ++i) {
            c[i] = all(e.coefficients[i]);
            c[N - 1] -= c[i];
            value += c[i] * (x[i] - x[N - 1]);
        }
        const Four push = vectorOf(all(e.share) * value);
        for (int i = 0; i < N; ++i) store(places[e.particles[i]], x[i] - inverseMassOf(x[i]) * c[i] * push);
    }
}

/// Solves (A + compliance)·λ = −values in place; only the lower half of A is read. No compliance is below the diagonal
/// over the cap; where it is infinite, λ is 0.
template <int N>
TOILE_LANES void solve(Four (&a)[N][N], Four (&lambda)[N], const Four (&values)[N], const Four (&compliance)[N],
                       Four perCap) {
    Four inverse[N];
    for (int i = 0; i < N; ++i) { // A = L D Lᵀ; above the diagonal, L·D
        for (int j = 0; j < i; ++j) {
            Four sum = a[i][j];
            for (int k = 0; k < j; ++k) sum -= a[i][k] * a[k][j];
            a[j][i] = sum;
            a[i][j] = sum * inverse[j];
        }
        Four diagonal = a[i][i] + larger(compliance[i], a[i][i] * perCap);
        for (int k = 0; k < i; ++k) diagonal -= a[i][k] * a[k][i];
        inverse[i] = all(1) / diagonal;
        lambda[i] = -values[i];
        for (int k = 0; k < i; ++k) lambda[i] -= a[i][k] * lambda[k];
    }
    for (int i = N - 1; i >= 0; --i) {
        lambda[i] *= inverse[i];
        for (int k = i + 1; k < N; ++k) lambda[i] -= a[k][i] * lambda[k];
    }
}

/// cloth::tensionSecant of four membranes.
TOILE_LANES Four secant(const TensionLaw& law, int which, Four strain) {
    const FourCurves& curve = law.curves[which];
    Four from{}, factor = all(1), rise{}, run = all(1);
    for (int b = curve.first; b < curve.end; ++b) {
        const FourBends& bend = law.bends[b];
        const Four start = load(bend.strain);
        const FourFlags isBeyond = strain > start;
        from = isBeyond ? start : from;
        factor = isBeyond ? load(bend.factor) : factor;
        rise = isBeyond ? load(bend.rise) : rise;
        run = isBeyond ? load(bend.run) : run;
    }
    const Four last = load(curve.last), along = factor + rise * (strain - from) / run;
    const FourFlags isOnTangent = strain > last;
    if (!any(isOnTangent)) return along;
    return isOnTangent ? (load(curve.stress) + load(curve.tangent) * (strain - last)) / strain : along;
}

/// 1/(k h²), infinite without stiffness.
TOILE_LANES Four complianceOf(Four stiffness, Four h) {
    return stiffness > Four{} ? all(1) / (stiffness * h * h) : all(std::numeric_limits<double>::infinity());
}

/// Coupling and compliance of four elements under their strains.
template <int N>
struct Response {
    Four coupling;
    Four compliance[N];

    template <class Elements>
    TOILE_LANES Response(const Elements& e, const TensionLaw& law, int four, Four weft, Four warp) {
        coupling = load(e.coupling);
        for (int c = 0; c < N; ++c) compliance[c] = load(e.compliance[c]);
        if (law.fours.empty() || !any((weft > Four{}) | (warp > Four{}))) return; // as slack as they were compiled
        const FourMembranes& m = law.fours[four];
        const Four h = all(law.h), area = load(m.area), c12 = load(m.c12);
        const Four c11 = load(m.c11) * secant(law, m.weft, weft), c22 = load(m.c22) * secant(law, m.warp, warp);
        coupling = c22 > Four{} ? c12 / c22 : Four{};
        const Four along = complianceOf(area * c11, h), across = complianceOf(area * c22, h);
        const FourFlags isThere = area > Four{};
        const Four bent[4] = {complianceOf(area * (c11 - coupling * c12), h), across, along, across};
        for (int c = 0; c + 1 < N; ++c) compliance[c] = isThere ? bent[c] : compliance[c];
    }
};

/// A symmetric 2×2 matrix.
struct Symmetric {
    Four xx{}, yy{}, xy{};
};

/// Strains of Biot as in cloth::Stretch. Gradients lie in the plane of the two columns f_u, f_v of the deformation
/// gradient, so that all but the last step is done with two numbers for each: ∂C/∂f_u = 2(f_u·z.xx + f_v·z.xy),
/// ∂C/∂f_v = 2(f_u·z.xy + f_v·z.yy).
void sweepTriangles(Place* places, std::span<const FourTriangles> triangles, double cap, const TensionLaw& law,
                    int first) {
    const Four one = all(1), two = all(2), perCap = all(1 / cap);
    const Four smallest = all(1e-8); // of det S: a collapsed triangle keeps finite forces
    for (const FourTriangles& t : triangles) {
        Corners corners[3];
        for (int i = 0; i < 3; ++i) corners[i] = gather(places, t.particles[i]);
        Four d[4];
        for (int i = 0; i < 4; ++i) d[i] = load(t.inverseRest[i]);
        const Four wu[3] = {-d[0] - d[2], d[0], d[2]}, wv[3] = {-d[1] - d[3], d[1], d[3]};
        const Vectors p = corners[1].at - corners[0].at, q = corners[2].at - corners[0].at;
        const Vectors fu = p * d[0] + q * d[2], fv = p * d[1] + q * d[3];

        const Symmetric f{dot(fu, fu), dot(fv, fv), dot(fu, fv)}; // FᵀF
        const Four area = squareRoot(larger(Four{}, f.xx * f.yy - f.xy * f.xy));
        const Four determinant = larger(area, smallest);
        const Four trace = squareRoot(larger(f.xx + f.yy + two * area, all(4) * smallest));
        const Four perTrace = one / trace;
        const Symmetric s{(f.xx + area) * perTrace, (f.yy + area) * perTrace, f.xy * perTrace};

        const Four weft = s.xx - one, warp = s.yy - one;
        const Response<3> response(t, law, first + static_cast<int>(&t - triangles.data()), weft, warp);
        const Four coupling = response.coupling;
        const Four values[3] = {weft, warp + coupling * weft, two * s.xy};

        // Z with S Z + Z S = B for B = (1, 0, 0), (coupling, 1, 0) and (0, 0, 1) as xx, yy, xy
        const Four a = trace - s.xx, b = trace - s.yy, c = -s.xy, scale = perTrace / (two * determinant);
        const Symmetric ofWeft{scale * (determinant + a * a), scale * (c * c), scale * (a * c)};
        const Symmetric ofWarp{scale * (c * c), scale * (determinant + b * b), scale * (c * b)};
        const Symmetric z[3] = {
            ofWeft,
            {ofWarp.xx + coupling * ofWeft.xx, ofWarp.yy + coupling * ofWeft.yy, ofWarp.xy + coupling * ofWeft.xy},
            {scale * two * (a * c), scale * two * (c * b), scale * (determinant + a * b + c * c)}};

        Symmetric mobility; // Σ w·(wu, wv)(wu, wv)ᵀ over the corners
        for (int i = 0; i < 3; ++i) {
            const Four u = corners[i].inverseMass * wu[i], v = corners[i].inverseMass * wv[i];
            mobility.xx += u * wu[i];
            mobility.yy += v * wv[i];
            mobility.xy += u * wv[i];
        }
        Four g[3][3], lambda[3];
        for (int k = 0; k < 3; ++k) {
            const Four ux = f.xx * z[k].xx + f.xy * z[k].xy, uy = f.xy * z[k].xx + f.yy * z[k].xy;
            const Four vx = f.xx * z[k].xy + f.xy * z[k].yy, vy = f.xy * z[k].xy + f.yy * z[k].yy;
            const Four mux = mobility.xx * ux + mobility.xy * vx, muy = mobility.xx * uy + mobility.xy * vy;
            const Four mvx = mobility.xy * ux + mobility.yy * vx, mvy = mobility.xy * uy + mobility.yy * vy;
            for (int l = k; l < 3; ++l)
                g[l][k] = all(4) * (z[l].xx * mux + z[l].xy * muy + z[l].xy * mvx + z[l].yy * mvy);
        }
        solve<3>(g, lambda, values, response.compliance, perCap);

        Symmetric sum;
        for (int k = 0; k < 3; ++k) {
            const Four twice = two * lambda[k];
            sum.xx += twice * z[k].xx;
            sum.yy += twice * z[k].yy;
            sum.xy += twice * z[k].xy;
        }
        const Vectors u = fu * sum.xx + fv * sum.xy, v = fu * sum.xy + fv * sum.yy;
        for (int i = 0; i < 3; ++i) {
            corners[i].at = corners[i].at + (u * wu[i] + v * wv[i]) * corners[i].inverseMass;
            scatter(places, t.particles[i], corners[i]);
        }
    }
}

/// Mean strains as in the triangle, half differences of opposite sides, and the shear.
void sweepCells(Place* places, std::span<const FourCells> cells, double cap, const TensionLaw& law, int first) {
    const Four half = all(0.5), one = all(1), perCap = all(1 / cap);
    for (const FourCells& cell : cells) {
        Corners corners[4];
        for (int i = 0; i < 4; ++i) corners[i] = gather(places, cell.particles[i]);
        const Four u = load(cell.perWidth), v = load(cell.perHeight);
        const Vectors sides[4] = {(corners[1].at - corners[0].at) * u, (corners[2].at - corners[3].at) * u,
                                  (corners[3].at - corners[0].at) * v, (corners[2].at - corners[1].at) * v};
        Vectors along[4]; // half of each direction
        Four strain[4];
        for (int s = 0; s < 4; ++s) {
            const Four length = squareRoot(dot(sides[s], sides[s]));
            along[s] = sides[s] * (length > Four{} ? half / length : Four{});
            strain[s] = length - one;
        }
        const Vectors xu = (sides[0] + sides[1]) * half, xv = (sides[2] + sides[3]) * half;
        const Four weft = half * (strain[0] + strain[1]), warp = half * (strain[2] + strain[3]);
        const Response<5> response(cell, law, first + static_cast<int>(&cell - cells.data()), weft, warp);
        const Four coupling = response.coupling;
        const Four values[5] = {weft, warp + coupling * weft, half * (strain[0] - strain[1]),
                                half * (strain[2] - strain[3]), dot(xu, xv)};

        // How strains of sides act on each other: a side moves its ends along itself, so that opposite sides share
        // none, and neighbours one.
        const Vectors lower = along[0] * u, upper = along[1] * u, left = along[2] * v, right = along[3] * v;
        const Four w0 = corners[0].inverseMass, w1 = corners[1].inverseMass, w2 = corners[2].inverseMass,
                   w3 = corners[3].inverseMass;
        const Four lowerSelf = (w0 + w1) * dot(lower, lower), upperSelf = (w2 + w3) * dot(upper, upper);
        const Four leftSelf = (w0 + w3) * dot(left, left), rightSelf = (w1 + w2) * dot(right, right);
        const Four lowerLeft = w0 * dot(lower, left), lowerRight = -w1 * dot(lower, right);
        const Four upperLeft = -w3 * dot(upper, left), upperRight = w2 * dot(upper, right);
        const Vectors p = xv * (half * u), q = xu * (half * v), rising = p + q, falling = p - q;
        const Four lowerShear = w0 * dot(lower, rising) + w1 * dot(lower, falling);
        const Four upperShear = w2 * dot(upper, rising) + w3 * dot(upper, falling);
        const Four leftShear = w0 * dot(left, rising) - w3 * dot(left, falling);
        const Four rightShear = w2 * dot(right, rising) - w1 * dot(right, falling);

        // The same of their sums and half differences, of the warp with its coupling, and of the shear.
        const Four weftSelf = lowerSelf + upperSelf, weftUneven = lowerSelf - upperSelf;
        const Four warpSelf = leftSelf + rightSelf, warpUneven = leftSelf - rightSelf;
        const Four weftWarp = (lowerLeft + lowerRight) + (upperLeft + upperRight);
        const Four unevenWarp = (lowerLeft + lowerRight) - (upperLeft + upperRight);
        const Four weftUnevenWarp = (lowerLeft - lowerRight) + (upperLeft - upperRight);
        const Four bothUneven = (lowerLeft - lowerRight) - (upperLeft - upperRight);
        const Four weftShear = lowerShear + upperShear;
        Four g[5][5], lambda[5];
        g[0][0] = weftSelf;
        g[1][0] = weftWarp + coupling * weftSelf;
        g[1][1] = warpSelf + coupling * (weftWarp + g[1][0]);
        g[2][0] = weftUneven;
        g[2][1] = unevenWarp + coupling * weftUneven;
        g[2][2] = weftSelf;
        g[3][0] = weftUnevenWarp;
        g[3][1] = warpUneven + coupling * weftUnevenWarp;
        g[3][2] = bothUneven;
        g[3][3] = warpSelf;
        g[4][0] = weftShear;
        g[4][1] = leftShear + rightShear + coupling * weftShear;
        g[4][2] = lowerShear - upperShear;
        g[4][3] = leftShear - rightShear;
        g[4][4] = (w0 + w2) * dot(rising, rising) + (w1 + w3) * dot(falling, falling);
        solve<5>(g, lambda, values, response.compliance, perCap);

        const Four mean = lambda[0] + coupling * lambda[1];
        const Vectors byLower = lower * (mean + lambda[2]), byUpper = upper * (mean - lambda[2]);
        const Vectors byLeft = left * (lambda[1] + lambda[3]), byRight = right * (lambda[1] - lambda[3]);
        const Vectors byRising = rising * lambda[4], byFalling = falling * lambda[4];
        corners[0].at = corners[0].at - (byLower + byLeft + byRising) * w0;
        corners[1].at = corners[1].at + (byLower - byRight + byFalling) * w1;
        corners[2].at = corners[2].at + (byUpper + byRight + byRising) * w2;
        corners[3].at = corners[3].at + (byLeft - byUpper - byFalling) * w3;
        for (int i = 0; i < 4; ++i) scatter(places, cell.particles[i], corners[i]);
    }
}

/// As cloth::foldAngle has it; a hinge of which a triangle has no plane is left alone.
void sweepHinges(Place* places, std::span<const FourHinges> hinges, double cap) {
    const Four one = all(1), perCap = all(1 / cap), tiny = all(1e-30),
               leastPlane = all(cloth::leastHeight * cloth::leastHeight);
    for (const FourHinges& h : hinges) {
        Corners corners[4];
        for (int i = 0; i < 4; ++i) corners[i] = gather(places, h.particles[i]);
        const Vectors e = corners[1].at - corners[0].at;
        const Vectors toC = corners[2].at - corners[0].at, toD = corners[3].at - corners[0].at;
        const Vectors n1 = cross(e, toC), n2 = cross(toD, e);
        const Four ee = dot(e, e), n1n1 = dot(n1, n1), n2n2 = dot(n2, n2), length = squareRoot(ee);
        const FourFlags flat = (ee < tiny) | (n1n1 < leastPlane * ee * ee) | (n2n2 < leastPlane * ee * ee);
        const Four sine = dot(e, cross(n2, n1)), cosine = length * dot(n1, n2), rest = load(h.restAngle);
        Four angle{};
        for (int i = 0; i < 4; ++i) {
            const double from = std::atan2(sine[i], cosine[i]) - rest[i];
            const double over = std::copysign(std::max(0.0, std::abs(rest[i]) - std::numbers::pi / 2), rest[i]);
            angle[i] = std::abs(from) < std::numbers::pi
                           ? from
                           : std::remainder(from + over, 2 * std::numbers::pi) - over; // as cloth::angleFrom has it
        }
        const Vectors atC = n1 * (length / n1n1), atD = n2 * (length / n2n2);
        const Four s = dot(toC, e) / ee, t = dot(toD, e) / ee; // where the feet of c and d lie on the edge
        const Vectors gradients[4] = {atC * (s - one) + atD * (t - one), atC * -s - atD * t, atC, atD};
        Four g{};
        for (int i = 0; i < 4; ++i) g += corners[i].inverseMass * dot(gradients[i], gradients[i]);
        const Four lambda = flat ? Four{} : -angle / (g + larger(load(h.compliance), g * perCap));
        for (int i = 0; i < 4; ++i) {
            const Vectors moved = corners[i].at + gradients[i] * (corners[i].inverseMass * lambda);
            corners[i].at = {flat ? corners[i].at.x : moved.x, flat ? corners[i].at.y : moved.y,
                             flat ? corners[i].at.z : moved.z};
            scatter(places, h.particles[i], corners[i]);
        }
    }
}

/// A fold brings corners nearer and is no compression: only what is taut pulls, along its chord.
TOILE_LANES void pullTaut(Corners (&corners)[3], const Four (&weights)[3], Four factor, Four flat) {
    const Vectors f = corners[0].at * weights[0] + corners[1].at * weights[1] + corners[2].at * weights[2];
    const Four stretch = squareRoot(dot(f, f));
    const Four lambda = stretch > flat ? -factor * (stretch - flat) / stretch : Four{};
    for (int i = 0; i < 3; ++i) corners[i].at = corners[i].at + f * (lambda * weights[i] * corners[i].inverseMass);
}

void sweepLevel(Place* places, std::span<const FourLevelTriangles> triangles) {
    for (const FourLevelTriangles& t : triangles) {
        Corners corners[3];
        Four u[3], v[3];
        for (int i = 0; i < 3; ++i) {
            corners[i] = gather(places, t.particles[i]);
            u[i] = load(t.u[i]);
            v[i] = load(t.v[i]);
        }
        const Four flatness = load(t.flatness);
        pullTaut(corners, u, flatness * load(t.factors[0]), load(t.weft));
        pullTaut(corners, v, flatness * load(t.factors[1]), load(t.warp));
        const Vectors fu = corners[0].at * u[0] + corners[1].at * u[1] + corners[2].at * u[2];
        const Vectors fv = corners[0].at * v[0] + corners[1].at * v[1] + corners[2].at * v[2];
        const Four lambda = -flatness * load(t.factors[2]) * (dot(fu, fv) - load(t.shear));
        for (int i = 0; i < 3; ++i) {
            const Four w = lambda * corners[i].inverseMass;
            corners[i].at = corners[i].at + fv * (w * u[i]) + fu * (w * v[i]);
            scatter(places, t.particles[i], corners[i]);
        }
    }
}

constexpr SweepKernels sweepKernels{sweepSprings, sweepLinear<3>, sweepLinear<4>, sweepTriangles,
                                    sweepCells,   sweepHinges,    sweepLevel};

} // namespace
} // namespace toile::dynamics
