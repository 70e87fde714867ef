// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::solve {

/// Ends the threads that the library of dense kernels starts when it is loaded. Call once, at the
/// start of the program; what needs the kernels would do it later.
void end_idle_threads();

} // namespace spricka::solve
