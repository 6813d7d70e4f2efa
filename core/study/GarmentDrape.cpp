// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/GarmentDrape.h"

#include "core/cloth/Forces.h"
#include "core/simulation/Sew.h"
#include "core/study/Calibration.h"
#include "core/study/EachPiece.h"
#include "core/study/ReadBack.h"

#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace toile::study {
namespace {

/// Cloth without seams starts somewhere else instead: so far to the side for twice their time [m].
constexpr double perSeamTime = 0.1;

pattern::Pattern shifted(pattern::Pattern pattern, double sideways) {
    return eachPiece(std::move(pattern), [sideways](pattern::Piece& piece) {
        if (piece.placement) piece.placement->transform.origin.x += sideways;
    });
}

simulation::Scene sceneOf(const simulation::Scene& scene, const GarmentSetup& setup, double seamTime) {
    simulation::Scene changed = scene;
    changed.pattern =
        setup.regions ? coarser(scene.pattern, setup.factor) : uniformCoarser(scene.pattern, setup.factor);
    changed.settings.seamTime *= seamTime;
    if (changed.pattern.seams.empty())
        changed.pattern = shifted(std::move(changed.pattern), (seamTime - 1) * perSeamTime);
    return changed;
}

/// A go's own stop: the caller's, or the end of its budget.
class Budget {
public:
    Budget(double seconds, std::stop_token outer)
        : seconds_(seconds), forward_(outer, [this] { source_.request_stop(); }) {}
    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
    [[nodiscard]] bool isSpent() const { return spent_; }
    [[nodiscard]] double used() const { return threadSeconds() - start_; }
    /// Looks at the clock whenever the run says how far it is.
    [[nodiscard]] Progress watch() {
        return [this](double, const std::string&) {
            if (used() < seconds_) return;
            spent_ = true;
            source_.request_stop();
        };
    }

private:
    double seconds_, start_ = threadSeconds();
    bool spent_ = false;
    std::stop_source source_;
    std::stop_callback<std::function<void()>> forward_;
};

std::string statusOf(const simulation::SewReport& report, bool finished) {
    if (!report.allClosed()) return "seams are open";
    if (!report.contact.outsideBody) return "cloth is in the body";
    if (report.ending != "at rest") return "not at rest: " + report.ending;
    return finished && !report.atRest ? "no equilibrium found" : "";
}

Json sceneFacts(const simulation::Simulation& simulation, const simulation::SewReport& report) {
    Json scene, springs;
    springs.set("structural", report.springsStructural).set("shear", report.springsShear);
    springs.set("flexion", report.flexion).set("bending", report.bending).set("twist", report.twist);
    scene.set("hash", report.resultHash).set("particles", report.particles).set("springs", springs);
    const double frequency =
        std::sqrt(cloth::largestFrequencySquared(simulation.garment().model, simulation.state().positions));
    return scene.set("largestFrequency", frequency).set("explicitStepLimit", 2 / frequency);
}

Json resultFacts(const simulation::SewReport& report) {
    double gap = 0;
    for (const auto& seam : report.seams) gap = std::max(gap, seam.gap.maximum);
    Json result;
    result.set("strainRms", report.strain.rms).set("seamGap", gap);
    result.set("intersections", report.contact.bodyIntersections + report.contact.selfIntersections);
    return result.set("penetration", report.contact.bodyPenetrationMaximum);
}

Json costFacts(const simulation::SewReport& report) {
    dynamics::StepReport steps{.parts = 0};
    for (const simulation::PhaseRun& phase : report.phases) steps += phase.steps;
    Json cost;
    cost.set("wallSeconds", report.wallSeconds).set("parts", steps.parts);
    cost.set("newtonIterations", steps.newtonIterations).set("solves", steps.factorizations);
    cost.set("cgIterations", steps.gradientIterations).set("rejectedSteps", steps.repeated);
    return cost.set("simulatedSeconds", report.simulatedSeconds).set("peakBytes", report.peakBytes);
}

Json leftOutFacts(const simulation::SewReport& report) {
    Json all{Json::Array{}};
    for (const auto& leftOut : report.leftOut) {
        Json one;
        one.set("name", leftOut.stage).set("reason", leftOut.why);
        all.push(one);
    }
    return all;
}

GarmentDrape lookedAt(const simulation::Simulation& simulation, const simulation::SewReport& report, bool finished,
                      double seconds) {
    GarmentDrape drape{.status = statusOf(report, finished), .quantities = quantitiesOf(simulation)};
    drape.seconds = seconds;
    drape.particles = report.particles;
    drape.simulatedSeconds = report.simulatedSeconds;
    Json method;
    method.set("steps", report.steps).set("substeps", report.substeps).set("threads", 1);
    drape.facts.set("scene", sceneFacts(simulation, report)).set("method", method);
    drape.facts.set("result", resultFacts(report)).set("cost", costFacts(report));
    drape.facts.set("leftOut", leftOutFacts(report));
    return drape;
}

Result<GarmentGo> goWithin(Budget& budget, const simulation::Scene& scene, const GarmentSetup& setup, double seamTime) {
    const Progress watch = budget.watch();
    auto simulation = simulation::Simulation::create(sceneOf(scene, setup, seamTime));
    if (!simulation) return tl::unexpected(simulation.error());
    simulation->drapeWith(setup.method);
    auto report = simulation::sew(*simulation, {.hold = 0, .finish = false}, budget.token(), watch);
    if (!report) return tl::unexpected(report.error());
    const double restSeconds = budget.used();
    GarmentGo go;
    if (setup.method) go.atRest = lookedAt(*simulation, *report, false, restSeconds);

    const double start = budget.used();
    report = simulation::sew(*simulation, {.hold = 0}, budget.token(), watch);
    if (!report) return tl::unexpected(report.error());
    go.finished = lookedAt(*simulation, *report, true, restSeconds + budget.used() - start);
    return go;
}

Json toJson(const GarmentDrape& drape) {
    Json json, quantities{Json::Object{}}, absent{Json::Object{}};
    for (const Quantity& quantity : drape.quantities)
        if (quantity.value) quantities.set(std::string(quantity.key), *quantity.value);
        else absent.set(std::string(quantity.key), quantity.whyAbsent);
    json.set("status", drape.status).set("quantities", quantities).set("absent", absent);
    json.set("cpuSeconds", drape.seconds).set("particles", drape.particles);
    return json.set("simulatedSeconds", drape.simulatedSeconds).set("facts", drape.facts);
}

std::optional<GarmentDrape> drapeFrom(const Json& json) {
    const auto* status = memberOf(json, "status", &Json::asString);
    const auto* seconds = memberOf(json, "cpuSeconds", &Json::asNumber);
    const auto* particles = memberOf(json, "particles", &Json::asNumber);
    const auto* simulated = memberOf(json, "simulatedSeconds", &Json::asNumber);
    const Json *quantities = json.find("quantities"), *absent = json.find("absent"), *facts = json.find("facts");
    if (!status || !seconds || !particles || !simulated || !quantities || !absent || !facts) return std::nullopt;
    GarmentDrape drape{.status = *status, .quantities = noQuantities(), .seconds = *seconds};
    drape.particles = static_cast<int>(*particles);
    drape.simulatedSeconds = *simulated;
    drape.facts = *facts;
    for (Quantity& quantity : drape.quantities) {
        const std::string key(quantity.key);
        if (const auto* value = memberOf(*quantities, key.c_str(), &Json::asNumber)) quantity.value = *value;
        else if (const auto* why = memberOf(*absent, key.c_str(), &Json::asString)) quantity.whyAbsent = *why;
        else return std::nullopt;
    }
    return drape;
}

} // namespace

std::string_view methodOf(const GarmentSetup& setup) {
    return setup.method ? dynamics::nameOf(*setup.method) : "static";
}

std::string_view layoutOf(const GarmentSetup& setup) {
    return setup.regions ? "as drawn" : "uniform";
}

Result<GarmentGo> drapedBy(const simulation::Scene& scene, const GarmentSetup& setup, double seamTime, double seconds,
                           std::stop_token stop) {
    Budget budget(seconds, stop);
    auto go = goWithin(budget, scene, setup, seamTime);
    if (go || !budget.isSpent()) return go;
    return GarmentGo{.failure = fmt::format("it was given up after {:g} s of CPU time", seconds)};
}

Json toJson(const GarmentGo& go) {
    Json json;
    json.set("failure", go.failure);
    if (go.atRest) json.set("atRest", toJson(*go.atRest));
    if (go.finished) json.set("finished", toJson(*go.finished));
    return json;
}

std::optional<GarmentGo> goFrom(const Json& json) {
    const auto* failure = memberOf(json, "failure", &Json::asString);
    if (!failure) return std::nullopt;
    GarmentGo go{.failure = *failure};
    if (const Json* atRest = json.find("atRest"))
        if (go.atRest = drapeFrom(*atRest); !go.atRest) return std::nullopt;
    if (const Json* finished = json.find("finished"))
        if (go.finished = drapeFrom(*finished); !go.finished) return std::nullopt;
    if (go.failure.empty() && !go.finished) return std::nullopt;
    return go;
}

} // namespace toile::study
