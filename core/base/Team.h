// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace toile {

/// Threads that share out work among themselves and whoever calls them. They are started when they are needed first.
/// Between calls they look out for the next one for a fraction of a millisecond, then sleep: work of 20 µs and more is
/// shared at a profit where calls follow each other closely.
class Team {
public:
    /// members: with whoever calls; 0 = one for each core.
    explicit Team(int members = 0);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    [[nodiscard]] int members() const { return members_; }

    /// Does work(0) … work(count − 1), each once and in any order; returns when all are done. When calls throw, the
    /// others still run and one of the exceptions is rethrown. One caller at a time, and none from within the work.
    template <class Work>
    void run(int count, const Work& work) {
        share(count, {&work, [](const void* what, int i) { (*static_cast<const Work*>(what))(i); }});
    }

private:
    struct Job {
        const void* work = nullptr;
        void (*call)(const void* work, int i) = nullptr;
    };
    void share(int count, Job job);
    void help();
    bool takeOne(bool last);

    int members_;
    Job job_;                             ///< changes only while nothing is left of it and all is done
    std::atomic<std::uint64_t> left_{0};  ///< number of the call, first and end of what nobody has taken (Team.cpp)
    std::atomic<int> undone_{0};          ///< pieces of work that are not done
    std::atomic<std::uint32_t> calls_{0}; ///< what helpers sleep on
    std::atomic<bool> dismissed_{false};
    std::mutex guard_; ///< of failure_
    std::exception_ptr failure_;
    std::vector<std::jthread> helpers_;
};

/// Does work(begin, end) with parts of 0 … count − 1. Without a team, or where two members would not have `least` each,
/// whoever calls does all at once.
template <class Work>
void inParts(Team* team, int count, int least, const Work& work) {
    constexpr int perMember = 4; // so that who is late leaves more to the others
    if (!team || team->members() < 2 || count < 2 * least) return work(0, count);
    const int parts = perMember * std::min(team->members(), count / least);
    const auto border = [&](int part) { return static_cast<int>(std::int64_t{count} * part / parts); };
    team->run(parts, [&](int part) { work(border(part), border(part + 1)); });
}

/// The largest of what largestOf(begin, end) gives for such parts, or 0.
template <class LargestOf>
double largestInParts(Team* team, int count, int least, const LargestOf& largestOf) {
    std::atomic<double> largest{0};
    inParts(team, count, least, [&](int begin, int end) {
        const double found = largestOf(begin, end);
        double known = largest;
        while (found > known && !largest.compare_exchange_weak(known, found)) {
        }
    });
    return largest;
}

} // namespace toile
