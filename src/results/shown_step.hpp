// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

/// The step whose state a run shows first: in pictures, in the head of the report, in comparisons.
namespace spricka::results {

/// That which the deck names: SHOW of $CONTROL, else KMAX of a growth; empty: it names none.
std::optional<std::size_t> shown_step_of_deck(const model::Model& model);

/// By index into `increment.steps`: the step with the largest K, of energy release rates where
/// there is no K; where neither is, with the largest contact pressure, else with the most strain
/// energy. The first of those that are as large. The increment has steps.
std::size_t most_loaded_step(const CrackLengthResult& increment);

/// Its name: that which the deck names, else the most loaded one at the first length, so that
/// all lengths show the same one. Without lengths the deck's last step, without steps empty.
std::string shown_step_name(const model::Model& model,
                            std::span<const CrackLengthResult> increments);

/// The results of the shown step in one of the increments, where there are none those of its last
/// step; null without steps.
const LoadStepResult* shown_step_result(const model::Model& model,
                                        std::span<const CrackLengthResult> increments,
                                        const CrackLengthResult& increment);

} // namespace spricka::results
