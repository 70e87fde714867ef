// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/save.hpp"

#include "analysis/steps/step_factors.hpp"
#include "deck/step_actions.hpp"
#include "model/model.hpp"
#include "program/shell/deck_edit.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// The lengths of $GROW are gone with its card.
void set_grown_lengths(const model::Model& model, deck::DeckCardList& text) {
  for (const model::CrackDefinition& crack : model.cracks) {
    deck::DeckCard* const card = find_card_with_key_value(text, "CRACK", "NAME", crack.name);
    if (crack.kind == model::CrackDefinitionKind::ellipse) {
      card->set_key("A", fmt::format("{}", crack.plane.a));
      card->set_key("C", fmt::format("{}", crack.plane.c));
    } else if (crack.a0) {
      card->set_key("A0", fmt::format("{}", *crack.a0));
    }
  }
}

// Where the order does not count, one step with every factor as it is.
model::Step all_factors(const ShellSession& session) {
  model::Step step;
  const model::Model& model = session.model();
  const analysis::StepActionFactors& now = session.solver().action_factors();
  for (std::size_t c = 0; c < model.cases.size(); ++c) {
    step.actions.emplace_back(
        model::ApplyLoad{base::CaseId(c), now.case_factor[static_cast<Eigen::Index>(c)]});
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    if (model.contacts[c].gap &&
        (now.fit[c] != 1.0 || analysis::is_fit_set_by_steps(model, base::ContactId(c)))) {
      step.actions.emplace_back(model::ApplyFit{base::ContactId(c), now.fit[c]});
    }
  }
  return step;
}

base::OptionalFailure add_steps(const ShellSession& session, deck::DeckCardList& text) {
  const model::Model& model = session.model();
  const bool last = session.base_step_name() == model.steps.back().name;
  std::vector<model::Step> steps = session.changes().applied;
  const bool ordered = session.has_friction() ||
                       std::ranges::any_of(steps, deck::mounts_or_dismounts_contact) ||
                       std::ranges::any_of(model.steps, deck::mounts_or_dismounts_contact);
  if (steps.empty() && last) {
    return {}; // the deck's last step is the state
  }
  if (!ordered) {
    steps = {all_factors(session)};
  } else if (!last) {
    return invalid_input(
        fmt::format("the state goes on from step {}, but the deck has steps behind it, "
                    "and with friction or mounted contacts the order counts",
                    session.base_step_name()),
        fmt::format("step {} and the changes again", model.steps.back().name));
  }
  append_steps(model, steps, text);
  return {};
}

} // namespace

base::OptionalFailure make_saved_deck_text(const ShellSession& session,
                                           const std::filesystem::path& folder, std::string& text) {
  const model::Model& model = session.model();
  deck::DeckCardList cards = *session.changes().text;
  if (model.growth) {
    set_grown_lengths(model, cards);
  }
  if (base::OptionalFailure trouble = add_steps(session, cards)) {
    return trouble;
  }
  const std::set<std::string> of_runs{"GROW", "SWEEP", "RESTART", "TEST"};
  const bool other_values = session.has_changed_cards() || model.growth;
  for (std::size_t i = 0; i < cards.size();) {
    if (of_runs.contains(cards[i].name) || (cards[i].name == "CHECK" && other_values)) {
      comment_out_card(cards, i);
    } else {
      ++i;
    }
  }
  text = deck::format_deck_card_list(std::move(cards), folder);
  return {};
}

} // namespace spricka::program
