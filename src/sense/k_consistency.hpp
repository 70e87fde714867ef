// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>
#include <vector>

/// K found in two ways that should agree: by the near-tip fields, by the energy release rate, by
/// domains of different size, by the opening of the faces.
namespace spricka::sense {

/// A K of which two ways part by more than its error bar and what they differ by on sound meshes.
struct KMismatch {
  const results::Increment* increment = nullptr;
  const results::StepResult* step = nullptr;
  const results::TipResult* tip = nullptr;
  std::string what; ///< "G = 1.92e-06 and (K1^2 + K2^2)/E' = 1.86e-06: as K, 1.6 % apart .."
};

/// K that round-off leaves of displacements that do not open a crack of size `a` [length], or of
/// pressure that keeps its faces closed where nothing else moves; E' as `E` [stress].
double k_round_off_level(const results::StepResult& step, double E, double a);

/// The ways that part at one tip of a step; empty: they agree, there is but one, or K is round-off.
std::string describe_tip_mismatch(const results::StepResult& step, const results::TipResult& tip);

/// All of a run, but for tips that nothing loads. They look into `run`.
std::vector<KMismatch> find_k_mismatches(const results::RunResult& run);

/// One line for each tip, the worst of its steps and lengths.
std::vector<std::string> k_consistency_warnings(const results::RunResult& run);

} // namespace spricka::sense
