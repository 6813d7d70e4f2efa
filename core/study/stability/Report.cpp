// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/Report.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace toile::study::stability {
namespace {

std::string textOf(const std::optional<double>& value, double scale = 1) {
    return value ? fmt::format("{:.2g}", scale * *value) : "";
}

void setIfKnown(Json& json, const char* key, const std::optional<double>& value) {
    if (value) json.set(key, *value);
}

Json toJson(const Metrics& metrics) {
    Json json;
    setIfKnown(json, "energyGrowth", metrics.energyGrowth);
    setIfKnown(json, "largestSpeed", metrics.speed);
    setIfKnown(json, "largestStrain", metrics.strain);
    setIfKnown(json, "residual", metrics.residual);
    setIfKnown(json, "newtonPerStep", metrics.newtonPerStep);
    setIfKnown(json, "leastDistance", metrics.distance);
    json.set("rejectedSteps", metrics.divided).set("cpuSeconds", metrics.seconds);
    return json;
}

Json toJson(const MapCell& cell) {
    Json json;
    json.set("case", "S1").set("method", cell.method).set("stiffness", cell.stiffness).set("step", cell.step);
    json.set("duration", cell.duration).set("explicitStepLimit", cell.stepLimit).set("bounded", cell.bounded);
    json.set("relativeError", cell.error).set("stiffnessUsed", cell.softened).set("result", toJson(cell.run.metrics));
    if (!cell.run.stopped.empty()) json.set("reason", cell.run.stopped);
    return json;
}

} // namespace

std::string lineOf(const Row& row) {
    return fmt::format("{:<4} {:<72} {:<9} {}", row.number, row.what, nameOf(row.verdict), row.why);
}

std::string summaryOf(const std::vector<Row>& rows) {
    const auto count = [&](Verdict verdict) { return std::ranges::count(rows, verdict, &Row::verdict); };
    return fmt::format("{} PASS, {} PASS-WARN, {} REFUSED, {} FAIL", count(Verdict::pass),
                       count(Verdict::passWithWarning), count(Verdict::refused), count(Verdict::fail));
}

std::string stabilityText(const std::vector<Row>& rows, bool withMap, const Circumstances& circumstances) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out,
        "# Stability\n\n`{}`, {}, {}.\n\n**{}**\n\nEnergy: the most that the total rose above its start, in % of what "
        "was turned over between its forms; 0.1 % is allowed to backward Euler, 1 % to the others; symplectic Euler's "
        "swings by up to 500 %. Residual: over the "
        "mean weight of a particle. Distance: the least of what is to be kept apart. A verdict of REFUSED stands only "
        "where a refusal is right.\n\n"
        "| case | what | energy % | speed m/s | strain % | residual | Newton a step | distance mm | CPU s | verdict | "
        "|\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n",
        circumstances.command, circumstances.program, circumstances.processor, summaryOf(rows));
    for (const Row& row : rows)
        fmt::format_to(out, "| {} | {} | {} | {} | {} | {} | {} | {} | {:.2g} | {} | {} |\n", row.number, row.what,
                       textOf(row.metrics.energyGrowth, 100), textOf(row.metrics.speed),
                       textOf(row.metrics.strain, 100), textOf(row.metrics.residual), textOf(row.metrics.newtonPerStep),
                       textOf(row.metrics.distance, 1000), row.metrics.seconds, nameOf(row.verdict), row.why);
    if (withMap)
        text +=
            "\nThe map of S1. A cell's colour is the error; hatched: the cap of position-based dynamics used springs "
            "softer than the cloth's, by the factor written there.\n\n![stiffness against step](stiffness-map.svg)\n";
    return text;
}

std::vector<Json> recordsOf(const std::vector<Row>& rows, const std::vector<MapCell>& map,
                            const Circumstances& circumstances) {
    std::vector<Json> records;
    for (const Row& row : rows) {
        Json record;
        record.set("case", row.number).set("what", row.what).set("verdict", std::string(nameOf(row.verdict)));
        record.set("result", toJson(row.metrics));
        if (!row.why.empty()) record.set("reason", row.why);
        records.push_back(std::move(record));
    }
    for (const MapCell& cell : map) records.push_back(toJson(cell));
    for (Json& record : records) note(record, "toile-stability-1", circumstances);
    return records;
}

} // namespace toile::study::stability
