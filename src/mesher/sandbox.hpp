// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace spricka::mesher {

/// Locks the process in, for good, by a seccomp filter of the Linux kernel (libseccomp): no program
/// can be started and no socket made (the attempt ends the process), no file opened but the one of
/// only_file.hpp, nothing written but to the descriptors 1 to 3, no signal sent to others. False
/// where the kernel has no such filters.
bool enter_sandbox();

/// The process runs on the processor that it is on, for good: libraries that start a thread for
/// each processor they see (OpenCASCADE with TBB) start none, as the sandbox would end them.
void pin_to_one_processor();

/// The process gets no more than `memory` bytes beyond those that it holds now, and leaves no core.
void limit_memory(std::size_t memory);

/// The kernel ends the process when it has used this much more processor time [s].
void limit_processor_time(double seconds);

} // namespace spricka::mesher
