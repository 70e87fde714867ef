// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>

namespace spricka::base {

/// Calls task(0) .. task(count - 1), each exactly once, on at most `threads` threads. Tasks must
/// not share writable data; then the results do not depend on the number of threads. An exception
/// of the lowest failed index is thrown again after all threads have ended.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

} // namespace spricka::base
