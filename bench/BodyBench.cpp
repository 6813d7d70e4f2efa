// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to find the nearest place of a body (bench/NearestWays.h), asked what contact asks: a blouse is put on the body,
// and while it falls and when it lies its particles are followed through 20 substeps. Tables of cost, of errors against
// a search over all triangles, of contact in a substep, and of a broad phase over pieces and limbs. CPU times are
// medians of rounds in which the ways take turns.
//
//   toile-bench-body [AVATAR...]      default: mannequins with edges of 11.5 and of 6.6 mm
#include "app/batch/Opening.h"
#include "bench/NearestWays.h"
#include "bench/PieceBoxes.h"
#include "core/body/Mannequin.h"
#include "core/collision/BodySurface.h"
#include "core/collision/SurfaceTracker.h"
#include "core/collision/WindingNumber.h"
#include "core/dynamics/Xpbd.h"
#include "core/io/DocumentFile.h"
#include "core/simulation/BodyContactOf.h"
#include "core/simulation/Simulation.h"
#include "core/study/Calibration.h"
#include "samples/Blouse.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <random>

using namespace toile;
using bench::Nearest;

namespace {

constexpr int rounds = 5;
constexpr double planeReach = 0.00025; // as dynamics::BodyContactSettings has it [m]

template <class T>
T orStop(Result<T> result) {
    if (result) return std::move(*result);
    fmt::print(stderr, "{}\n", toString(result.error()));
    std::exit(1);
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

template <class Work>
double secondsOf(const Work& work) {
    const double start = study::threadSeconds();
    work();
    return study::threadSeconds() - start;
}

/// Where the particles of a garment are, substep by substep.
struct Trace {
    std::string what;
    std::vector<std::vector<Vec3>> substeps;
    std::vector<double> reach; ///< of each particle: the distance that it keeps from the skin [m]
    std::vector<int> piece;    ///< of each particle
};

/// The garment alone with the body and gravity for one frame, from where it is.
Trace traceOf(const std::string& what, const simulation::Simulation& garment) {
    constexpr int inFrame = 20;
    const auto& settings = garment.scene().settings;
    Trace trace{what, {}, garment.garment().halfThickness, std::vector<int>(garment.garment().halfThickness.size())};
    for (double& reach : trace.reach) reach += settings.skinOffset;
    const auto& map = garment.garment().particles;
    for (int node = 0, piece = 0; node < std::ssize(map.particleOf); ++node) {
        while (piece + 1 < std::ssize(map.firstNode) && node >= map.firstNode[piece + 1]) ++piece;
        trace.piece[map.particleOf[node]] = piece;
    }
    dynamics::ParticleState state = garment.state();
    const auto contact =
        simulation::bodyContactOf(garment.scene(), garment.garment(), *garment.body(), state.positions);
    dynamics::Stage* stages[] = {contact.get()};
    dynamics::Xpbd xpbd(garment.garment().model, {.damping = 3, .speedLimit = 10});
    for (int i = 0; i <= inFrame; ++i) {
        trace.substeps.push_back(state.positions);
        if (!xpbd.step(state, settings.frameStep / inFrame, 1, settings.gravity, stages)) std::abort();
    }
    return trace;
}

/// The blouse in the act of being put on, and as it lies.
std::vector<Trace> tracesOn(simulation::Scene scene) {
    constexpr int falling = 10, lying = 400; // frame steps
    auto garment = orStop(simulation::Simulation::create(std::move(scene), {.spacing = 0.014}));
    std::vector<Trace> traces;
    for (const int until : {falling, lying}) {
        while (garment.steps() < until)
            if (!garment.advance()) std::abort();
        traces.push_back(traceOf(until == falling ? "falls" : "lies", garment));
    }
    return traces;
}

/// Where a particle was when the body was asked for it last, and what it said; nowhere at first.
struct Known {
    Vec3 at{1e9, 0, 0};
    double distance = 0; ///< [m]
    [[nodiscard]] bool stillFar(const Vec3& p, double reach) const {
        const double slack = distance - reach;
        return slack > 0 && squaredLength(p - at) < slack * slack;
    }
};

struct Ask {
    Vec3 point;
    double radius = 0; ///< [m]
};

/// What is asked of the body when particles are followed as collision::SurfaceTracker follows them: a particle that is
/// surely too far is not asked for, nor one that is near its last tangent plane. The search reaches as far as the last
/// distance and the way since. Without the first substep, in which all ask.
std::vector<Ask> asksIn(const Trace& trace, bench::NearestWay& way) {
    std::vector<Known> known(trace.reach.size());
    std::vector<Ask> asks;
    for (const auto& positions : trace.substeps)
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double moved = distance(positions[i], known[i].at);
            if (moved <= planeReach || known[i].stillFar(positions[i], trace.reach[i])) continue;
            const Ask ask{positions[i], std::abs(known[i].distance) + moved + 1e-9};
            known[i] = {ask.point, way.nearest(ask.point, ask.radius)->signedDistance};
            if (&positions != &trace.substeps[0]) asks.push_back(ask);
        }
    return asks;
}

/// Points within 10 mm of the skin, all over it or only where it is sharp: fingers, toes, the rims of ears.
std::vector<Vec3> besideSkin(const collision::BodySurface& surface, bool onlySharp, std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    const auto& mesh = surface.mesh();
    const auto bumps = surface.bumps();
    std::vector<double> areas;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
        const bool taken = !onlySharp || std::ranges::any_of(bumps, [&](const Vec3& bump) {
            return squaredLength(bump - middle) < 0.005 * 0.005;
        });
        const Vec3 area = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        areas.push_back(taken ? length(area) : 0);
    }
    std::discrete_distribution<std::size_t> triangle(areas.begin(), areas.end());
    std::vector<Vec3> points;
    while (points.size() < count) {
        const auto& [a, b, c] = mesh.triangles[triangle(random)];
        const Vec3 p = mesh.vertices[a], q = mesh.vertices[b], r = mesh.vertices[c];
        const double u = share(random), v = (1 - u) * share(random), away = 0.01 * (2 * share(random) - 1);
        points.push_back(p + (q - p) * u + (r - p) * v + normalized(cross(q - p, r - p)) * away);
    }
    return points;
}

/// Errors of a way against the truth.
struct Errors {
    double distance = 0, usualDistance = 0, usualNormal = 0; ///< largest, of 99 % [m]; of 99 % [rad]
    int wrongSigns = 0, unanswered = 0;
};

Errors errorsOf(bench::NearestWay& way, const std::vector<Vec3>& points, const std::vector<Nearest>& truth) {
    Errors errors;
    std::vector<double> distances, angles;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto found = way.nearest(points[i], 0.03);
        if (!found) {
            ++errors.unanswered;
            continue;
        }
        distances.push_back(std::abs(found->signedDistance - truth[i].signedDistance));
        angles.push_back(std::acos(std::clamp(dot(found->normal, truth[i].normal), -1.0, 1.0)));
        errors.wrongSigns += found->signedDistance * truth[i].signedDistance < 0;
    }
    const auto usual = [](std::vector<double>& values) {
        std::ranges::sort(values);
        return values[values.size() * 99 / 100];
    };
    errors.usualDistance = usual(distances);
    errors.distance = distances.back();
    errors.usualNormal = usual(angles);
    return errors;
}

/// The body as it breathes: no vertex stays.
std::vector<Vec3> breathing(const geometry::TriangleMesh& mesh, int round) {
    std::vector<Vec3> vertices = mesh.vertices;
    for (Vec3& v : vertices) v = v + Vec3{v.x, 0, v.z} * (0.002 * (1 + round % 2));
    return vertices;
}

/// By round [s].
struct Costs {
    std::vector<double> build, move;
    std::vector<std::vector<double>> ask; ///< of each trace
};

void measure(const body::Body& body, const std::vector<Trace>& traces) {
    const auto ways = bench::nearestWays();
    std::vector<std::unique_ptr<bench::NearestWay>> built(ways.size());
    std::vector<Costs> costs(ways.size());
    for (auto& cost : costs) cost.ask.resize(traces.size());
    for (int round = 0; round < 3; ++round)
        for (std::size_t w = 0; w < ways.size(); ++w)
            costs[w].build.push_back(secondsOf([&] { built[w] = ways[w].build(body); }));

    std::vector<std::vector<Ask>> asks;
    for (const Trace& trace : traces) {
        asks.push_back(asksIn(trace, *built[0]));
        fmt::print("\nThe blouse {}: {} particles, of which {:.0f} a substep ask.\n", trace.what, trace.reach.size(),
                   static_cast<double>(asks.back().size()) / static_cast<double>(trace.substeps.size() - 1));
    }
    double sum = 0; // so that no answer is left out
    for (int round = 0; round < rounds; ++round)
        for (std::size_t t = 0; t < traces.size(); ++t)
            for (std::size_t w = 0; w < ways.size(); ++w) {
                costs[w].ask[t].push_back(secondsOf([&] {
                                              for (const Ask& ask : asks[t])
                                                  if (const auto found = built[w]->nearest(ask.point, ask.radius))
                                                      sum += found->signedDistance;
                                          }) /
                                          static_cast<double>(asks[t].size()));
            }

    const auto surface = orStop(collision::BodySurface::create(body.mesh));
    const auto brute = bench::bruteForce(body);
    const collision::WindingNumber winding(body.mesh);
    std::vector<std::vector<Errors>> errors(ways.size());
    for (const bool onlySharp : {false, true}) {
        const auto points = besideSkin(surface, onlySharp, 1500);
        std::vector<Nearest> truth;
        int inside = 0;
        for (const Vec3& p : points) {
            truth.push_back(*brute->nearest(p, 1));
            inside += (truth.back().signedDistance < 0) != (winding.at(p) > 0.5);
        }
        fmt::print("\nOf {} points beside {} {} signs are other than the winding number's.\n", points.size(),
                   onlySharp ? "sharp skin" : "the skin", inside);
        for (std::size_t w = 0; w < ways.size(); ++w) errors[w].push_back(errorsOf(*built[w], points, truth));
    }
    std::vector<std::size_t> bytes; // before a body moves
    for (const auto& way : built) bytes.push_back(way->bytes());
    for (int round = 0; round < 3; ++round)
        for (std::size_t w = 0; w < ways.size(); ++w) {
            const auto vertices = breathing(body.mesh, round);
            costs[w].move.push_back(secondsOf([&] { built[w]->moveTo(vertices); }));
        }

    fmt::print(
        "\n| way | build ms | MB | moved ms | µs an ask, falls | lies | of the first | wrong by mm, 99 % and most "
        "| normal, 99 % | at sharp skin: mm | normal | wrong signs "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t w = 0; w < ways.size(); ++w) {
        const Costs& c = costs[w];
        const double first = median(costs[0].ask[0]) + median(costs[0].ask[1]);
        const double falls = median(c.ask[0]), lies = median(c.ask[1]);
        fmt::print("| {} | {:.0f} | {:.1f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} |", ways[w].name, 1e3 * median(c.build),
                   1e-6 * static_cast<double>(bytes[w]), 1e3 * median(c.move), 1e6 * falls, 1e6 * lies,
                   (falls + lies) / first);
        const auto& [skin, sharp] = std::pair(errors[w][0], errors[w][1]);
        fmt::print(" {:.2g}, {:.2g} | {:.2g}° | {:.2g}, {:.2g} | {:.2g}° | {} |\n", 1e3 * skin.usualDistance,
                   1e3 * skin.distance, 57.2958 * skin.usualNormal, 1e3 * sharp.usualDistance, 1e3 * sharp.distance,
                   57.2958 * sharp.usualNormal, skin.wrongSigns + sharp.wrongSigns);
    }
    if (!std::isfinite(sum)) std::abort();
    std::fflush(stdout);
}

/// What following all particles through a substep takes: by tangent planes and a hierarchy that is asked now and then,
/// as the product does, or by a grid that is asked for every particle that may be near. Then what a broad phase over
/// pieces and limbs takes before any of them, and what it spares.
void follow(const body::Body& body, const std::vector<Trace>& traces) {
    constexpr double reach = 0.0035; // a little more than particles keep [m]
    const auto surface = orStop(collision::BodySurface::create(body.mesh));
    const auto grid = bench::nearestWays().back().build(body);
    fmt::print(
        "\n| the blouse | a substep by `SurfaceTracker`, µs | by the grid of 2.5 mm | FCL's dynamic trees of pieces "
        "and limbs | particles they leave out |\n|---|---|---|---|---|\n");
    for (const Trace& trace : traces) {
        std::vector<double> tracked, looked, sorted;
        double sum = 0, leftOut = 0;
        const auto ofSubsteps = [&](const auto& substep) { // the first is where all is found
            substep(trace.substeps[0]);
            const double seconds = secondsOf([&] {
                for (const auto& positions : std::span(trace.substeps).subspan(1)) substep(positions);
            });
            return 1e6 * seconds / static_cast<double>(trace.substeps.size() - 1);
        };
        for (int round = 0; round < rounds; ++round) {
            collision::SurfaceTracker tracker(surface, trace.reach.size(), planeReach);
            tracked.push_back(ofSubsteps([&](const std::vector<Vec3>& positions) {
                for (std::size_t i = 0; i < positions.size(); ++i)
                    if (const auto* plane = tracker.near(i, positions[i], trace.reach[i]))
                        sum += plane->distance(positions[i]);
            }));
            std::vector<Known> known(trace.reach.size());
            looked.push_back(ofSubsteps([&](const std::vector<Vec3>& positions) {
                for (std::size_t i = 0; i < positions.size(); ++i) {
                    if (known[i].stillFar(positions[i], trace.reach[i])) continue;
                    const auto found = grid->nearest(positions[i], 0);
                    known[i] = {positions[i], found ? found->signedDistance : bench::gridBand};
                    sum += known[i].distance;
                }
            }));
            bench::PieceBoxes boxes(body, trace.piece);
            sorted.push_back(ofSubsteps(
                [&](const std::vector<Vec3>& positions) { leftOut = boxes.farParticles(positions, reach); }));
        }
        if (!std::isfinite(sum)) std::abort();
        fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.1f} % |\n", trace.what, median(tracked), median(looked),
                   median(sorted), 100 * leftOut / static_cast<double>(trace.reach.size()));
    }
}

void compareOn(const std::string& name, simulation::Scene scene) {
    const body::Body body = **scene.body;
    fmt::print("\n{}: {} triangles, {}\n", name, body.mesh.triangles.size(),
               geometry::isClosedManifold(body.mesh) ? "closed" : "open");
    const auto traces = tracesOn(std::move(scene));
    measure(body, traces);
    follow(body, traces);
}

} // namespace

int main(int argc, char** argv) {
    const std::string file = TOILE_SAMPLES "/blouse.toile";
    const auto document = orStop(io::readDocument(file)).document;
    for (int i = 1; i < argc; ++i) compareOn(argv[i], orStop(batch::openScene(document, file, argv[i])).scene);
    if (argc > 1) return 0;
    for (const double edge : {0.0115, 0.0066}) {
        simulation::Scene scene = orStop(batch::openScene(document, file)).scene;
        scene.body = Shared(orStop(body::makeMannequin(samples::blouseWearer(), edge)).body);
        compareOn(fmt::format("mannequin, edges of {:g} mm", 1000 * edge), std::move(scene));
    }
    return 0;
}
