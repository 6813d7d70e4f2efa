// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Parallel.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace toile {

void inParallel(int count, const std::function<void(int)>& work) {
    expects(count >= 0);
    std::atomic<int> next{0};
    std::mutex guard;
    std::exception_ptr failure;
    const auto takeTurns = [&] {
        for (int i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(guard);
                failure = std::current_exception();
            }
        }
    };
    {
        const int helpers = std::min(count, static_cast<int>(std::thread::hardware_concurrency())) - 1;
        std::vector<std::jthread> threads;
        for (int i = 0; i < helpers; ++i) threads.emplace_back(takeTurns);
        takeTurns();
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace toile
