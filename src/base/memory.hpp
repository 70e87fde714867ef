// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace spricka::base {

/// Memory this process may grow to [bytes]: that of the machine, or less where its control group or
/// a resource limit (ulimit -v, a job queue) allows less.
std::size_t process_memory_limit();

/// What of it this process can still get [bytes]. Where the limit is one of address space (ulimit
/// -v), that counts which is taken already, by libraries too.
double available_memory();

/// From now on that is a share of what the machine or the control group has: this process is one of
/// so many alike on it.
void divide_memory_limit(int processes);

} // namespace spricka::base
