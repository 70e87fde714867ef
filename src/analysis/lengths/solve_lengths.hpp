// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/step_solver.hpp"
#include "base/diagnostics.hpp"
#include "model/model.hpp"
#include "results/results.hpp"

#include <functional>
#include <optional>

namespace spricka::archive {
class Checkpoint;
}

namespace spricka::analysis {

struct SolveOptions {
  int threads = 1;
  archive::Checkpoint* checkpoint =
      nullptr; ///< keeps increments, and gives back those of an earlier run
  std::function<void(std::size_t done, std::size_t all)> progress; ///< may be empty
};

/// The chain of processors over all crack lengths: TOPOLOGY, STIFFNESS, CONDENSE, CONTACT, VCE,
/// GROW. Deck mistakes that only the whole model shows go to `diagnostics`; a model that cannot be
/// solved fills `refusal`. In both cases the result is empty.
std::optional<results::Run> solve_run(const model::Model& model, const SolveOptions& options,
                                      base::Diagnostics& diagnostics,
                                      std::optional<Refusal>& refusal);

} // namespace spricka::analysis
