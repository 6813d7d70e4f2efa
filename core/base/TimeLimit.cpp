// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/TimeLimit.h"

namespace toile {

TimeLimit::TimeLimit(std::optional<Time> deadline, std::stop_token others)
    : deadline_(deadline), others_(std::move(others)), passOn_(others_, [this] { source_.request_stop(); }) {
    if (isOver()) source_.request_stop(); // no need to wait for a thread to start
    if (!deadline) return;
    timer_ = std::jthread([this, until = *deadline](std::stop_token end) {
        std::unique_lock lock(mutex_);
        wake_.wait_until(lock, end, until, [] { return false; });
        if (!end.stop_requested()) source_.request_stop();
    });
}

bool TimeLimit::isOver() const {
    return deadline_ && std::chrono::steady_clock::now() >= *deadline_ && !others_.stop_requested();
}

} // namespace toile
