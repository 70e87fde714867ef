// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"
#include "base/outcome.hpp"
#include "results/named_arrays.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Slips, gaps and loads at the moment when the cracks grew, for the next length
/// ($GROW HISTORY=CONTINUE). It holds for the deck's contacts; what faces of cracks did to each
/// other is not carried: they are others.
class InheritedContactState {
public:
  [[nodiscard]] bool empty() const { return contacts_.empty(); }

  /// Keeps a place of a solver on this scene.
  void store_state(const Discretisation& scene, const StepSolverState& place);
  /// The same place on another scene; `now` is where its solver is, for what is not carried. Empty:
  /// the rows of a contact are not those they were; `trouble` says so.
  [[nodiscard]] std::optional<StepSolverState> put(const Discretisation& scene,
                                                   const StepSolverState& now,
                                                   base::OptionalFailure& trouble) const;

  /// As arrays "carried...", for a restart file.
  void save_state(results::NamedArrays& arrays) const;
  /// From those; what is not there has not been carried.
  static InheritedContactState restore_state(const results::NamedArrays& arrays);

private:
  /// One of the deck's contacts.
  struct InheritedContactPair {
    std::vector<std::int64_t> key;          ///< of its rows
    std::vector<double> offset, slip, path; ///< [row]
    std::vector<double> pressure;           ///< [row]
    std::vector<std::int64_t> touch;        ///< [row]
    double work = 0.0, fit = 0.0;
    bool mounted = false;
  };
  std::vector<InheritedContactPair> contacts_;
  std::vector<double> case_factor_, alpha_;
};

} // namespace spricka::analysis
