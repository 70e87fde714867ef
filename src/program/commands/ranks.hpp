// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

namespace spricka::program {

/// Runs the program, and returns its exit code, on one process of those that mpirun or srun may
/// have started as one run. The others condense nets for it until it ends, write nothing and end
/// with its code. A process that was started alone just runs it. Without the module for MPI nothing
/// runs, as each process would write the same folder: exit code 7, and the message names the
/// packages.
int run_on_first_rank(const std::function<int()>& program);

} // namespace spricka::program
