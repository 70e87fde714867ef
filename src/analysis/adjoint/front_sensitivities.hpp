// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/front_bars.hpp"

#include <vector>

namespace spricka::analysis {

/// One thing that K along fronts depends on: loads, gaps and a part of K that it changes by itself.
struct FrontCause {
  results::FrontSensitivity is; ///< without its derivatives
  base::Vector load;            ///< [dim * node] by its value; empty: none
  base::Vector gap;             ///< [table row] by its value; empty: none
  base::Vector given;           ///< [dim * node] displacements of supports; empty: none
  base::Vector direct;          ///< [K] dK by its value with u kept
};

/// Processor SENSITIVITY in space: derivatives of K along fronts by loads, fits and moduli. There
/// are fewer causes than K: each is solved for, where the plane has an adjoint for each K; the
/// numbers are the same (manual, sensitivity.14).
class FrontSensitivities {
public:
  /// All must outlive it; nothing is computed yet.
  FrontSensitivities(const model::Model& model, const Scene& scene);

  /// Adds to the fronts of `result` what the end of a step, which was solved last, gives.
  void add(const FrozenStep& step, const FrontFunctionals& K, results::StepResult& result);

private:
  void prepare();
  void add_loads(const FrozenStep& step, const FrontFunctionals& K,
                 std::vector<FrontCause>& causes) const;
  void add_fits(const FrozenStep& step, std::vector<FrontCause>& causes) const;
  void add_moduli(const FrozenStep& step, const FrontFunctionals& K,
                  std::vector<FrontCause>& causes) const;
  void solve(const FrozenStep& step, const FrontFunctionals& K,
             const std::vector<FrontCause>& causes, results::StepResult& result) const;

  const model::Model& model_;
  const Scene& scene_;
  bool prepared_ = false;
  base::Matrix case_load_; ///< [dim * node, case] with the pull of supports
  base::Matrix of_loads_;  ///< [K, case] what loads add to K themselves
};

} // namespace spricka::analysis
