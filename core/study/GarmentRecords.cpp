// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/GarmentRecords.h"

namespace toile::study {
namespace {

/// What a drape knows of one member of its record.
Json factsOf(const GarmentRun& run, const char* member) {
    const Json* facts = run.drape.facts.find(member);
    return facts ? *facts : Json{Json::Object{}};
}

Json sceneOf(const GarmentAccuracy& study, const GarmentSetup& setup, Json facts) {
    Json scene;
    scene.set("name", study.name).set("layout", std::string(layoutOf(setup)));
    scene.set("spacing", setup.factor * study.mainSpacing);
    for (const auto& [key, value] : *facts.asObject()) scene.set(key, value);
    return scene;
}

Json methodJson(const GarmentRun& run) {
    Json method;
    method.set("integrator", std::string(methodOf(run.setup))).set("finished", run.finished);
    const Json facts = factsOf(run, "method");
    for (const auto& [key, value] : *facts.asObject()) method.set(key, value);
    return method;
}

Json referenceJson(const GarmentReference& reference) {
    Json json, floors{Json::Object{}};
    for (std::size_t q = 0; q < reference.mean.size(); ++q)
        if (reference.mean[q].value) floors.set(std::string(reference.mean[q].key), reference.floor[q]);
    json.set("method", "xpbd, finished").set("layout", "uniform").set("spacing", reference.spacing);
    json.set("particles", reference.particles).set("runs", reference.runs).set("selfError", reference.band);
    return json.set("floors", floors);
}

Json resultJson(const GarmentRun& run) {
    Json result = factsOf(run, "result"), quantities{Json::Object{}}, errors{Json::Object{}}, absent{Json::Object{}};
    for (std::size_t q = 0; q < run.drape.quantities.size(); ++q) {
        const Quantity& quantity = run.drape.quantities[q];
        const std::string key(quantity.key);
        quantities.set(key, quantity.value ? Json(*quantity.value) : Json());
        if (!quantity.value) absent.set(key, quantity.whyAbsent);
        if (run.errors[q]) errors.set(key, *run.errors[q]);
    }
    result.set("normalisedError", run.score).set("lengthError", run.lengthError).set("quantities", quantities);
    return result.set("errors", errors).set("absent", absent);
}

Json costJson(const GarmentRun& run) {
    Json cost = factsOf(run, "cost");
    cost.set("cpuSecondsMinimum", run.time.least).set("cpuSecondsMedian", run.time.median);
    return cost.set("repetitions", run.repetitions);
}

} // namespace

std::vector<Json> recordsOf(const GarmentAccuracy& study, const Circumstances& circumstances) {
    std::vector<Json> records;
    for (const GarmentRun& run : study.runs) {
        Json record;
        note(record, "toile-study-garment-1", circumstances);
        record.set("scene", sceneOf(study, run.setup, factsOf(run, "scene"))).set("method", methodJson(run));
        record.set("reference", referenceJson(study.reference)).set("result", resultJson(run));
        record.set("cost", costJson(run)).set("leftOut", factsOf(run, "leftOut"));
        record.set("status", run.drape.status.empty() ? "done" : run.drape.status);
        records.push_back(std::move(record));
    }
    for (const NotRunSetup& setup : study.notRun) {
        Json record, method;
        note(record, "toile-study-garment-1", circumstances);
        method.set("integrator", std::string(methodOf(setup.setup)));
        record.set("scene", sceneOf(study, setup.setup, Json{Json::Object{}}));
        record.set("method", method).set("status", setup.why);
        records.push_back(std::move(record));
    }
    return records;
}

} // namespace toile::study
