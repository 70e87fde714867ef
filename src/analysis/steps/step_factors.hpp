// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::analysis {

/// What the steps' actions have set so far.
struct StepActionFactors {
  /// [case], and 1 for what ties always ask for (Discretisation::case_load)
  base::Vector case_factor;
  std::vector<double> fit;   ///< [contact]
  std::vector<bool> mounted; ///< [contact]
};

/// Before the first step: no loads; a contact is absent if some step mounts it, its fit is 0 if
/// some step names it. `columns` are those of Discretisation::case_load; `contacts` behind the
/// deck's are in force from the first step on.
StepActionFactors initial_step_factors(const model::Model& model, Eigen::Index columns,
                                       std::size_t contacts);

/// A part of the way from one set of factors to another, 1: all of it; contacts as at its end.
StepActionFactors interpolate_step_factors(const StepActionFactors& from,
                                           const StepActionFactors& to, double part);

/// Whether some step sets the factor of a contact's fit.
bool is_fit_set_by_steps(const model::Model& model, base::ContactId contact);

/// Whether some step mounts a contact: it is absent before the first that does.
bool is_mounted_by_steps(const model::Model& model, base::ContactId contact);

/// The contacts that a step mounts or dismounts.
struct MountChanges {
  std::vector<std::size_t> mounted;
  std::vector<std::size_t> dismounted;
};

/// Carries out the actions of a step.
MountChanges apply_step_actions(const model::Step& step, StepActionFactors& factors);

/// By step an earlier one that ends in the same state, if there is one: the same factors, nothing
/// mounted or dismounted in between, no friction anywhere. [step]
std::vector<std::optional<std::size_t>> repeated_steps(const model::Model& model);

} // namespace spricka::analysis
