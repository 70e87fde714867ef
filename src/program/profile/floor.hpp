// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"

#include <cstdint>
#include <string>

namespace spricka::program {

/// The least that any direct finite-element code has to do for a deck: one plain sparse
/// factorisation of the stiffness of all bodies at the first crack length, as the deck ties them
/// and without contact, and one solution with it.
struct FactorisationCostFloor {
  std::string why_not;        ///< why there is none; empty: there is
  std::int64_t equations = 0; ///< rows of the matrix
  double entries = 0.0;       ///< nonzeros of the factor
  double flops = 0.0;         ///< of the numeric phase
  /// [s] of processor time on one thread, the least of `times`.
  double assembly = 0.0, analysis = 0.0, numeric = 0.0, solution = 0.0;
  int times = 0;

  /// Without the assembly [s].
  [[nodiscard]] double seconds_without_assembly() const { return analysis + numeric + solution; }
};

/// Cuts the cracks of the first length anew and factorises; what is quick several times.
FactorisationCostFloor measure_factorisation_cost_floor(const model::Model& model);

} // namespace spricka::program
