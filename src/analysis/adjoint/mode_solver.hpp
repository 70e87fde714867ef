// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_change.hpp"
#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/scene.hpp"
#include "estimate/space_enrichment.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace spricka::analysis {

/// What the end of a step leaves on the cubic modes, and what answers it.
struct ModeLoad {
  base::Vector residual; ///< loads less elastic forces of the solution [freedoms of modes]
  std::vector<bool> mounted, closed;
  std::shared_ptr<const FrozenContactSystem> system;
};

/// What the cubic modes of one crack length add to K: conjugate gradients on the modes with the
/// nodes eliminated, for several steps at once (manual, estimate.20 to 24).
class CubicModeSolver {
public:
  /// The model and the scene must outlive it; `K`: of the scene.
  CubicModeSolver(const model::Model& model, const Discretisation& scene, const KFunctionals& K);

  [[nodiscard]] const estimate::SolidEnrichment& enrichment() const { return enrichment_; }
  /// By how much K at the ends of steps changes [step][K], of each by its own closed rows; empty:
  /// these give way. Steps whose loads are multiples of each other's, as in load cycles, are solved
  /// for once, also where the other one was solved for before.
  [[nodiscard]] std::vector<std::optional<base::Vector>>
  K_changes(const std::vector<const ModeLoad*>& steps, const KFunctionals& K);

private:
  /// The loads of a step and what they do to K.
  struct ModeSolution {
    ModeLoad of;
    base::Vector change; ///< [K]
    bool failed = false;
  };
  struct Iteration;

  /// What displacements of modes do to the modes' own forces and to K, a column for each step.
  struct ModeResponses {
    base::Matrix force; ///< [freedoms of modes, step]
    base::Matrix K;     ///< [K, step]
    std::vector<bool> failed;
  };
  [[nodiscard]] ModeResponses respond(const std::vector<Iteration*>& steps,
                                      const KFunctionals& K) const;
  /// Goes on by one step of the iteration; false: it is at its end.
  bool advance(Iteration& iteration, const base::Vector& force, const base::Vector& K) const;
  void solve(const std::vector<ModeSolution*>& steps, const KFunctionals& K) const;

  const Discretisation& scene_;
  estimate::SolidEnrichment enrichment_;
  crack::SparseLinearFunctionals goals_;             ///< [freedoms of modes, K]
  std::vector<std::shared_ptr<ModeSolution>> known_; ///< of the last steps
};

} // namespace spricka::analysis
