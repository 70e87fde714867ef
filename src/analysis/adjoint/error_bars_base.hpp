// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "results/results.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Whether K counts with its estimated error taken out, wherever it has an error bar (manual,
/// error_bar.md): unless $GROW CORRECT=NO asks for K as the mesh has it, or the growth is by K of
/// loads that friction makes hang on their order, which has no estimate.
bool corrects_K(const model::Model& model);

/// Processor ESTIMATE: what error bars of K at the ends of the steps of one crack length have in
/// common in the plane and in space.
class ErrorBarsBase {
protected:
  /// Both must outlive it.
  ErrorBarsBase(const model::Model& model, const Discretisation& scene);

  /// Gives the fronts of a step their bars and takes the estimated errors out of their K, or says
  /// why they have none: `why_not`, where it is not empty, or what `estimate` writes into the
  /// front. That has the front's place among those of the step and its first point among those of
  /// all.
  void assign_error_bars(
      const std::string& why_not, results::LoadStepResult& step,
      const std::function<void(std::size_t, std::size_t, results::FrontResult&)>& estimate);
  /// Loads of the cases with these factors on modes [freedoms], from those of one case.
  base::Vector sum_case_loads(const base::Vector& case_factor, Eigen::Index freedoms,
                              const std::function<base::Vector(std::size_t)>& of_case);
  /// A note, unless a step before had it.
  void add_note_once(results::Note note, results::LoadStepResult& step);

  const model::Model& model_;
  const Discretisation& scene_;
  bool prepared_ = false;
  std::string why_not_; ///< of the whole mesh

private:
  std::vector<std::optional<base::Vector>> case_load_; ///< [case] on the modes
  std::vector<results::Note> reported_;
};

} // namespace spricka::analysis
