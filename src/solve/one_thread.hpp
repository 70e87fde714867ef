// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::solve {

/// Ends the threads that the library of dense kernels starts when it is loaded. Call once, at the
/// start of the program; what needs the kernels would do it later.
void end_idle_threads();

/// Where the memory of the process is limited (ulimit -v), the library of dense kernels tries for
/// ever to get the workspace of a thread that there is no room for. This sets it aside, for as many
/// of the wanted threads as leave half of the room free, and returns their number. Throws
/// std::bad_alloc when there is no room for one.
int reserve_blas_workspace(int threads);

} // namespace spricka::solve
