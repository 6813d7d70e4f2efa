// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace toile {

/// Does work(0) … work(count − 1), each once and in any order, on all cores; returns when all are done. Threads are
/// started for each call (some 50 µs): for pieces and files, not for single particles. When calls throw, the others
/// still run and one of the exceptions is rethrown.
void inParallel(int count, const std::function<void(int)>& work);

} // namespace toile
