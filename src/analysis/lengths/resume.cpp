// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/resume.hpp"

#include "analysis/lengths/shown_results.hpp"
#include "analysis/scene/gone_nodes.hpp"
#include "model/model.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Outputs may have changed since: stresses that nobody asks for any more go; false: some are
// missing.
bool fit_pictures(const PicturedSteps& wanted, results::CrackLengthResult& increment) {
  std::vector<bool> pictured = wanted.known;
  if (wanted.most_loaded && !increment.steps.empty()) {
    pictured[results::most_loaded_step(increment)] = true;
  }
  bool complete = true;
  for (std::size_t s = 0; s < increment.steps.size(); ++s) {
    results::LoadStepResult& step = increment.steps[s];
    complete = complete && (!pictured[s] || !step.stress.empty());
    if (!pictured[s]) {
      step.stress.clear();
      step.element_stress.clear();
      step.errors.clear();
    }
  }
  return complete;
}

} // namespace

std::optional<archive::StoredIncrement> accept_stored_increment(const model::Model& model,
                                                                archive::IncrementStore* checkpoint,
                                                                int number, double asked,
                                                                const PicturedSteps& pictured) {
  if (checkpoint == nullptr || !checkpoint->has_stored_increment(number)) {
    return std::nullopt;
  }
  if (checkpoint->requested_length_of_increment(number) != asked) {
    checkpoint->reject_increments_from(
        number, fmt::format("$GROW asks for length {:.6g} there, it was {:.6g}", asked,
                            checkpoint->requested_length_of_increment(number)));
    return std::nullopt;
  }
  archive::StoredIncrement kept = checkpoint->read_stored_increment(number);
  if (!fit_pictures(pictured, kept.increment)) {
    checkpoint->reject_increments_from(number,
                                       "an output or check asks for stresses that were not kept");
    return std::nullopt;
  }
  checkpoint->accept_increment(number);
  if (kept.increment.mesh.node_count() > 0) { // in memory only what the law needs is kept
    keep_removed_set_members(model.mesh, kept.increment.mesh);
    add_face_sets_as_node_sets(model, kept.increment.mesh);
  }
  return kept;
}

void append_increment(archive::StoredIncrement kept, results::RunResult& run) {
  run.log.insert(run.log.end(), kept.log.begin(), kept.log.end());
  run.cpu += kept.cpu;
  run.wall += kept.wall;
  run.increments.push_back(std::move(kept.increment));
}

void report_resumed_increment(const SolveOptions& options, const results::RunResult& run,
                              std::size_t increments) {
  if (options.found) {
    options.found(run.increments.back());
  }
  if (options.progress) {
    options.progress({.increment = run.increments.size(), .increments = increments});
  }
}

bool is_time_up(const archive::IncrementStore* checkpoint, base::OptionalFailure& trouble) {
  if (checkpoint == nullptr || !checkpoint->would_exceed_time_limit()) {
    return false;
  }
  trouble = base::OperationFailure{.kind = base::ProgramOutcome::stopped,
                                   .why = checkpoint->run_limit_text()};
  return true;
}

void IncrementRecorder::store_increment(archive::IncrementStore* checkpoint, double asked,
                                        const results::CrackLengthResult& increment,
                                        results::NamedArrays state) const {
  if (checkpoint == nullptr) {
    return;
  }
  // What was logged since the mark belongs to this increment and is told again where it is taken
  // over.
  std::vector<results::LogLine> lines(log_.begin() + static_cast<std::ptrdiff_t>(lines_),
                                      log_.end());
  checkpoint->store_increment(asked, {increment, std::move(state), std::move(lines),
                                      watch_.cpu_time(), watch_.wall_time()});
}

} // namespace spricka::analysis
