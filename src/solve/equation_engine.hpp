// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::solve {

/// What solves the equations of a net. Automatic: sparse Cholesky in core while it fits into
/// memory, what needs less where it does not.
enum class EquationEngine { automatic, cholesky, mumps, multigrid };

} // namespace spricka::solve
