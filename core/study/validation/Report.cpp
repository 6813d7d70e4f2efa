// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Report.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace toile::study::validation {
namespace {

const char* verdictOf(const Row& row) {
    return row.passes() ? "PASS" : "FAIL";
}

/// A bar would end the cell.
std::string cellOf(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
    return text;
}

std::string tableLineOf(const Row& row) {
    const std::string what = cellOf(row.what);
    if (!row.stopped.empty()) return fmt::format("| {} | {} | | {} | | FAIL |\n", row.number, what, row.stopped);
    if (row.isBound)
        return fmt::format("| {} | {} | ≤ {:.3g} | {:.3g} | | {} |\n", row.number, what, row.expected, row.measured,
                           verdictOf(row));
    return fmt::format("| {} | {} | {:.6g} | {:.6g} | {:.2g} | {} |\n", row.number, what, row.expected, row.measured,
                       row.tolerance, verdictOf(row));
}

Json recordOf(const Case& one, const Row& row) {
    Json record;
    record.set("case", row.number).set("theme", std::string(one.theme)).set("title", std::string(one.title));
    record.set("what", row.what);
    if (row.isBound) record.set("bound", row.expected);
    else record.set("expected", row.expected).set("tolerance", row.tolerance);
    record.set("measured", row.measured).set("verdict", verdictOf(row));
    if (!row.stopped.empty()) record.set("reason", row.stopped);
    else if (!row.passes() && !one.openProblem.empty()) record.set("reason", std::string(one.openProblem));
    return record;
}

bool passes(const Outcome& outcome) {
    return std::ranges::all_of(outcome.rows, &Row::passes);
}

} // namespace

bool allPass(const std::vector<Outcome>& outcomes) {
    return std::ranges::all_of(outcomes, passes);
}

std::string summaryOf(const std::vector<Outcome>& outcomes, const std::vector<NotOffered>& notOffered) {
    std::size_t rows = 0, passed = 0;
    std::vector<std::string_view> failing, missing;
    for (const Outcome& outcome : outcomes) {
        rows += outcome.rows.size();
        passed += static_cast<std::size_t>(std::ranges::count_if(outcome.rows, &Row::passes));
        if (!passes(outcome) && std::ranges::find(failing, outcome.which.number) == failing.end())
            failing.push_back(outcome.which.number);
    }
    for (const NotOffered& one : notOffered) missing.push_back(one.number);
    std::string text = fmt::format("{} of {} rows pass.", passed, rows);
    if (!failing.empty()) text += fmt::format(" Failing: {}.", fmt::join(failing, ", "));
    if (!missing.empty()) text += fmt::format(" Not offered: {}.", fmt::join(missing, ", "));
    return text;
}

std::string validationText(const std::vector<Outcome>& outcomes, const std::vector<NotOffered>& notOffered,
                           const Circumstances& circumstances) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "# Validation\n\n`{}`, {}, {}.\n\n{} Tolerances are relative to what is expected; ≤ is a bound. SI "
                   "units where none are named. It is the numerical error alone: how far a model is from real cloth is "
                   "not known without a table that pairs drape with measured stiffness.\n\n"
                   "| case | what | expected | measured | tolerance | verdict |\n|---|---|---|---|---|---|\n",
                   circumstances.command, circumstances.program, circumstances.processor,
                   summaryOf(outcomes, notOffered));
    for (const Outcome& outcome : outcomes)
        for (const Row& row : outcome.rows) text += tableLineOf(row);
    for (const NotOffered& one : notOffered)
        fmt::format_to(out, "| {} | {} | | {} | | not offered |\n", one.number, one.title, one.reason);
    for (const Outcome& outcome : outcomes)
        if (!passes(outcome) && !outcome.which.openProblem.empty())
            fmt::format_to(out, "\n**{}, {}**: {}\n", outcome.which.number, outcome.which.title,
                           outcome.which.openProblem);
    return text;
}

std::vector<Json> recordsOf(const std::vector<Outcome>& outcomes, const std::vector<NotOffered>& notOffered,
                            const Circumstances& circumstances) {
    std::vector<Json> records;
    for (const Outcome& outcome : outcomes)
        for (const Row& row : outcome.rows) records.push_back(recordOf(outcome.which, row));
    for (const NotOffered& one : notOffered) {
        Json record;
        record.set("case", std::string(one.number)).set("title", std::string(one.title));
        record.set("verdict", "not offered").set("reason", std::string(one.reason));
        records.push_back(std::move(record));
    }
    for (Json& record : records) note(record, "toile-validation-1", circumstances);
    return records;
}

} // namespace toile::study::validation
