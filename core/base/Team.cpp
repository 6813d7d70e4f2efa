// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Team.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <utility>

namespace toile {

Team::~Team() {
    {
        const std::lock_guard lock(guard_);
        dismissed_ = true;
    }
    called_.notify_all();
}

void Team::run(int count, const std::function<void(int)>& work) {
    expects(count >= 0);
    const int wanted = std::min(count, static_cast<int>(std::thread::hardware_concurrency())) - 1;
    std::unique_lock lock(guard_);
    work_ = &work;
    next_ = 0;
    count_ = count;
    while (static_cast<int>(helpers_.size()) < wanted) helpers_.emplace_back([this] { help(); });
    if (wanted > 0) called_.notify_all();
    takeTurns(lock);
    done_.wait(lock, [this] { return busy_ == 0; });
    if (const std::exception_ptr failure = std::exchange(failure_, nullptr)) std::rethrow_exception(failure);
}

void Team::help() {
    std::unique_lock lock(guard_);
    while (!dismissed_) {
        takeTurns(lock);
        called_.wait(lock, [this] { return dismissed_ || next_ < count_; });
    }
}

void Team::takeTurns(std::unique_lock<std::mutex>& lock) {
    ++busy_;
    while (next_ < count_) {
        const int i = next_++;
        std::exception_ptr failure;
        lock.unlock();
        try {
            (*work_)(i);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) failure_ = failure;
    }
    if (--busy_ == 0) done_.notify_all();
}

} // namespace toile
