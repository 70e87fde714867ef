// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/factor_report.hpp"

#include <array>

namespace spricka::solve {

/// A net as a law of its cost knows it: how many unknowns, in a box of how many cells.
struct NetOutline {
  int dim = 2;
  std::array<double, 3> cells{1.0, 1.0, 1.0}; ///< elements along each axis, on the average
  double locals = 0.0;                        ///< unknowns
  double externals = 0.0;                     ///< unknowns that are kept to the end, full
  double rows = 0.0;           ///< of contact, eliminated with the locals' factor; 0: none are
  double layer_share = 1.0;    ///< of the unknowns of a cell, those in one plane of nodes
  double row_neighbours = 1.0; ///< nodes that a node shares elements with, itself included
};

/// Fill, flops, memory and time of analysis of a net's factor by the law of nested dissection
/// (solve.40): the box is halved across its longest side again and again, and every plane of nodes
/// that does so is eliminated as one full front. No matrix is looked at: flops are right within a
/// factor of two, mostly.
FactorReport estimate_factor(const NetOutline& net);

} // namespace spricka::solve
