// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <unistd.h>

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

std::size_t less(std::size_t from, std::size_t taken) {
    return from > taken ? from - taken : 0;
}

/// The first word of a file as a number; absent if it is none, as "max" where nothing limits.
std::optional<std::size_t> numberIn(const fs::path& file) {
    std::ifstream in(file);
    std::size_t number = 0;
    return in >> number ? std::optional(number) : std::nullopt;
}

/// The number that follows a word at the beginning of a line.
std::optional<std::size_t> numberAfter(std::string_view key, const fs::path& file) {
    std::ifstream in(file);
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key)) {
            number = std::strtoull(line.c_str() + key.size(), nullptr, 10);
            return number;
        }
    return std::nullopt;
}

std::size_t freeOnMachine(const fs::path& root) {
    constexpr std::size_t kilobyte = 1024;
    const auto kilobytes = numberAfter("MemAvailable:", root / "proc/meminfo");
    return kilobytes ? kilobyte * *kilobytes : unlimited;
}

/// What one group leaves; pages of files that it has not looked at lately are given up when they are needed.
std::size_t freeInGroup(const fs::path& group) {
    const auto limit = numberIn(group / "memory.max"), used = numberIn(group / "memory.current");
    if (!limit || !used) return unlimited;
    const std::size_t kept = less(*used, numberAfter("inactive_file ", group / "memory.stat").value_or(0));
    return less(*limit, kept);
}

/// Each group of the second version lies in one that limits it as well.
std::size_t freeInGroups(const fs::path& root) {
    std::ifstream in(root / "proc/self/cgroup");
    const fs::path top = root / "sys/fs/cgroup";
    constexpr std::string_view unified = "0::/";
    std::size_t least = unlimited;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(unified)) continue;
        fs::path group = top;
        least = freeInGroup(group);
        for (const fs::path& part : fs::path(line.substr(unified.size()))) {
            group /= part;
            least = std::min(least, freeInGroup(group));
        }
    }
    return least;
}

std::size_t freeInProcess(const fs::path& root) {
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    const auto pages = numberIn(root / "proc/self/statm");
    return less(limit.rlim_cur, pages.value_or(0) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)));
}

} // namespace

std::size_t availableMemory(const fs::path& root) {
    return std::min({freeOnMachine(root), freeInGroups(root), freeInProcess(root)});
}

} // namespace toile
