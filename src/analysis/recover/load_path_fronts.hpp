// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "contact/system.hpp"
#include "results/load_path.hpp"
#include "results/results.hpp"
#include "solve/parametric.hpp"

#include <vector>

/// K of fronts on load paths.
namespace spricka::analysis {

/// Loads and gaps at the end of a step.
struct LoadPathEndStep {
  contact::ContactSystem::IncrementProblem problem;
  base::Vector case_factor;
  results::LoadStepResult result; ///< without its fields
};

/// Adds K of all fronts to a path, and how far it is from that of the steps at the path's ends.
void add_front_K_to_path(const model::Model& model, const Discretisation& scene,
                         const solve::SolutionPath& found, const LoadPathEndStep& from,
                         const LoadPathEndStep& to, results::LoadPathResult& path);

/// Smooth values along the fronts in space of those in `value` [K ..], in their place.
void smooth_K_on_all_fronts(const Discretisation& scene, base::Vector& value);

/// K1 = 0 of `value` [K ..] at points behind which the faces touch, by which rows in force are
/// closed.
void zero_K1_at_closed_points(const Discretisation& scene, const std::vector<std::size_t>& in_force,
                              const std::vector<bool>& closed, base::Vector& value);

} // namespace spricka::analysis
