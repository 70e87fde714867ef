// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/step_factors.hpp"
#include "base/outcome.hpp"
#include "deck/deck_text.hpp"
#include "model/model.hpp"

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace spricka::program {

/// What is set: the deck's cards as they are now, and the steps behind its own.
struct SessionDeckChanges {
  std::shared_ptr<const deck::DeckCardList> text; ///< with -D in its parameters
  std::vector<std::string> lines;                 ///< cards and parameters that were typed
  std::set<std::string> cracks;     ///< that were given keys: $GROW does not set their lengths
  std::size_t base = 0;             ///< the deck's step that the state began with
  std::vector<model::Step> applied; ///< behind it: one step where the order does not count
  model::Step pending;              ///< not solved yet
};

/// Whether contacts keep what they were mounted with at the first length.
bool keeps_first_mounting(const model::Model& model);

/// The deck's steps up to one of them, from the unloaded state.
std::vector<model::Step> steps_up_to(const model::Model& model, std::size_t step);
/// Those to the base step and what came after it: they lead to the present state.
std::vector<model::Step> steps_up_to(const model::Model& model, const SessionDeckChanges& changes);

/// A data line of $STEP becomes an action of the pending step, in place of one about the same load
/// or contact. `now`: in force at the present state. Trouble where a contact is mounted already, or
/// absent, or keeps what it was mounted with.
base::OptionalFailure add_step_action(const model::Model& model,
                                      const analysis::StepActionFactors& now,
                                      const std::string& line, model::Step& pending);

/// Puts what `next` does behind the steps applied so far, into the last of them where the order
/// does not count.
void append_applied_step(const model::Model& model, const model::Step& next,
                         std::vector<model::Step>& applied);

} // namespace spricka::program
