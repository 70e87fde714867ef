// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string_view>

namespace spricka::base {

/// What solves the equations of a net. Automatic: sparse Cholesky in core while it fits into
/// memory, what needs less where it does not.
enum class EquationEngine { automatic, cholesky, mumps, multigrid };

/// "auto", "cholesky", "mumps", "multigrid".
std::string_view equation_engine_word(EquationEngine engine);

/// Of these words, in capitals or not; empty for another word.
std::optional<EquationEngine> equation_engine_of_word(std::string_view word);

} // namespace spricka::base
