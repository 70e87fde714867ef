// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <string>
#include <string_view>

namespace spricka::program {

/// Whether $CHECK asks a contact for that word: CPRESS.MAX, ARC.FROM and their like.
bool is_contact_quantity(std::string_view word);

/// The value of such a word. Throws Missing where there is none.
double evaluate_contact_quantity(const model::Model& model, const std::string& word,
                                 CheckArguments& args, const results::RunResult& run);

} // namespace spricka::program
