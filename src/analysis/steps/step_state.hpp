// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/friction_history.hpp"
#include "base/sparse.hpp"
#include "results/note.hpp"

#include <string>
#include <vector>

/// What a step of the deck ends with.
namespace spricka::analysis {

/// The state at the end of a step.
struct StepState {
  base::Vector u;                             ///< [dim * node]
  base::Vector case_factor;                   ///< [case]
  base::Vector temperature;                   ///< [connectivity index]; empty: nothing is heated
  std::vector<base::Vector> pair_lambda;      ///< [contact][row of the pair] pressures; 0 if absent
  std::vector<base::Vector> pair_gap;         ///< [contact][normal row] weighted
  std::vector<std::vector<bool>> pair_closed; ///< [contact][normal row]
  std::vector<bool> mounted;                  ///< [contact]
  std::vector<PairFrictionState> friction;    ///< [contact]
  base::Vector force;                         ///< [dim * node] applied loads
  base::Vector contact;                       ///< [dim * node] contact forces
  base::Vector reaction;                      ///< [dim * node] support forces
  /// [dim * node] what contact forces leave over on motions by which surfaces slide on themselves;
  /// empty: nothing
  base::Vector resting;
  base::Matrix internal;      ///< [dim * node, material] internal forces K u; without cracks of all
  base::Vector tie;           ///< [dim * node] forces of ties; empty: there are none
  std::vector<double> energy; ///< [element] strain energy
  double imbalance = 0.0;     ///< largest force left over at a free freedom, over the force scale
  int iterations = 0, pivots = 0;
  int increments = 1; ///< solved in this step; more than 1 only where contacts rub
  std::vector<results::Note> notes;
};

} // namespace spricka::analysis
