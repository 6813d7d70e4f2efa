// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/scenes/Report.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <utility>

namespace toile::study::scenes {
namespace {

/// How a figure stands in the table.
struct Column {
    std::string_view key, title;
    double scale = 1; ///< of what is seen
};

constexpr std::array columns{Column{"rmsError", "RMS error mm", 1e3},
                             Column{"rmsErrorToCoarser", "to the reference of twice its step mm", 1e3},
                             Column{"stretch", "longest stretch %", 100},
                             Column{"costRatio", "cost"},
                             Column{"particles", "particles"},
                             Column{"openSeams", "seams open"},
                             Column{"particlesInside", "particles inside"},
                             Column{"bodyIntersections", "intersections with the body"},
                             Column{"selfIntersections", "with itself"},
                             Column{"cpuSeconds", "CPU s"},
                             Column{"cpuPerSecond", "CPU s per simulated second"}};

const Figure* figureOf(const Row& row, std::string_view key) {
    const auto found = std::ranges::find(row.figures, key, &Figure::key);
    return found == row.figures.end() ? nullptr : &*found;
}

/// "**31** ≤ 15", "11 (8.8)".
std::string cellOf(const Figure* figure, double scale) {
    if (!figure) return "";
    std::string text = fmt::format("{:.3g}", scale * figure->seen);
    if (figure->seen >= 1000) text = fmt::format("{:.0f}", scale * figure->seen);
    if (!figure->reached()) text = fmt::format("**{}**", text);
    if (figure->goal) text += fmt::format(" ≤ {:.3g}", scale * *figure->goal);
    if (figure->elsewhere) text += fmt::format(" ({:.2g})", scale * *figure->elsewhere);
    return text;
}

std::string verdictOf(const Row& row) {
    if (!row.failure.empty()) return "FAIL: " + row.failure;
    if (!row.hasGoal()) return "";
    return row.reached() ? "PASS" : "FAIL";
}

void appendTable(std::string& text, const Outcome& outcome) {
    std::vector<Column> shown;
    std::ranges::copy_if(columns, std::back_inserter(shown), [&](const Column& column) {
        return std::ranges::any_of(outcome.rows, [&](const Row& row) { return figureOf(row, column.key); });
    });
    text += "| run |";
    for (const Column& column : shown) text += fmt::format(" {} |", column.title);
    text += " verdict | |\n|---|";
    for (std::size_t i = 0; i < shown.size(); ++i) text += "---|";
    text += "---|---|\n";
    for (const Row& row : outcome.rows) {
        text += fmt::format("| {} |", row.what);
        for (const Column& column : shown)
            text += fmt::format(" {} |", cellOf(figureOf(row, column.key), column.scale));
        text += fmt::format(" {} | {}{} |\n", verdictOf(row), row.note, row.time.noisy ? "noisy" : "");
    }
}

const Json* at(const Json& record, const char* group, const std::string& key) {
    const Json* members = record.find(group);
    return members ? members->find(key) : nullptr;
}

std::optional<double> numberAt(const Json& record, const char* group, const std::string& key) {
    const Json* value = at(record, group, key);
    return value && value->asNumber() ? std::optional(*value->asNumber()) : std::nullopt;
}

std::string textAt(const Json& record, const char* key) {
    const Json* value = record.find(key);
    return value && value->asString() ? *value->asString() : "";
}

Json keyOf(const std::string& scene, const std::string& what) {
    Json name, key;
    return key.set("scene", name.set("name", scene)).set("method", what);
}

Row rowFrom(const Json& record) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    Row row{.what = textAt(record, "method"), .note = textAt(record, "note"), .failure = textAt(record, "reason")};
    if (const Json* result = record.find("result"); result && result->asObject())
        for (const auto& [key, seen] : *result->asObject())
            row.figures.push_back({key, seen.asNumber() ? *seen.asNumber() : nothing, numberAt(record, "goal", key),
                                   numberAt(record, "elsewhere", key), numberAt(record, "rounding", key).value_or(0)});
    const double least = numberAt(record, "cost", "cpuSecondsMinimum").value_or(0),
                 median = numberAt(record, "cost", "cpuSecondsMedian").value_or(0);
    row.time = {least, median, isNoisy(least, median)};
    return row;
}

Json recordOf(const std::string& scene, const Row& row) {
    Json record = keyOf(scene, row.what), result, goal, elsewhere, rounding, cost;
    for (const Figure& figure : row.figures) {
        result.set(figure.key, figure.seen);
        if (figure.goal) goal.set(figure.key, *figure.goal);
        if (figure.elsewhere) elsewhere.set(figure.key, *figure.elsewhere);
        if (figure.rounding > 0) rounding.set(figure.key, figure.rounding);
    }
    record.set("result", result);
    for (const auto& [group, members] : {std::pair{"goal", goal}, {"elsewhere", elsewhere}, {"rounding", rounding}})
        if (!members.isNull()) record.set(group, members);
    cost.set("cpuSecondsMinimum", row.time.least).set("cpuSecondsMedian", row.time.median);
    if (row.time.noisy) cost.set("noisy", true);
    record.set("cost", std::move(cost));
    if (!row.note.empty()) record.set("note", row.note);
    if (row.hasGoal() || !row.failure.empty()) record.set("verdict", row.reached() ? "PASS" : "FAIL");
    if (!row.failure.empty()) record.set("reason", row.failure);
    return record;
}

} // namespace

std::string summaryOf(const std::vector<Outcome>& outcomes) {
    std::size_t goals = 0;
    std::vector<std::string> missed;
    for (const Outcome& outcome : outcomes)
        for (const Row& row : outcome.rows) {
            goals += row.hasGoal() || !row.failure.empty();
            if (!row.reached()) missed.push_back(fmt::format("{}, {}", outcome.name, row.what));
        }
    std::string text = fmt::format("{} of {} runs with a goal reach it.", goals - missed.size(), goals);
    return missed.empty() ? text : text + fmt::format(" Missed: {}.", fmt::join(missed, "; "));
}

bool allReached(const std::vector<Outcome>& outcomes) {
    return std::ranges::all_of(outcomes,
                               [](const Outcome& outcome) { return std::ranges::all_of(outcome.rows, &Row::reached); });
}

std::string scenesText(const std::vector<Outcome>& outcomes, const Circumstances& circumstances) {
    std::string text = fmt::format(
        "# Scenes with a goal\n\n`{}`, {}, {}. One *calibration*, a loop over a million spring forces, takes "
        "{:.3g} ms.\n\n**{}** What is seen stands before its goal, and in bold where it misses it; in "
        "brackets what another program reached. CPU time is the least of the repetitions.\n",
        circumstances.command, circumstances.program, circumstances.processor, 1e3 * circumstances.calibration,
        summaryOf(outcomes));
    std::size_t rows = 0, noisy = 0;
    for (const Outcome& outcome : outcomes) {
        text += fmt::format("\n## {}\n\n{}\n\n", outcome.name, outcome.about);
        appendTable(text, outcome);
        rows += outcome.rows.size();
        noisy += static_cast<std::size_t>(
            std::ranges::count_if(outcome.rows, [](const Row& row) { return row.time.noisy; }));
    }
    if (noisy > 0) text += '\n' + tooNoisy(noisy, rows) + '\n';
    return text;
}

std::vector<Json> recordsOf(const Outcome& outcome, const Circumstances& circumstances) {
    std::vector<Json> records;
    for (const Row& row : outcome.rows) {
        records.push_back(recordOf(outcome.name, row));
        note(records.back(), "toile-scenes-1", circumstances);
    }
    return records;
}

std::vector<Json> keysOf(const Case& one) {
    std::vector<Json> keys;
    for (const std::string& what : one.runs) keys.push_back(keyOf(one.name, what));
    return keys;
}

Outcome outcomeFrom(const Case& one, const std::vector<Json>& records) {
    Outcome outcome{one.name, one.about, {}};
    for (const Json& record : records) outcome.rows.push_back(rowFrom(record));
    return outcome;
}

} // namespace toile::study::scenes
