// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>

namespace spricka::program {

/// Whether a word of $CHECK is of a front in space: K1.AT, G.MAX and their like.
bool is_front_quantity(std::string_view word);

/// Its value. What the front does not have is Missing.
double front_quantity(const std::string& text, CheckArguments& args, const results::RunResult& run);

/// What a line of $CHECK that names a place reads there, K1.AT and its like, is of the nearest
/// place of the front: says so where that is more than a twentieth of the front's length away
/// (W574).
std::optional<std::string> far_from_front(const model::ResultCheck& check, const std::string& unit,
                                          const results::RunResult& run);

} // namespace spricka::program
