// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/RecordBook.h"

#include "core/base/AtomicFile.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace toile::batch {
namespace {

bool areEqual(const Json* a, const Json* b) {
    return a && b && *a == *b;
}

bool isOf(const Json& record, const study::Circumstances& circumstances) {
    const Json program(circumstances.program), processor(circumstances.processor);
    const Json* machine = record.find("machine");
    return areEqual(record.find("program"), &program) && machine && areEqual(machine->find("processor"), &processor);
}

std::string linesOf(const std::vector<Json>& records) {
    std::string lines;
    for (const Json& record : records) lines += toLine(record) + '\n';
    return lines;
}

/// Of the same run: what is measured later takes its place.
bool isSame(const Json& a, const Json& b) {
    return areEqual(a.find("scene"), b.find("scene")) && areEqual(a.find("method"), b.find("method"));
}

/// Whether it is as good as if it were measured now. A drape that is kept by itself has no cost, and stands.
bool isGoodEnough(const Json& record, int repetitions) {
    const Json* cost = record.find("cost");
    if (!cost) return true;
    const Json *count = cost->find("repetitions"), *noisy = cost->find("noisy");
    const bool isNoisy = noisy && noisy->asBool() && *noisy->asBool();
    return count && count->asNumber() && *count->asNumber() >= repetitions && !isNoisy;
}

void put(std::vector<Json>& records, const Json& record) {
    const auto same = std::ranges::find_if(records, [&](const Json& known) { return isSame(known, record); });
    if (same == records.end()) records.push_back(record);
    else *same = record;
}

/// Lines that are no records, as the last of a program that was killed, are dropped.
std::vector<Json> recordsOf(const std::filesystem::path& file) {
    std::vector<Json> records;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);)
        if (auto record = parseJson(line)) put(records, *record);
    return records;
}

/// "results.old.jsonl" beside "results.jsonl".
std::filesystem::path oldFileOf(std::filesystem::path file) {
    return file.replace_extension(".old" + file.extension().string());
}

Result<void> keepAside(const std::filesystem::path& file, const std::vector<Json>& records) {
    if (records.empty()) return {};
    std::vector<Json> all = recordsOf(file);
    for (const Json& record : records) put(all, record);
    return writeFileAtomically(file, linesOf(all));
}

} // namespace

Result<RecordBook> RecordBook::opened(const std::filesystem::path& file, const study::Circumstances& circumstances,
                                      bool fresh) {
    RecordBook book;
    book.file_ = file;
    std::vector<Json> others;
    for (const Json& record : recordsOf(file))
        (!fresh && isOf(record, circumstances) ? book.before_ : others).push_back(record);
    if (auto kept = keepAside(oldFileOf(file), others); !kept) return tl::unexpected(kept.error());
    if (auto written = writeFileAtomically(book.file_, linesOf(book.before_)); !written)
        return tl::unexpected(written.error());
    return book;
}

std::vector<Json> RecordBook::standing(const std::vector<Json>& keys, int repetitions) const {
    std::vector<Json> found;
    for (const Json& key : keys) {
        const auto record = std::ranges::find_if(before_, [&](const Json& known) { return isSame(known, key); });
        if (record == before_.end() || !isGoodEnough(*record, repetitions)) return {};
        found.push_back(*record);
    }
    return found;
}

const std::vector<Json>& RecordBook::take(const std::vector<Json>& known) {
    records_.insert(records_.end(), known.begin(), known.end());
    taken_ += known.size();
    return known;
}

Result<void> RecordBook::append(std::vector<Json> records, int repetitions) {
    for (Json& record : records)
        if (const Json* found = record.find("cost")) {
            Json cost = *found;
            record.set("cost", cost.set("repetitions", repetitions));
        }
    std::ofstream file(file_, std::ios::app);
    file << linesOf(records) << std::flush;
    if (!file) return fail(ErrorCode::io, "The records cannot be written.", {file_.string()});
    records_.insert(records_.end(), records.begin(), records.end());
    return {};
}

std::vector<Json> RecordBook::records() const {
    std::vector<Json> all = records_;
    for (const Json& record : before_)
        if (std::ranges::none_of(records_, [&](const Json& known) { return isSame(known, record); }))
            all.push_back(record);
    return all;
}

std::string RecordBook::standingText() const {
    if (taken_ == 0) return "";
    return fmt::format("{} of {} records stood in {} already; --fresh measures them again.\n", taken_, records_.size(),
                       file_.string());
}

} // namespace toile::batch
