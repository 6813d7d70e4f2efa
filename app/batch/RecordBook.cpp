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

} // namespace

Result<RecordBook> RecordBook::opened(const std::filesystem::path& file, const study::Circumstances& circumstances,
                                      bool fresh) {
    RecordBook book;
    book.file_ = file;
    std::ifstream old(book.file_);
    for (std::string line; !fresh && std::getline(old, line);)
        if (auto record = parseJson(line); record && isOf(*record, circumstances))
            book.before_.push_back(std::move(*record));
    if (auto written = writeFileAtomically(book.file_, linesOf(book.before_)); !written)
        return tl::unexpected(written.error());
    return book;
}

std::vector<Json> RecordBook::standing(const std::vector<Json>& keys) const {
    std::vector<Json> found;
    for (const Json& key : keys) {
        const auto record = std::ranges::find_if(before_, [&](const Json& known) {
            return areEqual(known.find("scene"), key.find("scene")) &&
                   areEqual(known.find("method"), key.find("method"));
        });
        if (record == before_.end()) return {};
        found.push_back(*record);
    }
    return found;
}

const std::vector<Json>& RecordBook::take(const std::vector<Json>& known) {
    records_.insert(records_.end(), known.begin(), known.end());
    taken_ += known.size();
    return known;
}

Result<void> RecordBook::append(const std::vector<Json>& records) {
    std::ofstream file(file_, std::ios::app);
    file << linesOf(records) << std::flush;
    if (!file) return fail(ErrorCode::io, "The records cannot be written.", {file_.string()});
    records_.insert(records_.end(), records.begin(), records.end());
    return {};
}

std::string RecordBook::standingText() const {
    if (taken_ == 0) return "";
    return fmt::format("{} of {} records stood in {} already; --fresh measures them again.\n", taken_, records_.size(),
                       file_.string());
}

} // namespace toile::batch
