// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/contact_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Solves the problem exactly: block pivoting (primal-dual active set) from `start` (empty: all
/// closed), and if that does not settle, criss-cross pivoting with least index (Klafszky and
/// Terlaky 1992; Fukuda and Terlaky 1992), which is finite for semidefinite W and redundant rows.
/// The answer does not depend on `start` where displacements are unique.
ContactSolution solve_contact(const ContactProblem& problem, const ContactSettings& settings,
                              const std::vector<bool>& start);

} // namespace spricka::solve
