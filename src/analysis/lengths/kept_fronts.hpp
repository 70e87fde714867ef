// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/solve_options.hpp"
#include "archive/checkpoint.hpp"
#include "growth/growth_integrator.hpp"
#include "model/forward.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Fronts that an earlier run solved as stations of a growth by another law or spectrum.
namespace spricka::analysis {

/// Why the law of $GROW has a part in where its fronts are, or in what is kept of them, so that
/// those of one law cannot serve another, and what would do; empty: it has none.
std::string why_law_moves_fronts(const model::Model& model);

/// Makes the next station of a front that was kept: its K stands, the rate is that of the law now.
/// Empty, or why it cannot be: then there is no such station. Throws base::CorruptStoredField.
std::string add_kept_front(const model::Model& model, const archive::StoredIncrement& kept,
                           GrowthRateEvaluator& measure, growth::GrowthIntegrator& integrator);

/// Takes fronts of another law out of a checkpoint.
class KeptFrontsOfAnotherLaw {
public:
  /// All must outlive it; `options` with a checkpoint, `run` gets what is taken over.
  KeptFrontsOfAnotherLaw(const model::Model& model, const SolveOptions& options,
                         GrowthRateEvaluator& measure, results::RunResult& run)
      : model_(model), options_(options), measure_(measure), run_(run) {}

  /// Goes on until the growth ends or a front does not serve, which is reported. `pictured`: steps
  /// with stresses, by the number of the increment. The last one, without what the run has of it,
  /// to be stored with the state that is known by then; empty: none serves. Throws
  /// base::CorruptStoredField.
  std::optional<archive::StoredIncrement>
  take_over(growth::GrowthIntegrator& integrator,
            const std::function<std::vector<bool>(int number)>& pictured);

private:
  archive::StoredIncrement append(archive::StoredIncrement kept,
                                  const growth::GrowthIntegrator& integrator);

  const model::Model& model_;
  const SolveOptions& options_;
  GrowthRateEvaluator& measure_;
  results::RunResult& run_;
};

} // namespace spricka::analysis
