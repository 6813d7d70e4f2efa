// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/MeshInputs.h"
#include "core/meshing/GarmentMesher.h"
#include "core/pattern/PatternContours.h"
#include "core/simulation/Garment.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <malloc.h>

/// Times of the mesher on one piece, which takes one core, without the measuring for its report. `hash` tells
/// a faster wrong answer from a right one; `calibrated` is the time divided by that of a million spring
/// forces.
namespace toile::bench {
namespace {

/// FNV-1a over the bits of all places and corners.
std::uint64_t hashOf(const meshing::PieceMesh& mesh) {
    std::uint64_t hash = 14695981039346656037ULL;
    const auto add = [&](const auto& values) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        for (std::size_t i = 0; i < values.size() * sizeof(values[0]); ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
    };
    add(mesh.nodes);
    add(mesh.display);
    return hash;
}

double calibration() {
    static const double seconds = study::calibrationSeconds();
    return seconds;
}

/// The share of rectangles if every side of the border that is none of a rectangle's had one element of its own: few
/// elements can have two.
double mostRectangles(const meshing::GarmentMesh& mesh) {
    std::size_t rectangles = 0, others = 0;
    for (const meshing::PieceMesh& piece : mesh.pieces) {
        std::vector<int> after(piece.nodes.size(), -1); // of each node of the border, the next one
        for (const auto& loop : piece.loops)
            for (const meshing::EdgeNodes& edge : loop)
                for (std::size_t i = 0; i + 1 < edge.size(); ++i)
                    after[static_cast<std::size_t>(edge[i].node)] = edge[i + 1].node;
        others += piece.nodes.size() - static_cast<std::size_t>(std::count(after.begin(), after.end(), -1));
        for (const meshing::Rectangle& rectangle : piece.rectangles)
            for (std::size_t i = 0; i < 4; ++i) {
                const int from = rectangle.nodes[i], to = rectangle.nodes[(i + 1) % 4];
                others -= after[static_cast<std::size_t>(from)] == to || after[static_cast<std::size_t>(to)] == from;
            }
        rectangles += piece.rectangles.size();
    }
    return static_cast<double>(rectangles) / static_cast<double>(rectangles + others);
}

void report(benchmark::State& state, const meshing::GarmentMesh& mesh, double seconds) {
    const auto& piece = mesh.report.total;
    state.counters["cells"] = piece.quads + piece.triangles;
    state.counters["rectangles%"] = 100 * piece.rectangleFraction;
    state.counters["most%"] = 100 * mostRectangles(mesh);
    state.counters["angle°"] = piece.minimumAngle * 57.29577951308232;
    state.counters["bytes"] = static_cast<double>(piece.bytes);
    state.counters["calibrated"] = seconds / static_cast<double>(state.iterations()) / calibration();
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(hashOf(mesh.pieces[0])));
    state.SetLabel(hash);
}

/// Meshes the same piece anew, in the memory of the time before; or, cold, in what the system gives.
void meshBlouseBack(benchmark::State& state, bool cold) {
    const meshing::MeshInput input = blouseBack(1e-6 * static_cast<double>(state.range(0)));
    meshing::GarmentMesher mesher({.judged = false});
    if (!mesher.mesh(input)) std::abort();
    double seconds = 0;
    for (auto _ : state) {
        if (cold) {
            mesher = meshing::GarmentMesher({.judged = false});
            malloc_trim(0);
        }
        mesher.forget();
        const double start = study::threadSeconds();
        if (!mesher.mesh(input)) std::abort();
        const double used = study::threadSeconds() - start;
        state.SetIterationTime(used);
        seconds += used;
    }
    report(state, *meshing::meshGarment(input), seconds);
}

void blouseBackWarm(benchmark::State& state) {
    meshBlouseBack(state, false);
}

void blouseBackCold(benchmark::State& state) {
    meshBlouseBack(state, true);
}

/// CPU time of all threads [s].
double processSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The whole blouse with its regions and seams, again and again while the front's neckline is dragged up and down at
/// the centre, and with it that of its mirror image. With a memory only what that touches is meshed. The time is that
/// of all cores; `waited_ms` is the least until the mesh is there.
void blouseVertexMoved(benchmark::State& state, bool remembers) {
    std::vector<meshing::MeshInput> inputs;
    for (const double by : {0.0, 0.004}) {
        const auto moved = pattern::moveVertex(sample("blouse"), pattern::PieceId("front-left"),
                                               pattern::VertexId("front-left.neck-centre"), Vec2{0, -0.08 - by});
        if (!moved) std::abort();
        auto input = simulation::meshInputOf(*moved, {.spacing = 1e-6 * static_cast<double>(state.range(0))});
        if (!input) std::abort();
        inputs.push_back(std::move(*input));
    }
    meshing::GarmentMesher mesher({.judged = false});
    double pieces = 0, waited = 1e9; // [s]
    std::size_t next = 0;
    for (auto _ : state) {
        next = 1 - next;
        const auto begin = std::chrono::steady_clock::now();
        const double start = processSeconds();
        if (!remembers) mesher = meshing::GarmentMesher({.judged = false});
        if (!mesher.mesh(inputs[next])) std::abort();
        state.SetIterationTime(processSeconds() - start);
        waited = std::min(waited, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        pieces += mesher.work().meshedPieces;
    }
    state.counters["pieces"] = pieces / static_cast<double>(state.iterations());
    state.counters["waited_ms"] = 1000 * waited;
}

void blouseVertexMovedRemembering(benchmark::State& state) {
    blouseVertexMoved(state, true);
}

void blouseVertexMovedAnew(benchmark::State& state) {
    blouseVertexMoved(state, false);
}

/// A square of a million cells, a quarter of it at half the spacing; then its cloth.
pattern::Pattern millionCells() {
    pattern::Pattern pattern = sample("tablecloth");
    pattern::Piece piece = *pattern.pieces.front();
    Vec2 low{1e9, 1e9}, high{-1e9, -1e9};
    for (std::size_t i = 0; i < piece.outline.edges.size(); ++i) {
        const Vec2 p = pattern::curveOf(piece.outline, i).start;
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Vec2 size = high - low;
    piece.spacing = size.x / 756; // 756² · (¾ + ¼ · 4) = 1.0e6
    pattern::Region region;
    region.id.value = "quarter";
    region.outline = {low, low + Vec2{size.x / 2, 0}, low + size * 0.5, low + Vec2{0, size.y / 2}};
    region.refinement = 1;
    piece.regions = {region};
    pattern.pieces = {piece};
    return pattern;
}

void millionCellsMeshed(benchmark::State& state) {
    const auto input = simulation::meshInputOf(millionCells());
    meshing::GarmentMesher mesher({.judged = false});
    if (!mesher.mesh(*input)) std::abort();
    double seconds = 0;
    for (auto _ : state) {
        mesher.forget();
        const double start = study::threadSeconds();
        if (!mesher.mesh(*input)) std::abort();
        state.SetIterationTime(study::threadSeconds() - start);
        seconds += study::threadSeconds() - start;
    }
    report(state, *meshing::meshGarment(*input), seconds);
}

template <class T>
double bytesOf(const std::vector<T>& values) {
    return static_cast<double>(values.size() * sizeof(T));
}

void millionCellsWithElements(benchmark::State& state) {
    const pattern::Pattern pattern = millionCells();
    const auto input = simulation::meshInputOf(pattern);
    double seconds = 0, bytes = 0;
    for (auto _ : state) {
        const double start = study::threadSeconds();
        auto mesh = meshing::meshGarment(*input, {.judged = false});
        const double meshBytes = static_cast<double>(mesh->report.total.bytes);
        const auto garment = simulation::makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {});
        const double used = study::threadSeconds() - start;
        if (!garment) std::abort();
        bytes =
            meshBytes + static_cast<double>(cloth::bytesOf(garment->model)) + bytesOf(garment->particles.particleOf);
        state.SetIterationTime(used);
        seconds += used;
    }
    state.counters["bytes"] = bytes;
    state.counters["calibrated"] = seconds / static_cast<double>(state.iterations()) / calibration();
}

/// As many bytes as a mesh has, written once more: no mesher that writes as memset does can be faster.
void memoryWritten(benchmark::State& state) {
    std::vector<char> memory(static_cast<std::size_t>(state.range(0)) * 1000000, 1);
    for (auto _ : state) {
        const double start = study::threadSeconds();
        std::memset(memory.data(), 2, memory.size());
        benchmark::DoNotOptimize(memory.data());
        benchmark::ClobberMemory();
        state.SetIterationTime(study::threadSeconds() - start);
    }
}

void spacings(benchmark::internal::Benchmark* bench) {
    for (const int micrometres : {20000, 10000, 5000, 2000, 1000, 250}) bench->Arg(micrometres);
    bench->Unit(benchmark::kMillisecond)->UseManualTime()->ArgName("um");
}
BENCHMARK(memoryWritten)
    ->Arg(6)
    ->Arg(23)
    ->Arg(76)
    ->Arg(368)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->ArgName("MB");
BENCHMARK(blouseBackWarm)->Apply(spacings);
BENCHMARK(blouseBackCold)->Apply(spacings);
BENCHMARK(blouseVertexMovedRemembering)->Arg(20000)->Arg(5000)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(blouseVertexMovedAnew)->Arg(20000)->Arg(5000)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(millionCellsMeshed)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(millionCellsWithElements)->Unit(benchmark::kMillisecond)->UseManualTime();

} // namespace
} // namespace toile::bench
