// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

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

/// 0, or the error number of the call that failed.
int writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
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

/// The new content on its way.
struct Neighbour {
    fs::path path, target; ///< target: where it is to be, through symbolic links
    int file = -1;
    std::optional<mode_t> permissions; ///< of the file that is there now
};

Result<Neighbour> openedBeside(const fs::path& wanted) {
    Neighbour neighbour{.target = resolved(wanted)};
    struct stat existing {};
    const bool exists = ::stat(neighbour.target.c_str(), &existing) == 0;
    if (exists && !S_ISREG(existing.st_mode))
        return fail(ErrorCode::io, "Cannot be written: it is not a regular file.", {.file = wanted.string()});
    // Renaming over it asks for the folder's permission alone. Root may write anything; the bits say that nobody shall.
    if (exists && (existing.st_mode & anyWriteBit) == 0)
        return fail(ErrorCode::io, "Cannot be written: it is write-protected.", {.file = wanted.string()});
    if (exists && ::access(neighbour.target.c_str(), W_OK) != 0) return refused(wanted, "Cannot be written", errno);
    if (exists) neighbour.permissions = existing.st_mode & 07777;
    neighbour.path = neighbourOf(neighbour.target);
    neighbour.file = ::open(neighbour.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (neighbour.file < 0) return refused(wanted, "Cannot be written", errno);
    return neighbour;
}

} // namespace

Result<void> writeFileAtomically(const fs::path& wanted, std::string_view bytes) {
    const auto opened = openedBeside(wanted);
    if (!opened) return tl::unexpected(opened.error());
    const auto& [neighbour, path, file, permissions] = *opened;
    int problem = permissions && ::fchmod(file, *permissions) != 0 ? errno : 0;
    if (problem == 0) problem = writeAll(file, bytes);
    if (problem == 0 && ::fsync(file) != 0) problem = errno;
    if (::close(file) != 0 && problem == 0) problem = errno;
    if (problem == 0 && ::rename(neighbour.c_str(), path.c_str()) != 0) problem = errno;
    if (problem != 0) {
        ::unlink(neighbour.c_str());
        return refused(wanted, "Cannot be written", problem);
    }
    flushFolderOf(path);
    return {};
}

Result<void> checkWritable(const fs::path& path) {
    const auto opened = openedBeside(path);
    if (!opened) return tl::unexpected(opened.error());
    ::close(opened->file);
    ::unlink(opened->path.c_str());
    return {};
}

} // namespace toile
