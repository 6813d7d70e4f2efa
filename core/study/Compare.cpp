// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Compare.h"

#include "core/study/Repetitions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>

namespace toile::study {
namespace {

using Kind = Change::Kind;

/// What names a record; those that it has.
constexpr std::array namePaths{"case",
                               "what",
                               "scene.name",
                               "scene.variant",
                               "scene.layout",
                               "scene.spacing",
                               "scene.stiffness",
                               "method.layout",
                               "method.role",
                               "method.integrator",
                               "method.finished",
                               "method",
                               "stiffness",
                               "method.step",
                               "method.substeps",
                               "method.tolerance",
                               "step"};
/// Nearer to 0 is better.
constexpr std::array errorPaths{"result.rmsError",        "result.maximumError", "result.hausdorffError",
                                "result.normalisedError", "result.lengthError",  "result.difference",
                                "result.seamGap",         "result.penetration",  "result.energyGrowth",
                                "result.residual",        "relativeError"};
/// Members of "cost" that are no counters of the run: times, and what the whole process held.
constexpr std::array noCounters{"cpuSecondsMinimum", "cpuSecondsMedian", "wallSeconds", "repetitions", "peakBytes"};
/// Fewer are better; all other numbers of "cost" are counters, too.
constexpr std::array counterPaths{"result.newtonPerStep", "result.rejectedSteps"};

/// The least change of a time that is called one, however quiet both machines were.
constexpr double leastSpread = 1.05;
/// Of instructions: what malloc does depends on addresses [–].
constexpr double instructionSpread = 1e-3;

const Json* at(const Json& record, std::string_view path) {
    const std::size_t dot = path.find('.');
    const Json* first = record.find(path.substr(0, dot));
    return !first || dot == std::string_view::npos ? first : first->find(path.substr(dot + 1));
}

std::optional<double> numberAt(const Json& record, std::string_view path) {
    const Json* value = at(record, path);
    return value && value->asNumber() ? std::optional(*value->asNumber()) : std::nullopt;
}

std::string textAt(const Json& record, std::string_view path) {
    const Json* value = at(record, path);
    if (value && value->asString()) return *value->asString();
    if (value && value->asNumber()) return fmt::format("{:.4g}", *value->asNumber());
    if (value && value->asBool()) return *value->asBool() ? "yes" : "no";
    return "";
}

std::string_view keyOf(std::string_view path) {
    return path.substr(path.find('.') + 1);
}

std::string nameOf(const Json& record) {
    std::vector<std::string> names;
    for (const char* path : namePaths)
        if (std::string text = textAt(record, path); !text.empty())
            names.push_back(at(record, path)->asBool() ? fmt::format("{} {}", keyOf(path), text) : std::move(text));
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Records by name; a second one of the same name is "name (2)".
std::map<std::string, const Json*> byName(const std::vector<Json>& records) {
    std::map<std::string, const Json*> named;
    for (const Json& record : records) {
        const std::string name = nameOf(record);
        std::string unique = name;
        for (int number = 2; named.contains(unique); ++number) unique = fmt::format("{} ({})", name, number);
        named.emplace(std::move(unique), &record);
    }
    return named;
}

/// 0 is as it should be.
int rankOf(const std::string& verdict) {
    constexpr std::array good{"PASS", "REFUSED", "done", ""};
    constexpr std::array unsure{"PASS-WARN", "not run", "not offered", "in the band", "noisy"};
    if (std::ranges::find(good, verdict) != good.end()) return 0;
    return std::ranges::find(unsure, verdict) != unsure.end() ? 1 : 2;
}

/// A record in both reports.
class Pair {
public:
    Pair(std::string name, const Json& before, const Json& after, Comparison& into)
        : name_(std::move(name)), before_(before), after_(after), into_(into) {}

    void compare() {
        for (const char* path : {"verdict", "status"}) verdict(path);
        for (const char* path : errorPaths) error(path);
        deviation();
        for (const char* path : counterPaths) counter(path);
        if (const Json* cost = before_.find("cost"); cost && cost->asObject())
            for (const auto& [key, value] : *cost->asObject())
                if (std::ranges::find(noCounters, key) == noCounters.end())
                    counter("cost." + key, key == "instructions" ? instructionSpread : 0);
        time();
    }

private:
    void note(Kind kind, std::string_view path, std::string before, std::string after) {
        into_.changes.push_back({kind, name_, std::string(keyOf(path)), std::move(before), std::move(after)});
    }

    void verdict(const char* path) {
        const std::string before = textAt(before_, path), after = textAt(after_, path);
        if (before == after) return;
        const int change = rankOf(after) - rankOf(before);
        note(change > 0 ? Kind::worse : change < 0 ? Kind::better : Kind::other, path, before, after);
    }

    /// Both nearer to the reference than it is to itself.
    [[nodiscard]] bool inBand() const {
        const auto isInBand = [](const Json& record) {
            const Json* band = at(record, "result.inBand");
            return band && band->asBool() && *band->asBool();
        };
        return isInBand(before_) && isInBand(after_);
    }

    void error(const char* path) {
        const auto before = numberAt(before_, path), after = numberAt(after_, path);
        if (before.has_value() != after.has_value())
            return note(Kind::other, path, textAt(before_, path), textAt(after_, path));
        if (!before || inBand()) return;
        const double floor = std::max(numberAt(before_, "reference.selfError").value_or(0),
                                      numberAt(after_, "reference.selfError").value_or(0));
        fewer(path, std::abs(*before), std::abs(*after), floor);
    }

    /// Of a case with a known answer: how far from it.
    void deviation() {
        const auto off = [](const Json& record) -> std::optional<double> {
            const auto measured = numberAt(record, "measured"), expected = numberAt(record, "expected");
            if (!measured) return std::nullopt;
            return std::abs(*measured - expected.value_or(0));
        };
        if (const auto before = off(before_), after = off(after_); before && after)
            fewer("deviation", *before, *after, 0);
    }

    void counter(const std::string& path, double spread = 0) {
        if (const auto before = numberAt(before_, path), after = numberAt(after_, path); before && after)
            fewer(path, *before, *after, spread * *before);
    }

    void fewer(std::string_view path, double before, double after, double floor) {
        if (std::abs(after - before) <= floor) return;
        note(after > before ? Kind::worse : Kind::better, path, fmt::format("{:.6g}", before),
             fmt::format("{:.6g}", after));
    }

    struct Cost {
        double seconds = 0, calibration = 1;
        double spread = 1; ///< median over least
        [[nodiscard]] double calibrations() const { return seconds / calibration; }
    };
    [[nodiscard]] static std::optional<Cost> costOf(const Json& record) {
        const auto least = numberAt(record, "cost.cpuSecondsMinimum"),
                   median = numberAt(record, "cost.cpuSecondsMedian"),
                   calibration = numberAt(record, "machine.calibrationSeconds");
        if (!least || !median || !calibration || *least <= 0 || *calibration <= 0) return std::nullopt;
        return Cost{*least, *calibration, *median / *least};
    }
    [[nodiscard]] bool sameProcessor() const {
        const std::string before = textAt(before_, "machine.processor");
        return !before.empty() && before == textAt(after_, "machine.processor");
    }

    /// On one processor a calibration takes as long as ever, if nothing disturbs it; and what got slower did so in
    /// seconds and in calibrations.
    void time() {
        const auto before = costOf(before_), after = costOf(after_);
        if (!before || !after) return;
        const double calibrations = after->calibrations() / before->calibrations(),
                     seconds = sameProcessor() ? after->seconds / before->seconds : calibrations;
        const double disturbed = std::max(calibrations / seconds, seconds / calibrations);
        if (std::max({before->spread, after->spread, disturbed}) > noisyRatio) {
            ++into_.timesNoisy;
            return;
        }
        ++into_.timesCompared;
        const double spread = std::max(leastSpread, before->spread * after->spread);
        const bool slower = std::min(calibrations, seconds) > spread,
                   faster = std::max(calibrations, seconds) < 1 / spread;
        if (slower || faster)
            note(slower ? Kind::worse : Kind::better, "CPU time in calibrations",
                 fmt::format("{:.4g}", before->calibrations()), fmt::format("{:.4g}", after->calibrations()));
    }

    std::string name_;
    const Json &before_, &after_;
    Comparison& into_;
};

Result<std::string> schemaOf(const std::vector<Json>& records) {
    std::string schema;
    for (const Json& record : records) {
        const std::string own = textAt(record, "schema");
        if (own.empty()) return fail(ErrorCode::invalidInput, "A record names no schema: it is not of a study.");
        if (!schema.empty() && own != schema)
            return fail(ErrorCode::invalidInput,
                        fmt::format("The records are of different studies, {} and {}.", schema, own));
        schema = own;
    }
    if (schema.empty()) return fail(ErrorCode::invalidInput, "There is no record.");
    return schema;
}

const char* wordFor(Kind kind) {
    return kind == Kind::worse ? "worse" : kind == Kind::better ? "better" : "other";
}

} // namespace

bool Comparison::gotWorse() const {
    return std::ranges::find(changes, Kind::worse, &Change::kind) != changes.end();
}

Result<Comparison> compared(const std::vector<Json>& before, const std::vector<Json>& after) {
    const auto schema = schemaOf(before), other = schemaOf(after);
    if (!schema) return tl::unexpected(schema.error());
    if (!other) return tl::unexpected(other.error());
    if (*schema != *other)
        return fail(ErrorCode::invalidInput,
                    fmt::format("These are reports of different studies: {} and {}.", *schema, *other));
    const auto old = byName(before), now = byName(after);
    Comparison comparison;
    for (const auto& [name, record] : old) {
        const auto partner = now.find(name);
        if (partner == now.end()) {
            comparison.onlyOld.push_back(name);
            continue;
        }
        ++comparison.joined;
        Pair(name, *record, *partner->second, comparison).compare();
    }
    for (const auto& [name, record] : now)
        if (!old.contains(name)) comparison.onlyNew.push_back(name);
    std::ranges::stable_sort(comparison.changes, {}, &Change::kind);
    return comparison;
}

std::string comparisonText(const Comparison& comparison) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (const Change& change : comparison.changes)
        fmt::format_to(out, "{:<6} {}: {} {} → {}\n", wordFor(change.kind), change.record, change.quantity,
                       change.before.empty() ? "nothing" : change.before,
                       change.after.empty() ? "nothing" : change.after);
    for (const std::string& name : comparison.onlyOld) fmt::format_to(out, "only in the old: {}\n", name);
    for (const std::string& name : comparison.onlyNew) fmt::format_to(out, "only in the new: {}\n", name);
    const auto count = [&](Kind kind) { return std::ranges::count(comparison.changes, kind, &Change::kind); };
    fmt::format_to(out, "{} records in both: {} worse, {} better, {} other changes. ", comparison.joined,
                   count(Kind::worse), count(Kind::better), count(Kind::other));
    fmt::format_to(out, "Times of {} were compared", comparison.timesCompared);
    if (comparison.timesNoisy > 0)
        fmt::format_to(out,
                       "; those of {} were not, for in one of both the median, or the calibration, was over {:g} times "
                       "what it is undisturbed",
                       comparison.timesNoisy, noisyRatio);
    return text + ".\n";
}

} // namespace toile::study
