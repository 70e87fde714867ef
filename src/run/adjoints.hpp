// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/adjoint.hpp"
#include "run/condense_bodies.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

#include <vector>

/// The adjoint of K on the condensed bodies: no large matrix is factorised again.
namespace spricka::run {

class Adjoints {
public:
  /// All must outlive it; nothing is computed yet.
  Adjoints(const model::Model& model, const Scene& scene, const std::vector<BodyNet>& bodies);

  /// [tip] of the step that was solved last, its contact frozen as it ended; steps that end with
  /// the same rows closed share the answer. The rows are those of the tips' fields.
  const std::vector<estimate::Adjoint>& of_last_step(const StepSolver& solver);

private:
  void condense_rows();
  [[nodiscard]] std::vector<estimate::Adjoint> solve(const StepSolver& solver,
                                                     const std::vector<bool>& closed) const;

  const model::Model& model_;
  const Scene& scene_;
  const std::vector<BodyNet>& bodies_;
  std::vector<base::Matrix> rows_;  ///< [tip][dim * node, 2]
  std::vector<BodyLoad> condensed_; ///< [body] columns: K1 and K2 of the first tip, of the next ..
  std::vector<estimate::Adjoint> last_;
};

} // namespace spricka::run
