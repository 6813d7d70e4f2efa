// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Team.h"

#include "core/base/Contracts.h"

#include <utility>

namespace toile {
namespace {

/// How often a thread looks before it sleeps: 0.1 to 0.4 ms on processors whose pause takes 40 to 140 cycles.
constexpr int patience = 8000;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

template <class Condition>
bool happensSoon(const Condition& condition) {
    for (int i = 0; i < patience; ++i) {
        if (condition()) return true;
        pause();
    }
    return false;
}

/// What nobody has taken of a call: pieces of work from first to end, packed into one number with that of the call.
/// Who calls takes them from the end, helpers from the beginning: neighbours in one call are mostly neighbours in the
/// next, and what a core has just worked on is in its cache.
constexpr int bits = 20;
constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;

std::uint64_t packed(std::uint64_t call, int end) {
    return call << 2 * bits | static_cast<std::uint64_t>(end);
}
std::uint64_t callOf(std::uint64_t left) {
    return left >> 2 * bits;
}
int firstOf(std::uint64_t left) {
    return static_cast<int>(left >> bits & mask);
}
int endOf(std::uint64_t left) {
    return static_cast<int>(left & mask);
}
constexpr std::uint64_t oneFirst = std::uint64_t{1} << bits, oneLast = 1;

} // namespace

Team::Team(int members)
    : members_(members > 0 ? members : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

Team::~Team() {
    dismissed_ = true;
    ++calls_;
    calls_.notify_all();
}

void Team::share(int count, Job job) {
    expects(count >= 0 && count <= static_cast<int>(mask));
    if (count == 0) return;
    while (std::ssize(helpers_) < std::min(count, members_) - 1) helpers_.emplace_back([this] { help(); });
    job_ = job;
    undone_.store(count, std::memory_order_relaxed);
    left_.store(packed(callOf(left_.load(std::memory_order_relaxed)) + 1, count), std::memory_order_release);
    if (count > 1) {
        ++calls_;
        calls_.notify_all();
    }
    while (takeOne(true)) {
    }
    const auto allDone = [this] { return undone_.load(std::memory_order_acquire) == 0; };
    if (!happensSoon(allDone))
        for (int undone; (undone = undone_.load(std::memory_order_acquire)) > 0;) undone_.wait(undone);
    if (const std::exception_ptr failure = std::exchange(failure_, nullptr)) std::rethrow_exception(failure);
}

void Team::help() {
    for (;;) {
        const std::uint32_t seen = calls_; // before the question: who dismisses calls afterwards
        if (dismissed_) return;
        while (takeOne(false)) {
        }
        const auto isCalled = [&] { return calls_.load(std::memory_order_relaxed) != seen; };
        if (!happensSoon(isCalled)) calls_.wait(seen);
    }
}

/// False when nothing is left to be taken. What was taken belongs to the call under way, which cannot end before it is
/// done: only then is the job read.
bool Team::takeOne(bool last) {
    std::uint64_t left = left_.load(std::memory_order_acquire);
    do {
        if (firstOf(left) == endOf(left)) return false;
    } while (!left_.compare_exchange_weak(left, last ? left - oneLast : left + oneFirst, std::memory_order_acquire));
    try {
        job_.call(job_.work, last ? endOf(left) - 1 : firstOf(left));
    } catch (...) {
        const std::lock_guard lock(guard_);
        failure_ = std::current_exception();
    }
    if (undone_.fetch_sub(1, std::memory_order_acq_rel) == 1) undone_.notify_one();
    return true;
}

} // namespace toile
