// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr mode_t anyWriteBit = S_IWUSR | S_IWGRP | S_IWOTH;

tl::unexpected<Error> refused(const fs::path& path, const std::string& what, int number) {
    return fail(ErrorCode::io, what + ": " + std::strerror(number) + ".", {.file = path.string()});
}

/// The file a path finally names: through symbolic links, also through one whose target does not exist yet.
fs::path resolved(fs::path path) {
    std::error_code ignored;
    for (int hops = 0; hops < 40 && fs::is_symlink(path, ignored); ++hops) {
        const fs::path target = fs::read_symlink(path, ignored);
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

fs::path neighbourOf(const fs::path& path) {
    static std::atomic<unsigned> serial{0};
    return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(::getpid()) + "-" +
                                 std::to_string(serial++) + ".tmp");
}

/// write(bytes) writes some of them and returns how many. 0, or the error number of the call that failed.
template <class Write>
int writeAll(std::string_view bytes, const Write& write) {
    while (!bytes.empty()) {
        const ssize_t written = write(bytes);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

void flushFolderOf(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) return; // the file itself is safe; some file systems do not open folders
    ::fsync(handle);
    ::close(handle);
}

} // namespace

Result<AtomicFile> AtomicFile::create(const fs::path& path) {
    AtomicFile made;
    made.wanted_ = path;
    made.path_ = resolved(path);
    struct stat existing {};
    const bool exists = ::stat(made.path_.c_str(), &existing) == 0;
    if (exists && !S_ISREG(existing.st_mode))
        return fail(ErrorCode::io, "Cannot be written: it is not a regular file.", {.file = path.string()});
    // Renaming over it asks for the folder's permission alone. Root may write anything; the bits say that nobody shall.
    if (exists && (existing.st_mode & anyWriteBit) == 0)
        return fail(ErrorCode::io, "Cannot be written: it is write-protected.", {.file = path.string()});
    if (exists && ::access(made.path_.c_str(), W_OK) != 0) return refused(path, "Cannot be written", errno);

    const fs::path neighbour = neighbourOf(made.path_);
    made.handle_ = ::open(neighbour.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (made.handle_ < 0) return refused(path, "Cannot be written", errno);
    made.neighbour_ = neighbour;
    if (exists && ::fchmod(made.handle_, existing.st_mode & 07777) != 0)
        return refused(path, "Cannot be written", errno);
    return made;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : wanted_(std::move(other.wanted_)), path_(std::move(other.path_)), neighbour_(std::exchange(other.neighbour_, {})),
      handle_(std::exchange(other.handle_, -1)) {}

AtomicFile::~AtomicFile() {
    if (handle_ >= 0) ::close(handle_);
    if (!neighbour_.empty()) ::unlink(neighbour_.c_str());
}

Result<void> AtomicFile::append(std::string_view bytes) {
    const int problem =
        writeAll(bytes, [&](std::string_view rest) { return ::write(handle_, rest.data(), rest.size()); });
    if (problem != 0) return refused(wanted_, "Cannot be written", problem);
    return {};
}

Result<void> AtomicFile::overwrite(std::int64_t at, std::string_view bytes) {
    const auto write = [&](std::string_view rest) {
        const auto done = static_cast<std::int64_t>(bytes.size() - rest.size());
        return ::pwrite(handle_, rest.data(), rest.size(), at + done);
    };
    if (const int problem = writeAll(bytes, write); problem != 0) return refused(wanted_, "Cannot be written", problem);
    return {};
}

Result<void> AtomicFile::finish() {
    int problem = ::fsync(handle_) != 0 ? errno : 0;
    if (::close(std::exchange(handle_, -1)) != 0 && problem == 0) problem = errno;
    if (problem == 0 && ::rename(neighbour_.c_str(), path_.c_str()) != 0) problem = errno;
    if (problem != 0) return refused(wanted_, "Cannot be written", problem);
    neighbour_.clear();
    flushFolderOf(path_);
    return {};
}

Result<void> writeFileAtomically(const fs::path& path, std::string_view bytes) {
    auto file = AtomicFile::create(path);
    if (!file) return tl::unexpected(file.error());
    if (auto written = file->append(bytes); !written) return written;
    return file->finish();
}

Result<void> checkWritable(const fs::path& path) {
    if (auto file = AtomicFile::create(path); !file) return tl::unexpected(file.error());
    return {}; // and it is gone again
}

} // namespace toile
