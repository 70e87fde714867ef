// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/contacts.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::report {

/// What a contact does at the end of the shown step of the last length, in a sentence: where it
/// touches, the largest pressure and where that is, what was in touch at the end of another step
/// and is not any more. Empty where the step knows nothing of it.
std::string contact_words(const model::Model& model, const results::RunResult& run,
                          const model::Contact& contact);

} // namespace spricka::report
