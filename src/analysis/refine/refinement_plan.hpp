// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/read_options.hpp"
#include "mesh/size_map.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <map>
#include <string>
#include <vector>

namespace spricka::analysis {

/// What to mesh finer, so that the error bars of K shrink to what is asked for: grows from round to
/// round, never back (manual, tolerance.1 to 4).
class RefinementPlan {
public:
  explicit RefinementPlan(const model::Model& model);

  /// Takes the errors of a solution into account. Returns what is made finer, in words; empty if
  /// nothing is left that would help.
  std::string refine_from_errors(const model::Model& model, const results::RunResult& run);

  /// For deck::read_deck.
  [[nodiscard]] const std::map<std::string, deck::NetRefinement>& refinements() const {
    return nets_;
  }
  /// Writes what patches are to have into a model that was read anew.
  void apply_to_model(model::Model& model) const;

  /// How many times as many elements the last `refine_from_errors` gives patches, at most.
  [[nodiscard]] double patch_element_growth() const { return patch_growth_; }

private:
  std::string refine_fronts(const model::Model& model, const results::RunResult& run);

  double patch_growth_ = 1.0;
  std::map<std::string, deck::NetRefinement> nets_;
  std::vector<double> finer_; ///< [crack] divides the element sizes of its patch
};

} // namespace spricka::analysis
