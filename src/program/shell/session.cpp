// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/session.hpp"

#include "deck/growth_cards.hpp"
#include "model/model.hpp"
#include "program/shell/deck_edit.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"
#include "report/topics/result_tables.hpp"

#include <algorithm>
#include <utility>

namespace spricka::program {

namespace {

// Nothing is set: cards as the file of a deck has them, and the end of its leading step.
base::OptionalFailure begin_changes(const CheckedDeck& deck,
                                    const std::vector<std::pair<std::string, std::string>>& defines,
                                    SessionDeckChanges& to,
                                    std::vector<std::filesystem::path>& files) {
  const std::vector<model::Step>& steps = deck.model->steps;
  const auto leading =
      std::ranges::find(steps, report::leading_step_name(*deck.model), &model::Step::name);
  to.base = static_cast<std::size_t>(leading - steps.begin());
  to.pending.name = "NOW";
  auto text = std::make_shared<deck::DeckCardList>();
  base::OptionalFailure trouble =
      read_checked_deck_cards(deck.sources.file_name(0), defines, *text, files);
  to.text = std::move(text);
  return trouble;
}

} // namespace

// All that depends on the deck is made aside and takes its place at the end. Without a text of its
// cards the deck is read from its file, and nothing is set.
base::OptionalFailure ShellSession::read_again(SessionDeckChanges to) {
  const bool changed = to.text != nullptr;
  deck::DeckReadOptions options;
  if (changed) {
    options.own_lengths = to.cracks;
    options.text = deck::format_deck_card_list(*to.text, files_.front().parent_path() / ".");
  } else {
    options.defines = options_.defines;
  }
  CheckedDeck deck = options_.read(options);
  if (!deck.model) {
    return base::OperationFailure{.kind = deck.refusal.kind, .why = {}, .complete = true};
  }
  std::vector<std::filesystem::path> files;
  if (!changed) {
    if (base::OptionalFailure trouble = begin_changes(deck, options_.defines, to, files)) {
      return trouble;
    }
  }
  auto next = std::make_unique<CondensedDeck>(std::move(deck), *to.text, options_);
  if (deck_) {
    next->reuse_nets(*deck_);
  }
  if (changed) {
    next->reuse_region(*deck_);
  }
  if (base::OptionalFailure trouble = next->open(to)) {
    return trouble;
  }
  if (!changed) {
    files_ = std::move(files);
    earlier_.clear();
    tried_ = {};
    reported_.clear();
  }
  deck_ = std::move(next);
  set_ = std::move(to);
  range_ = {};
  take_state();
  return {};
}

// The state is another one: paths at the state before are of no use.
void ShellSession::take_state() {
  mapped_.clear();
  const results::LoadStepResult& state = current_result();
  if (!state.fronts.empty()) {
    tried_.add(deck_->setting_to_compare(),
               {run_results().increments.front().a, crack_size(model(), state, 0), state.fronts});
  }
}

base::OptionalFailure ShellSession::restore_after_failure() {
  if (deck_->solver().is_ready()) {
    return {};
  }
  base::OptionalFailure trouble = deck_->renew_solver(set_);
  if (!trouble) {
    take_state();
  }
  return trouble;
}

base::OptionalFailure ShellSession::go_to_step(const std::string& name) {
  std::vector<std::string> names = candidate_argument_names('s', model());
  names.erase(names.begin()); // NOW
  std::size_t index = 0;
  base::OptionalFailure trouble = find_name_index(names, "step", name, index);
  trouble = trouble ? trouble : deck_->solver().solve_from_unloaded(steps_up_to(model(), index));
  if (trouble) {
    return trouble;
  }
  earlier_.push_back(set_);
  set_.base = index;
  set_.applied.clear();
  set_.pending.actions.clear();
  take_state();
  return {};
}

base::OptionalFailure ShellSession::add_step_line(const std::string& line) {
  SessionDeckChanges to = set_;
  auto trouble = add_step_action(model(), solver().action_factors(), line, to.pending);
  if (!trouble) {
    earlier_.push_back(std::exchange(set_, std::move(to)));
  }
  return trouble;
}

base::OptionalFailure ShellSession::change_deck(SessionDeckChanges to, deck::DeckCardList text,
                                                const std::string& line) {
  to.text = std::make_shared<deck::DeckCardList>(std::move(text));
  to.lines.push_back(line);
  SessionDeckChanges before = set_;
  base::OptionalFailure trouble = differs_in_growth_law_alone(to) ? change_growth_law(std::move(to))
                                                                  : read_again(std::move(to));
  if (!trouble) {
    earlier_.push_back(std::move(before));
  }
  return trouble;
}

bool ShellSession::differs_in_growth_law_alone(const SessionDeckChanges& to) const {
  return deck::differ_in_growth_law_alone(*set_.text, *to.text, deck_->script_constants());
}

// The state does not depend on it.
base::OptionalFailure ShellSession::change_growth_law(SessionDeckChanges to) {
  base::Diagnostics news;
  base::OptionalFailure trouble = deck_->change_growth_law(*to.text, files_.front(), news);
  if (!trouble) {
    set_ = std::move(to);
    if (options_.report) {
      options_.report(deck_->sources(), news);
    }
  }
  return trouble;
}

base::OptionalFailure ShellSession::change_card(const std::string& header) {
  deck::DeckCardList text = *set_.text;
  std::size_t card = 0;
  if (base::OptionalFailure trouble = set_card_keys(header, text, card)) {
    return trouble;
  }
  SessionDeckChanges to = set_;
  if (text[card].name == "CRACK") {
    to.cracks.insert(text[card].word_value("NAME"));
  }
  return change_deck(std::move(to), std::move(text), header);
}

base::OptionalFailure ShellSession::change_parameter(const std::string& line) {
  deck::DeckCardList text = *set_.text;
  base::OptionalFailure trouble = set_parameter(line, text);
  return trouble ? trouble : change_deck(set_, std::move(text), line);
}

base::OptionalFailure ShellSession::undo() {
  if (earlier_.empty()) {
    return invalid_input("nothing has been changed");
  }
  const SessionDeckChanges to = earlier_.back();
  const bool same_cards = to.text == set_.text;
  if (!same_cards && differs_in_growth_law_alone(to)) {
    base::OptionalFailure trouble = change_growth_law(to);
    if (!trouble) {
      earlier_.pop_back();
    }
    return trouble;
  }
  if (base::OptionalFailure trouble =
          same_cards ? deck_->solver().solve_from_unloaded(steps_up_to(model(), to))
                     : read_again(to)) {
    return trouble;
  }
  if (same_cards) {
    set_ = to;
    take_state();
  }
  earlier_.pop_back();
  return {};
}

base::OptionalFailure ShellSession::solve(int substeps) {
  if (!has_pending_changes()) {
    return {};
  }
  model::Step next = set_.pending;
  next.substeps = has_friction() ? substeps : 1;
  const std::vector<model::Step> before = set_.applied;
  append_applied_step(model(), next, set_.applied);
  if (base::OptionalFailure trouble =
          deck_->solver().solve_further_step(next, steps_up_to(model(), set_))) {
    set_.applied = before;
    return trouble;
  }
  set_.pending.actions.clear();
  take_state();
  return {};
}

} // namespace spricka::program
