// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "model/requests.hpp"
#include "results/results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace spricka::program {

/// Evaluates every line of $CHECK on the results. A quantity that cannot be found (no such length,
/// a point outside the body) fails with the reason in `trouble`.
std::vector<results::CheckResult> evaluate_checks(const model::Model& model,
                                                  const results::RunResult& run);
/// The same of one line, which the model need not have.
results::CheckResult evaluate_check(const model::Model& model, const model::ResultCheck& check,
                                    const results::RunResult& run);

/// A check as a deck writes its quantity with arguments, "K1.AT(C1,0,46.8,1.5,LOAD)".
std::string check_text(const model::ResultCheck& check);

/// Whether $CHECK finds a value of that word, as it must of all that the catalogue names.
bool is_checkable_quantity(std::string_view word);

} // namespace spricka::program
