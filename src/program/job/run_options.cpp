// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/run_options.hpp"

#include "model/model.hpp"
#include "solve/equation_ranks.hpp"

#include <algorithm>
#include <thread>

namespace spricka::program {

int thread_count(const RunOptions& options, const model::Model& model) {
  const int wanted = options.threads >= 0 ? options.threads
                                          : scheduler_cpu_count().value_or(model.control.threads);
  if (wanted > 0) {
    return wanted;
  }
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const solve::EquationRanks* const ranks = solve::equation_ranks();
  return std::max(1, ranks == nullptr ? cores : cores / ranks->on_own_machine());
}

base::EquationEngine requested_engine(const RunOptions& options, const model::Model& model) {
  return base::equation_engine_of_word(options.engine).value_or(model.control.engine);
}

} // namespace spricka::program
