// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace spricka::base {

/// Memory this process may grow to [bytes]: that of the machine, or less where its control group or
/// a resource limit (ulimit -v, a job queue) allows less.
std::size_t process_memory_limit();

} // namespace spricka::base
