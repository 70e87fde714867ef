// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/friction_problem.hpp"

namespace spricka::solve {

/// Whether a sufficient test finds that an increment has one solution whatever its loads and gaps
/// (manual, solve.27).
struct UniquenessResult {
  bool certain = false;
  bool apart_from_motions = false; ///< rigid motions of bodies were left out of the test
};
/// Tries a few weights of the rows until one proves the increment unique; certain without friction.
/// `certain` false says that no trial did, not that there are several solutions.
UniquenessResult check_uniqueness(const FrictionProblem& problem);

} // namespace spricka::solve
