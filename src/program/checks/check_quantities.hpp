// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "model/requests.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::program {

/// Evaluates a line of $CHECK, which the model need not have, on the results. A quantity that
/// cannot be found (no such length, a point outside the body) fails with the reason in `trouble`.
results::CheckResult evaluate_check(const model::Model& model, const model::ResultCheck& check,
                                    const results::RunResult& run);

/// All lines of the deck.
std::vector<results::CheckResult> evaluate_checks(const model::Model& model,
                                                  const results::RunResult& run);

/// A check as a deck writes its quantity with arguments, "K1.AT(C1,0,46.8,1.5,LOAD)".
std::string check_text(const model::ResultCheck& check);

/// Whether $CHECK finds a value of that word, as it must of all that the catalogue names.
bool is_checkable_quantity(std::string_view word);

/// What $CHECK calls a part of the error bar of K where `word` has K: "K1.BAR" (part: BAR) of K and
/// K1, "K2.RAW.PHI" of K2.PHI; empty: the word is not of K itself.
std::string error_bar_part_quantity_word(std::string_view word, std::string_view part);

/// What a line of $CHECK that names a place reads there, K1.AT and its like, is of the nearest
/// place of the front: says so where that is more than a twentieth of the front's length away
/// (W574).
std::optional<std::string> far_from_front_warning(const model::ResultCheck& check,
                                                  const std::string& unit,
                                                  const results::RunResult& run);

/// Every $TEST against the run: rates from its readings, K from the rates (manual, inversion.md),
/// beside K of the increments at the step KMAX of $GROW, interpolated in log K over log a.
std::vector<results::GrowthTestResult> find_K_from_growth_tests(const model::Model& model,
                                                                const results::RunResult& run);

} // namespace spricka::program
