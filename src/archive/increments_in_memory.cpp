// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/increments_in_memory.hpp"

namespace spricka::archive {

results::CrackLengthResult copy_fronts_of_increment(const results::CrackLengthResult& increment) {
  results::CrackLengthResult out;
  out.number = increment.number;
  out.a = increment.a;
  out.mesh.dim = increment.mesh.dim;
  for (const results::LoadStepResult& step : increment.steps) {
    results::LoadStepResult& copy = out.steps.emplace_back();
    copy.step = step.step;
    copy.fronts = step.fronts;
    copy.notes = step.notes;
  }
  for (const results::LoadPathResult& path : increment.paths) {
    results::LoadPathResult& copy = out.paths.emplace_back();
    copy.name = path.name;
    copy.from = path.from;
    copy.to = path.to;
    copy.t = path.t;
    copy.fronts = path.fronts;
    copy.stopped = path.stopped;
    copy.homogeneous = path.homogeneous;
    copy.notes = path.notes;
  }
  return out;
}

void IncrementsInMemory::begin_growth(GrowthOverFronts use) {
  use_ = use;
  served_ = 0;
  solved_ = 0;
  rejection_.clear();
}

bool IncrementsInMemory::has_stored_increment(int number) const {
  return static_cast<std::size_t>(number) <= kept_.size();
}

StoredIncrement IncrementsInMemory::read_stored_increment(int number) const {
  return kept_[static_cast<std::size_t>(number) - 1];
}

void IncrementsInMemory::list_increment_of_another_law(int /*number*/,
                                                       std::vector<results::LogLine> /*log*/) {
  ++served_;
}

// The growth may go on from it.
void IncrementsInMemory::store_last_of_another_law(SolvedIncrement again) {
  ++served_;
  if (use_ != GrowthOverFronts::trial) {
    kept_[static_cast<std::size_t>(again.increment.number) - 1].state = std::move(again.state);
  }
}

void IncrementsInMemory::reject_increments_from(int number, const std::string& why) {
  rejection_ = why;
  if (use_ != GrowthOverFronts::trial) {
    kept_.resize(static_cast<std::size_t>(number) - 1);
  }
}

void IncrementsInMemory::store_increment(double /*asked*/, SolvedIncrement done) {
  ++solved_;
  kept_.push_back({copy_fronts_of_increment(done.increment), std::move(done.state),
                   std::move(done.log), done.cpu, done.wall});
}

} // namespace spricka::archive
