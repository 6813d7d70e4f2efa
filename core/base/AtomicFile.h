// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace toile {

/// A file that is replaced as a whole: whoever reads it, and whoever comes after a power cut, finds the old content or
/// the new one, never a part. A neighbour of a name of its own grows, is flushed to the disk and renamed. A symbolic
/// link keeps pointing at its target; an existing file keeps its permissions, and one that may not be written, or that
/// nobody may write, is not replaced.
class AtomicFile {
public:
    /// Begins the neighbour. Errors: what cannot be replaced – a folder, a write-protected file – and where nothing can
    /// be written.
    [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& path);
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile(); ///< what is not finished is removed

    [[nodiscard]] Result<void> append(std::string_view bytes);
    /// Replaces bytes that were appended before; at: where the first of them stands.
    [[nodiscard]] Result<void> overwrite(std::int64_t at, std::string_view bytes);
    /// Gives it its name.
    [[nodiscard]] Result<void> finish();

private:
    AtomicFile() = default;

    std::filesystem::path wanted_, path_; ///< as it was named; what that finally names
    std::filesystem::path neighbour_;     ///< empty once it is renamed or gone
    int handle_ = -1;                     ///< of the neighbour while it is open
};

/// Writes a whole file in this way.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// Whether a file could be written there now, asked before long work: the neighbour is made, and taken away again.
[[nodiscard]] Result<void> checkWritable(const std::filesystem::path& path);

} // namespace toile
