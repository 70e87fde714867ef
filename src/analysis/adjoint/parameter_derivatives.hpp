// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"
#include "results/results.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What K of tips and fronts depends on, and how results come by their derivatives; [K] is by
/// crack::KLayout.
namespace spricka::analysis {

/// One thing that K depends on: loads, gaps and a part of K that it changes by itself.
struct ParameterPartialDerivatives {
  results::Sensitivity is; ///< without its derivatives
  base::Vector load;       ///< [dim * node] by its value; empty: none
  base::Vector gap;        ///< [table row] by its value; empty: none
  base::Vector direct;     ///< [K] dK by its value with u kept
};

/// K of the step that `solver` solved last as a function of loads and displacements.
struct SolvedStepKFunction {
  const model::Model& model;
  const Discretisation& scene;
  const StepSolver& solver;
  const StepState& state;
  const base::Matrix& case_load; ///< [dim * node, case] with the pull of supports
  const base::Matrix&
      of_loads; ///< [K, case] what loads add to K themselves (K_added_by_load_cases)
  /// [K] of displacements [dim * node].
  std::function<base::Vector(const base::Vector&)> of_displacements;
};

/// The derivatives by loads, then those by fits.
std::vector<ParameterPartialDerivatives>
load_and_fit_partial_derivatives(const SolvedStepKFunction& K);
/// Adds a derivative by each material's modulus: by the loads of its elements, and at points in it
/// by the modulus in K itself.
void add_modulus_partial_derivatives(const SolvedStepKFunction& K,
                                     std::vector<ParameterPartialDerivatives>& causes);

/// Loads or gaps of the causes, each of that size; zero where a cause has none. [size, cause]
base::Matrix gather_load_or_gap_columns(std::span<const ParameterPartialDerivatives> causes,
                                        base::Vector ParameterPartialDerivatives::*part,
                                        Eigen::Index size);

/// A note on derivatives for all fronts, once.
void add_sensitivity_note(const std::string& text, results::LoadStepResult& result);

/// [cause] how far down and up its value goes until the contact changes; empty: not known.
using LinearRanges = std::vector<std::optional<std::array<double, 2>>>;
/// Of causes that no contact ends.
LinearRanges unbounded_ranges(std::size_t causes);

/// Gives the fronts all causes, without their derivatives.
void add_sensitivity_parameters(const std::vector<ParameterPartialDerivatives>& causes,
                                results::LoadStepResult& result);
/// Gives the points of the fronts dK [K] of a listed cause on one side of its value, `below` or
/// `above`.
void store_one_sided_derivative(const crack::KLayout& layout, const base::Vector& dK,
                                std::size_t cause,
                                std::vector<std::array<double, 3>> results::Sensitivity::*side,
                                results::LoadStepResult& result);
/// The same on both sides alike, dK [K, cause], and the ranges.
void store_derivatives(const crack::KLayout& layout, const base::Matrix& dK,
                       const LinearRanges& reach, results::LoadStepResult& result);

} // namespace spricka::analysis
