// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/k_so_far.hpp"

#include <utility>

namespace spricka::program {

void InterimKTable::update_increment(const results::Increment& increment) {
  // A state that was tried and not taken is replaced by the next.
  run_.increments.resize(finished_);
  results::Increment& shown = run_.increments.emplace_back();
  shown.number = static_cast<int>(finished_) + 1;
  shown.a = increment.a;
  bool any = false;
  for (const results::StepResult& step : increment.steps) {
    results::StepResult& copy = shown.steps.emplace_back();
    copy.step = step.step;
    copy.fronts = step.fronts;
    any = any || !step.fronts.empty();
  }
  if (any) {
    folder_.write_interim_k(model_, run_);
  }
}

} // namespace spricka::program
