// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/one_thread.hpp"
#include "solve/blas.hpp"

namespace spricka::solve {

void end_idle_threads() {
  blas::single_thread();
}

} // namespace spricka::solve
