// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/lean/Records.h"

#include "core/base/Contracts.h"

namespace toile::study::lean {
namespace {

Json sceneRecord(const std::string& feature, const std::string& variant, const SceneHashes& hashes) {
    Json json;
    json.set("name", feature).set("variant", variant);
    return json.set("hash", hashes.scene).set("start", hashes.start);
}

Json methodOf(Role role, int frames, bool counted) {
    Json json;
    return json.set("role", std::string(nameOf(role))).set("frames", frames).set("counted", counted);
}

Json recordOf(const FeatureResult& result, const Row& row) {
    const Taken& taken = row.taken;
    Json outcome, cost, building, record, stages{Json::Array{}};
    for (const std::string& stage : taken.stages) stages.push(stage);
    outcome.set("stages", std::move(stages)).set("resultHash", taken.hash).set("partIsThere", taken.partIsThere);
    if (row.difference) outcome.set("difference", *row.difference);
    cost.set("particles", taken.particles).set("substeps", taken.substeps).set("stageObjects", taken.stages.size());
    cost.set("partBytes", taken.partBytes).set("steppingBlocks", taken.stepping.blocks);
    cost.set("steppingBytes", taken.stepping.bytes);
    building.set("blocks", taken.building.blocks).set("bytes", taken.building.bytes);
    cost.set("cpuSecondsMinimum", taken.frame.least).set("cpuSecondsMedian", taken.frame.median);
    if (taken.frame.noisy) cost.set("noisy", true);
    if (taken.instructions) cost.set("instructions", *taken.instructions);
    record.set("scene", sceneRecord(result.name, row.what, taken.hashes))
        .set("method", methodOf(row.role, taken.frames, taken.instructions.has_value()));
    record.set("result", outcome)
        .set("cost", cost)
        .set("building", building)
        .set("verdict", row.why.empty() ? "PASS" : "FAIL");
    if (!row.why.empty()) record.set("reason", row.why);
    return record;
}

/// A member of a group of a record that we wrote.
const Json* at(const Json& record, const char* group, const char* key) {
    const Json* members = record.find(group);
    return members ? members->find(key) : nullptr;
}

double number(const Json& record, const char* key, const char* group = "cost") {
    const Json* value = at(record, group, key);
    return value && value->asNumber() ? *value->asNumber() : 0;
}

std::size_t count(const Json& record, const char* key, const char* group = "cost") {
    return static_cast<std::size_t>(number(record, key, group));
}

Row rowFrom(const Variant& variant, int frames, const Json& record) {
    Row row{variant.role, variant.what};
    Taken& taken = row.taken;
    taken.frames = frames;
    taken.particles = static_cast<int>(number(record, "particles"));
    taken.substeps = static_cast<int>(number(record, "substeps"));
    if (const Json* stages = at(record, "result", "stages"); stages && stages->asArray())
        for (const Json& stage : *stages->asArray()) taken.stages.push_back(*stage.asString());
    if (const Json* there = at(record, "result", "partIsThere"); there && there->asBool())
        taken.partIsThere = *there->asBool();
    taken.partBytes = count(record, "partBytes");
    taken.building = {count(record, "blocks", "building"), count(record, "bytes", "building")};
    taken.stepping = {count(record, "steppingBlocks"), count(record, "steppingBytes")};
    const double least = number(record, "cpuSecondsMinimum"), median = number(record, "cpuSecondsMedian");
    taken.frame = {least, median, isNoisy(least * frames, median * frames)};
    if (at(record, "cost", "instructions")) taken.instructions = number(record, "instructions");
    taken.hash = *at(record, "result", "resultHash")->asString();
    taken.hashes = {*at(record, "scene", "hash")->asString(), *at(record, "scene", "start")->asString()};
    if (const Json* difference = at(record, "result", "difference"); difference && difference->asNumber())
        row.difference = *difference->asNumber();
    if (const Json* reason = record.find("reason"); reason && reason->asString()) row.why = *reason->asString();
    return row;
}

} // namespace

std::vector<Json> recordsOf(const FeatureResult& result, const Circumstances& circumstances) {
    std::vector<Json> records;
    for (const Row& row : result.rows) {
        records.push_back(recordOf(result, row));
        note(records.back(), "toile-lean-1", circumstances);
    }
    return records;
}

std::vector<Json> keysOf(const Feature& feature, const LeanSettings& settings) {
    std::vector<Json> keys;
    for (const Variant& variant : feature.variants) {
        const auto hashes = hashesOf(variant.scene);
        if (!hashes) return {};
        Json key;
        keys.push_back(key.set("scene", sceneRecord(feature.name, variant.what, *hashes))
                           .set("method", methodOf(variant.role, settings.frames, settings.counted)));
    }
    return keys;
}

FeatureResult resultFrom(const Feature& feature, const std::vector<Json>& records) {
    expects(records.size() == feature.variants.size(), "a record for each variant");
    FeatureResult result{feature.name, feature.part, {}};
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Json* frames = at(records[i], "method", "frames");
        expects(frames && frames->asNumber(), "a record says over how many frames it was counted");
        result.rows.push_back(rowFrom(feature.variants[i], static_cast<int>(*frames->asNumber()), records[i]));
    }
    return result;
}

} // namespace toile::study::lean
