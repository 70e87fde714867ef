// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/run_options.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <thread>

namespace spricka::program {

int thread_count(const RunOptions& options, const model::Model& model) {
  const int wanted = options.threads >= 0 ? options.threads
                                          : scheduler_cpu_count().value_or(model.control.threads);
  return wanted > 0 ? wanted : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

} // namespace spricka::program
