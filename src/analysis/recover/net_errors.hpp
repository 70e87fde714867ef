// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::analysis {

/// Above this part of the energy norm an estimated error is told (W504). Stresses are off by about
/// the same part, on the whole; displacements and energies by its square.
inline constexpr double coarse_mesh = 0.1;

/// Processor ESTIMATE: the errors of the nets at the end of a step, from its strain energies
/// [element]. Elements of crack patches, at a tip and two rings about a single force are left out:
/// they are singular, and K does not need their stresses.
void add_energy_errors(const model::Model& model, const Discretisation& scene,
                       const std::vector<double>& energy, results::LoadStepResult& step);

/// A sentence for each net whose error somewhere in the run is above coarse_mesh, at its worst.
std::vector<std::string> describe_coarse_nets(const results::RunResult& run);

} // namespace spricka::analysis
