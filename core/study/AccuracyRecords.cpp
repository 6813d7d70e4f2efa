// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/AccuracyRecords.h"

#include "core/base/Contracts.h"
#include "core/study/Repetitions.h"

#include <cmath>

namespace toile::study {
namespace {

using dynamics::Method;

constexpr const char *done = "done", *unsolved = "not solved"; ///< status of runs that came to their end

Json sceneOf(const Scene& scene) {
    const auto& model = scene.model;
    Json json, springs;
    springs.set("structural", model.structural.size()).set("shear", model.shear.size());
    springs.set("bending", model.bending.size()).set("twist", model.twist.size());
    json.set("name", scene.name).set("particles", model.particleCount()).set("springs", springs);
    json.set("stiffness", scene.stiffness).set("duration", scene.duration);
    return json.set("explicitStepLimit", stepLimitOf(scene, Method::symplecticEuler));
}

double stepOf(const Scene& scene, const Setup& setup) {
    return scene.duration / (setup.steps * setup.substeps);
}

Json methodOf(const Scene& scene, const Setup& setup) {
    Json json;
    json.set("integrator", std::string(dynamics::nameOf(setup.method))).set("step", stepOf(scene, setup));
    return json.set("substeps", setup.substeps).set("tolerance", setup.tolerance).set("threads", 1);
}

Json referenceOf(const CaseResult& result) {
    Json json;
    json.set("method", std::string(dynamics::nameOf(result.reference.setup.method)));
    json.set("step", stepOf(result.scene, result.reference.setup));
    return json.set("selfError", result.reference.selfError);
}

Json outcomeOf(const RunResult& run) {
    Json json;
    if (run.failure.empty())
        json.set("rmsError", run.error.rms).set("maximumError", run.error.maximum).set("inBand", run.inBand);
    return json.set("energyRelativeChange", run.energyChange);
}

Json costOf(const RunResult& run) {
    Json json;
    json.set("cpuSecondsMinimum", run.secondsLeast).set("cpuSecondsMedian", run.secondsMedian);
    if (run.noisy) json.set("noisy", true);
    json.set("parts", run.report.parts).set("newtonIterations", run.report.newtonIterations);
    json.set("solves", run.report.factorizations).set("cgIterations", run.report.gradientIterations);
    return json.set("rejectedSteps", run.report.repeated);
}

/// 0 where there is none.
double number(const Json& record, const char* group, const char* key) {
    const Json* members = record.find(group);
    const Json* value = members ? members->find(key) : nullptr;
    return value && value->asNumber() ? *value->asNumber() : 0;
}

int count(const Json& record, const char* key) {
    return static_cast<int>(number(record, "cost", key));
}

RunResult runFrom(const Scene& scene, const Setup& setup, const Json& record) {
    RunResult run{.setup = setup, .step = stepOf(scene, setup)};
    const Json* status = record.find("status");
    expects(status && status->asString(), "a record has a status");
    run.solved = *status->asString() == done;
    if (!run.solved && *status->asString() != unsolved) run.failure = *status->asString();
    run.error = {number(record, "result", "rmsError"), number(record, "result", "maximumError")};
    if (const Json* inBand = record.find("result")->find("inBand"); inBand && inBand->asBool())
        run.inBand = *inBand->asBool();
    run.energyChange = number(record, "result", "energyRelativeChange");
    run.secondsLeast = number(record, "cost", "cpuSecondsMinimum");
    run.secondsMedian = number(record, "cost", "cpuSecondsMedian");
    run.noisy = isNoisy(run.secondsLeast * scene.duration, run.secondsMedian * scene.duration);
    run.report.parts = count(record, "parts");
    run.report.newtonIterations = count(record, "newtonIterations");
    run.report.factorizations = count(record, "solves");
    run.report.gradientIterations = count(record, "cgIterations");
    run.report.repeated = count(record, "rejectedSteps");
    return run;
}

} // namespace

std::vector<Json> recordsOf(const CaseResult& result, const Circumstances& circumstances) {
    const Json scene = sceneOf(result.scene), reference = referenceOf(result);
    std::vector<Json> records;
    for (const RunResult& run : result.runs) {
        Json record;
        note(record, "toile-study-1", circumstances);
        record.set("scene", scene).set("method", methodOf(result.scene, run.setup)).set("reference", reference);
        record.set("result", outcomeOf(run)).set("cost", costOf(run));
        record.set("status", !run.failure.empty() ? run.failure : run.solved ? done : unsolved);
        records.push_back(std::move(record));
    }
    return records;
}

std::vector<Json> keysOf(const AccuracyCase& which) {
    const auto scene = sceneNamed(which.scene, which.settings);
    expects(scene.has_value(), "a case has a scene");
    const Json sceneKey = sceneOf(*scene);
    std::vector<Json> keys;
    for (const Setup& setup : which.setups) {
        Json key;
        keys.push_back(key.set("scene", sceneKey).set("method", methodOf(*scene, setup)));
    }
    return keys;
}

CaseResult resultFrom(const AccuracyCase& which, const std::vector<Json>& records) {
    expects(!records.empty() && records.size() == which.setups.size(), "a record for each setup");
    CaseResult result{.scene = *sceneNamed(which.scene, which.settings),
                      .cells = which.settings.cells,
                      .stiffnessFactor = which.settings.stiffnessFactor};
    const Json& first = records.front();
    if (const Json* reference = first.find("reference"); reference && reference->find("method")->asString())
        result.reference.setup.method =
            dynamics::methodNamed(*reference->find("method")->asString()).value_or(Method::rk4);
    result.reference.setup.steps =
        static_cast<int>(std::lround(result.scene.duration / number(first, "reference", "step")));
    result.reference.selfError = number(first, "reference", "selfError");
    for (std::size_t i = 0; i < records.size(); ++i)
        result.runs.push_back(runFrom(result.scene, which.setups[i], records[i]));
    return result;
}

} // namespace toile::study
