// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace toile {

/// Stops work that takes longer than it may, and when others stop it.
class TimeLimit {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// deadline: when the work is stopped; absent = never. others: who may stop it before.
    TimeLimit(std::optional<Time> deadline, std::stop_token others);
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    /// What the work is to look at.
    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
    /// Whether it is over, and no one else has stopped the work.
    [[nodiscard]] bool isOver() const;
    /// Whether the work ended in this error because of it.
    [[nodiscard]] bool ended(const Error& error) const { return error.code == ErrorCode::cancelled && isOver(); }

private:
    std::optional<Time> deadline_;
    std::stop_token others_;
    std::stop_source source_;
    std::stop_callback<std::function<void()>> passOn_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread timer_; ///< last, as it uses the others
};

} // namespace toile
