// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace spricka::program {

/// Whether a word of $CHECK is of a front, at the end of a step, on a load path or a derivative: in
/// the plane K1, DK1.LOAD, PATH.K1 and their like, of one tip; in space K1.AT, G.MAX and theirs.
bool is_front_quantity(std::string_view word);

/// Its value. What the front does not have is Missing.
double evaluate_front_quantity(const std::string& text, CheckArguments& args,
                               const results::RunResult& run);

/// What $CHECK calls a part of the error bar of K where `word` has K: "K1.BAR" (part: BAR) of K and
/// K1, "K2.BEST.PHI" of K2.PHI; empty: the word is not of K itself.
std::string error_bar_part_word(std::string_view word, std::string_view part);

/// What a line of $CHECK that names a place reads there, K1.AT and its like, is of the nearest
/// place of the front: says so where that is more than a twentieth of the front's length away
/// (W574).
std::optional<std::string> far_from_front_warning(const model::ResultCheck& check,
                                                  const std::string& unit,
                                                  const results::RunResult& run);

} // namespace spricka::program
