// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace spricka::base {

/// What a warning says of the results, the worst first.
enum class ResultConcern {
  no_answer,  ///< there is a number, but it answers nothing
  less_exact, ///< the answer is off by more than meshes, loads or models of this kind are
  odd,        ///< the answer is what the deck asks for: is it what is meant?
};

/// That of the warnings of a code, "W508"; others are odd.
ResultConcern concern_of_warning_code(std::string_view code);

/// "no answer", "less exact" or "odd".
std::string_view display_word(ResultConcern kind);

} // namespace spricka::base
