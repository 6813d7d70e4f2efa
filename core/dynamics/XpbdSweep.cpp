// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/XpbdSweep.h"

#include "core/dynamics/Colouring.h"

#include <cmath>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr int lanes = 4, corners = 4;

/// What a part for one thread must hold at least, some 4 µs of work: less costs more to share than it saves.
struct LeastShare {
    int particles, springs, triangles, cells, stencils, hinges; ///< all but particles and stencils in fours
};
constexpr LeastShare leastShare{3000, 300, 40, 20, 600, 20};

double areaOf(const cloth::MembraneTriangle& triangle) {
    return triangle.area;
}
double areaOf(const cloth::MembraneCell& cell) {
    return cell.width * cell.height;
}

/// As bending is: its coefficients sum to 0.
bool isUnmovedByTranslation(std::span<const double> coefficients) {
    double sum = 0, size = 0;
    for (const double c : coefficients) {
        sum += c;
        size += std::abs(c);
    }
    return std::abs(sum) < 1e-9 * size;
}

} // namespace

XpbdSweep::XpbdSweep(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> inverseMass,
                     double h, double cap, const SweepKernels& kernels)
    : model_(model), inverseMass_(inverseMass), h_(h), cap_(cap), kernels_(kernels),
      joints_(model, eliminated, inverseMass, h, cap), places_(model.mass.size() + lanes * corners) {
    for (std::size_t p = 0; p < model.mass.size(); ++p) places_[p].inverseMass = inverseMass[p];
    for (int s = 0; s < lanes * corners; ++s) places_[model.mass.size() + s].x = s;
    compileSprings();
    compileStencils();
    compileTriangles();
    compileCells();
    compileHinges();
}

double XpbdSweep::compliance(double stiffness) const {
    return complianceOf(stiffness, h_);
}

int XpbdSweep::spare(int lane, int corner) const {
    return model_.particleCount() + lane * corners + corner;
}

void XpbdSweep::compileSprings() {
    std::vector<cloth::Spring> springs;
    for (const auto* some : {&model_.structural, &model_.shear, &model_.elastics, &model_.flexion})
        for (const cloth::Spring& s : *some) {
            const std::array ends{s.a, s.b};
            if (s.stiffness <= 0) continue;
            if (joints_.touches(ends)) joints_.add(ends, std::array{-1.0, 1.0}, s.restLength, s.stiffness);
            else if (inverseMass_[s.a] + inverseMass_[s.b] > 0) springs.push_back(s);
        }
    const auto ends = [](const cloth::Spring& s) { return std::array{s.a, s.b}; };
    const ColouredGroups coloured = colouredGroups(springs, model_.particleCount(), lanes, ends);
    borders_.springs = coloured.borders;
    for (const auto& group : coloured.groups) {
        FourSprings& four = springs_.emplace_back();
        for (int lane = 0; lane < lanes; ++lane) {
            four.a[lane] = spare(lane, 0);
            four.b[lane] = spare(lane, 1);
            if (lane >= std::ssize(group)) continue;
            const cloth::Spring& s = springs[group[lane]];
            const double w = inverseMass_[s.a] + inverseMass_[s.b];
            four.a[lane] = s.a;
            four.b[lane] = s.b;
            four.restLength[lane] = s.restLength;
            four.share[lane] = static_cast<float>(1 / (w + std::max(compliance(s.stiffness), w / cap_)));
        }
    }
}

template <int N>
LinearElement<N> XpbdSweep::compiled(const cloth::Stencil& stencil) const {
    LinearElement<N> element;
    double w = 0, last = 0;
    const auto add = [&](int particle, double c) { w += inverseMass_[particle] * c * c; };
    for (int i = 0; i < N; ++i) element.particles[i] = stencil.particles[i];
    for (int i = 0; i < N - 1; ++i) {
        element.coefficients[i] = stencil.coefficients[i];
        last -= element.coefficients[i];
        add(element.particles[i], element.coefficients[i]);
    }
    add(element.particles[N - 1], last);
    if (w > 0) element.share = static_cast<float>(1 / (w + std::max(compliance(stencil.stiffness), w / cap_)));
    return element;
}

void XpbdSweep::compileStencils() {
    std::vector<LinearElement<3>> three;
    std::vector<LinearElement<4>> four;
    for (const auto* stencils : {&model_.bending, &model_.twist})
        for (const cloth::Stencil& s : *stencils) {
            if (s.stiffness <= 0) continue;
            const auto count = std::ranges::count_if(s.particles, [](int p) { return p >= 0; });
            const auto particles = std::span(s.particles).first(count);
            const auto coefficients = std::span(s.coefficients).first(count);
            if (joints_.touches(particles) || count < 3 || !isUnmovedByTranslation(coefficients))
                joints_.add(particles, coefficients, 0, s.stiffness);
            else if (count == 3) three.push_back(compiled<3>(s));
            else four.push_back(compiled<4>(s));
        }
    const auto particles = [](const auto& element) { return element.particles; };
    const auto compile = [&](const auto& elements, std::vector<int>& borders) {
        const std::vector<int> colours = coloursOf(elements, model_.particleCount(), particles);
        borders = bordersOfColours(colours);
        return inOrder(elements, orderByColour(colours));
    };
    threePoint_ = compile(three, borders_.threePoint);
    fourPoint_ = compile(four, borders_.fourPoint);
}

void XpbdSweep::compileTriangles() {
    std::vector<cloth::MembraneTriangle> triangles;
    for (const auto& t : model_.triangles)
        if (!joints_.touches(t.particles)) triangles.push_back(t);
    const auto particles = [](const cloth::MembraneTriangle& t) { return t.particles; };
    const ColouredGroups coloured = colouredGroups(triangles, model_.particleCount(), lanes, particles);
    borders_.triangles = coloured.borders;
    for (const auto& group : coloured.groups) {
        FourTriangles& four = triangles_.emplace_back();
        std::array<Membrane, lanes> membranes;
        for (int lane = 0; lane < lanes; ++lane) {
            for (int c = 0; c < 3; ++c) four.particles[c][lane] = spare(lane, c);
            for (FourNumbers& compliance : four.compliance) compliance[lane] = 1;
            if (lane >= std::ssize(group)) continue;
            const cloth::MembraneTriangle& t = triangles[group[lane]];
            membranes[lane] = {areaOf(t), t.stiffness, t.tension};
            const Membrane::Slack slack = membranes[lane].slack(h_);
            for (int c = 0; c < 3; ++c) four.particles[c][lane] = t.particles[c];
            for (int c = 0; c < 4; ++c) four.inverseRest[c][lane] = t.inverseRest[c];
            four.coupling[lane] = slack.coupling;
            for (int c = 0; c < 2; ++c) four.compliance[c][lane] = slack.compliance[c];
            four.compliance[2][lane] = compliance(areaOf(t) * t.stiffness.c33);
        }
        curvedTriangles_.add(membranes, model_.tensionCurves);
    }
    if (curvedTriangles_.areLinear()) curvedTriangles_ = {};
}

void XpbdSweep::compileCells() {
    std::vector<cloth::MembraneCell> cells;
    for (const auto& c : model_.cells)
        if (!joints_.touches(c.particles)) cells.push_back(c);
    const auto particles = [](const cloth::MembraneCell& c) { return c.particles; };
    const ColouredGroups coloured = colouredGroups(cells, model_.particleCount(), lanes, particles);
    borders_.cells = coloured.borders;
    for (const auto& group : coloured.groups) {
        FourCells& four = cells_.emplace_back();
        std::array<Membrane, lanes> membranes;
        for (int lane = 0; lane < lanes; ++lane) {
            for (int c = 0; c < 4; ++c) four.particles[c][lane] = spare(lane, c);
            for (FourNumbers& compliance : four.compliance) compliance[lane] = 1;
            if (lane >= std::ssize(group)) continue;
            const cloth::MembraneCell& cell = cells[group[lane]];
            membranes[lane] = {areaOf(cell), cell.stiffness, cell.tension};
            const Membrane::Slack slack = membranes[lane].slack(h_);
            for (int c = 0; c < 4; ++c) four.particles[c][lane] = cell.particles[c];
            four.perWidth[lane] = 1 / cell.width;
            four.perHeight[lane] = 1 / cell.height;
            four.coupling[lane] = slack.coupling;
            for (int c = 0; c < 4; ++c) four.compliance[c][lane] = slack.compliance[c];
            four.compliance[4][lane] = compliance(areaOf(cell) * cell.stiffness.c33);
        }
        curvedCells_.add(membranes, model_.tensionCurves);
    }
    if (curvedCells_.areLinear()) curvedCells_ = {};
}

void XpbdSweep::compileHinges() {
    std::vector<cloth::Hinge> hinges;
    for (const auto& h : model_.hinges)
        if (h.stiffness > 0 && !joints_.touches(cornersOf(h))) hinges.push_back(h);
    const auto particles = [](const cloth::Hinge& h) { return cornersOf(h); };
    const ColouredGroups coloured = colouredGroups(hinges, model_.particleCount(), lanes, particles);
    borders_.hinges = coloured.borders;
    for (const auto& group : coloured.groups) {
        FourHinges& four = hinges_.emplace_back();
        for (int lane = 0; lane < lanes; ++lane) {
            for (int c = 0; c < 4; ++c) four.particles[c][lane] = spare(lane, c);
            four.compliance[lane] = 1;
            if (lane >= std::ssize(group)) continue;
            const cloth::Hinge& h = hinges[group[lane]];
            for (int c = 0; c < 4; ++c) four.particles[c][lane] = cornersOf(h)[c];
            four.restAngle[lane] = h.restAngle;
            four.compliance[lane] = compliance(h.stiffness);
        }
    }
}

void XpbdSweep::apply(std::span<Vec3> positions, Team* team) {
    const int particles = static_cast<int>(positions.size());
    const auto part = [](const auto& elements, int begin, int end) {
        return std::span(elements).subspan(begin, end - begin);
    };
    Place* const places = places_.data();
    const TensionLaw triangleLaw = curvedTriangles_.law(h_), cellLaw = curvedCells_.law(h_);
    inParts(team, particles, leastShare.particles, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) static_cast<Vec3&>(places_[p]) = positions[p];
    });
    byColours(team, borders_.springs, leastShare.springs,
              [&](int begin, int end) { kernels_.springs(places, part(springs_, begin, end)); });
    byColours(team, borders_.triangles, leastShare.triangles, [&](int begin, int end) {
        kernels_.triangles(places, part(triangles_, begin, end), cap_, triangleLaw, begin);
    });
    byColours(team, borders_.cells, leastShare.cells,
              [&](int begin, int end) { kernels_.cells(places, part(cells_, begin, end), cap_, cellLaw, begin); });
    byColours(team, borders_.threePoint, leastShare.stencils,
              [&](int begin, int end) { kernels_.threePoint(places, part(threePoint_, begin, end)); });
    byColours(team, borders_.fourPoint, leastShare.stencils,
              [&](int begin, int end) { kernels_.fourPoint(places, part(fourPoint_, begin, end)); });
    joints_.apply(places_);
    byColours(team, borders_.hinges, leastShare.hinges,
              [&](int begin, int end) { kernels_.hinges(places, part(hinges_, begin, end), cap_); });
    inParts(team, particles, leastShare.particles, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) positions[p] = places_[p];
    });
}

std::size_t XpbdSweep::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return of(places_) + of(springs_) + of(threePoint_) + of(fourPoint_) + of(triangles_) + of(cells_) + of(hinges_) +
           curvedTriangles_.bytes() + curvedCells_.bytes() + joints_.bytes();
}

} // namespace toile::dynamics
