// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/base/Result.h"
#include "core/study/Circumstances.h"

#include <filesystem>
#include <string>
#include <vector>

namespace toile::batch {

/// The records of a study, kept in its folder as they come: the file grows with every part of the study that is done,
/// and a study that was stopped goes on where it was.
class RecordBook {
public:
    /// Takes up the records in the file that this program wrote on this processor; fresh: none. Others are kept beside
    /// it, in results.old.jsonl of results.jsonl. Lines that are no records, as the last of a program that was killed,
    /// are dropped.
    [[nodiscard]] static Result<RecordBook> opened(const std::filesystem::path& file,
                                                   const study::Circumstances& circumstances, bool fresh);

    /// A part of the study: read from its records where they stand, else run now and its records written. keys: what
    /// they are known by, "scene" and "method" of each. repetitions: of each run; a record of fewer does not stand, nor
    /// one whose time is noisy. from(records) and run() give the part, of(part) its records.
    template <class From, class Run, class Of>
    [[nodiscard]] auto part(const std::vector<Json>& keys, int repetitions, const From& from, const Run& run,
                            const Of& of) -> decltype(run()) {
        if (const std::vector<Json> known = standing(keys, repetitions); !known.empty()) return from(take(known));
        auto result = run();
        if (result)
            if (auto written = append(of(*result), repetitions); !written) return tl::unexpected(written.error());
        return result;
    }

    /// Of all parts so far, in their order; then those that were taken up for parts which nobody asked for.
    [[nodiscard]] std::vector<Json> records() const;
    /// "40 of 120 records stood in DIR already; …": empty where none did.
    [[nodiscard]] std::string standingText() const;

private:
    /// Empty unless all stand.
    [[nodiscard]] std::vector<Json> standing(const std::vector<Json>& keys, int repetitions) const;
    const std::vector<Json>& take(const std::vector<Json>& known);
    [[nodiscard]] Result<void> append(std::vector<Json> records, int repetitions);

    std::filesystem::path file_;
    std::vector<Json> before_;  ///< taken up from the file
    std::vector<Json> records_; ///< of the parts so far
    std::size_t taken_ = 0;     ///< of these, how many are from before
};

} // namespace toile::batch
