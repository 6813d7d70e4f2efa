// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

namespace toile {

/// Hands the newest value from one thread to another; neither waits. A value not taken in time is dropped.
template <class T>
class Mailbox {
public:
    Mailbox() = default;
    Mailbox(const Mailbox&) = delete;
    Mailbox& operator=(const Mailbox&) = delete;
    ~Mailbox() { delete slot_.load(); }

    void put(T value) { delete slot_.exchange(new T(std::move(value)), std::memory_order_acq_rel); }

    [[nodiscard]] std::optional<T> take() {
        const std::unique_ptr<T> value(slot_.exchange(nullptr, std::memory_order_acq_rel));
        return value ? std::optional<T>(std::move(*value)) : std::nullopt;
    }

private:
    std::atomic<T*> slot_{nullptr};
};

} // namespace toile
