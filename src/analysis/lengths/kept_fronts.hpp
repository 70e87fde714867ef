// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/pictured_steps.hpp"
#include "analysis/lengths/solve_options.hpp"
#include "archive/increment_store.hpp"
#include "growth/growth_integrator.hpp"
#include "model/forward.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Fronts that an earlier run solved as stations of a growth by another law or spectrum.
namespace spricka::analysis {

/// Why fronts of one law of $GROW cannot serve another, wherever that leads, and what would do;
/// empty: they serve it as far as the tips share the growth as they did.
std::string why_law_moves_fronts(const model::Model& model);

/// Makes the next station of a front that was kept: its K stands, the rates are those of the law
/// now. Of several tips these may lead a little elsewhere, as long as the cycles are right to the
/// tolerance. Empty, or why it cannot be: then there is no such station. Throws
/// base::CorruptStoredField.
std::string add_kept_front(const model::Model& model, const archive::StoredIncrement& kept,
                           GrowthRateEvaluator& measure, growth::GrowthIntegrator& integrator);

/// Takes fronts of another law out of what an earlier run has kept.
class KeptFrontsOfAnotherLaw {
public:
  /// All must outlive it; `options` with an increment store, `run` gets what is taken over.
  KeptFrontsOfAnotherLaw(const model::Model& model, const SolveOptions& options,
                         GrowthRateEvaluator& measure, results::RunResult& run)
      : model_(model), options_(options), measure_(measure), run_(run) {}

  /// Goes on until the growth ends or a front does not serve, which is reported. `pictured`: steps
  /// with stresses, by the number of the increment. The last one, without what the run has of it,
  /// to be stored with the state that is known by then; empty: none serves. Throws
  /// base::CorruptStoredField.
  std::optional<archive::StoredIncrement>
  take_over(growth::GrowthIntegrator& integrator,
            const std::function<PicturedSteps(int number)>& pictured);

private:
  archive::StoredIncrement append(archive::StoredIncrement kept,
                                  const growth::GrowthIntegrator& integrator);

  const model::Model& model_;
  const SolveOptions& options_;
  GrowthRateEvaluator& measure_;
  results::RunResult& run_;
};

} // namespace spricka::analysis
