// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/RegularFile.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace toile {
namespace {

struct Handle {
    int number;
    explicit Handle(int opened) : number(opened) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (number >= 0) ::close(number);
    }
};

tl::unexpected<Error> unreadable(const std::filesystem::path& path, int number) {
    return fail(number == ENOENT ? ErrorCode::notFound : ErrorCode::io,
                std::string("Cannot be read: ") + std::strerror(number) + ".", {.file = path.string()});
}

} // namespace

Result<std::string> readRegularFile(const std::filesystem::path& path, std::uint64_t limit) {
    const Handle file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)); // a pipe without writer does not hang
    if (file.number < 0) return unreadable(path, errno);
    struct stat facts {};
    if (::fstat(file.number, &facts) != 0) return unreadable(path, errno);
    if (!S_ISREG(facts.st_mode))
        return fail(ErrorCode::invalidInput, "Is not a regular file.", {.file = path.string()});
    const auto size = static_cast<std::uint64_t>(facts.st_size);
    if (size > limit)
        return fail(ErrorCode::tooLarge,
                    "Is " + std::to_string(size) + " bytes long; at most " + std::to_string(limit) + " are read.",
                    {.file = path.string()});

    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(file.number, bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return unreadable(path, errno);
        if (got == 0) break; // it became shorter meanwhile
        have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
}

} // namespace toile
