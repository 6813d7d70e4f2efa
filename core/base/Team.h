// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace toile {

/// Threads that share out work among themselves and whoever calls them: for pieces and files, not for single particles.
/// They are started when they are needed first and wait between calls.
class Team {
public:
    Team() = default;
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// Does work(0) … work(count − 1), each once and in any order, on all cores; returns when all are done. When calls
    /// throw, the others still run and one of the exceptions is rethrown. One caller at a time.
    void run(int count, const std::function<void(int)>& work);

private:
    void help();
    void takeTurns(std::unique_lock<std::mutex>& lock);

    std::mutex guard_; ///< of all below
    std::condition_variable called_, done_;
    const std::function<void(int)>* work_ = nullptr;
    int next_ = 0, count_ = 0; ///< of the work
    int busy_ = 0;             ///< who works
    bool dismissed_ = false;
    std::exception_ptr failure_;
    std::vector<std::jthread> helpers_;
};

} // namespace toile
