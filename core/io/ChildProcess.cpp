// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ChildProcess.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TOILE_WIDE_ADDRESS_SPACE 1 // sanitizers reserve terabytes: a limit of addresses cannot be set
#endif

namespace toile::io {
namespace {

/// Addresses in use now [bytes]; 0 if the system does not tell.
std::size_t addressesInUse() {
    unsigned long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t value) {
    const rlimit both{value, value};
    ::setrlimit(resource, &both);
}

bool writeAll(int file, const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        done += static_cast<std::size_t>(written);
    }
    return true;
}

[[noreturn]] void beChild(const std::function<std::string()>& work, const ChildLimits& limits, std::size_t addresses,
                          int answer) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // no orphan keeps computing
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGHUP, SIGPIPE})
        ::signal(signal, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds) + 1);
#ifndef TOILE_WIDE_ADDRESS_SPACE
    limit(RLIMIT_AS, addresses + limits.memory);
#else
    (void)addresses;
#endif
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) ::dup2(nowhere, stream);
    int status = 1;
    try {
        status = writeAll(answer, work()) ? 0 : 1;
    } catch (...) {
        status = 2;
    }
    ::_exit(status);
}

enum class Ending { complete, late, tooLong, unreadable };

Ending collect(int pipe, const ChildLimits& limits, std::string& answer) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
    std::string part(1 << 16, '\0');
    for (;;) {
        const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
        if (left <= 0) return Ending::late;
        pollfd wait{pipe, POLLIN, 0};
        const int ready = ::poll(&wait, 1, static_cast<int>(left * 1000) + 1);
        if (ready < 0 && errno != EINTR) return Ending::unreadable;
        if (ready <= 0) continue;
        const ssize_t got = ::read(pipe, part.data(), part.size());
        if (got == 0) return Ending::complete;
        if (got < 0 && errno != EINTR) return Ending::unreadable;
        if (got > 0) answer.append(part, 0, static_cast<std::size_t>(got));
        if (answer.size() > limits.answer) return Ending::tooLong;
    }
}

int waitFor(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

} // namespace

Result<std::string> runInChild(const std::function<std::string()>& work, const ChildLimits& limits) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return fail(ErrorCode::io, std::string("No pipe could be opened: ") + std::strerror(errno) + ".");
    const std::size_t addresses = addressesInUse();
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        beChild(work, limits, addresses, ends[1]);
    }
    ::close(ends[1]);
    if (child < 0) {
        ::close(ends[0]);
        return fail(ErrorCode::io, std::string("No process could be started: ") + std::strerror(errno) + ".");
    }
    std::string answer;
    const Ending ending = collect(ends[0], limits, answer);
    ::close(ends[0]);
    if (ending != Ending::complete) ::kill(child, SIGKILL);
    const int status = waitFor(child);

    if (ending == Ending::late) return fail(ErrorCode::tooLarge, "Reading it took too long and was stopped.");
    if (ending == Ending::tooLong) return fail(ErrorCode::tooLarge, "What it contains is too large.");
    if (ending == Ending::unreadable) return fail(ErrorCode::io, "The answer of the reading process was lost.");
    if (WIFSIGNALED(status)) return fail(ErrorCode::invalidInput, "The file is damaged: it made its reader crash.");
    if (WEXITSTATUS(status) != 0)
        return fail(ErrorCode::invalidInput, "The file is damaged: its reader gave up, or ran out of memory.");
    return answer;
}

} // namespace toile::io
