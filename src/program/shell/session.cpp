// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/session.hpp"

#include "deck/typed_line.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"
#include "program/shell/deck_edit.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"
#include "report/topics/result_tables.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Condensed nets that are kept for lengths to come back to.
constexpr std::size_t most_nets = 48;

// What an action is about; of two with the same the later one counts.
std::pair<int, std::size_t> subject(const model::StepAction& action) {
  if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
    return {0, load->load_case.index()};
  }
  if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
    return {1, fit->contact.index()};
  }
  const auto* on = std::get_if<model::MountContact>(&action);
  return {2, on != nullptr ? on->contact.index()
                           : std::get<model::DismountContact>(action).contact.index()};
}

void put(std::vector<model::StepAction>& actions, const model::StepAction& action) {
  std::erase_if(actions, [&](const model::StepAction& a) { return subject(a) == subject(action); });
  actions.push_back(action);
}

bool keeps_mounts(const model::Model& model) {
  return model.growth && model.growth->mounted == model::ContactMountingPolicy::first;
}

// Lengths of $GROW are those of its cracks: begin with the first.
void begin_growth(model::Model& model) {
  if (!model.growth || model.growth->lengths.empty()) {
    return;
  }
  const double a = model.growth->lengths.front();
  model.cracks = growth::scale_solid_cracks(model, a);
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    if (model.cracks[c].is_line() && growth::is_growing_crack(model, c)) {
      model.cracks[c].a0 = a;
    }
  }
}

} // namespace

ShellSession::ShellSession(SessionOptions options) : options_(std::move(options)) {
  set_.pending.name = "NOW";
}

base::OptionalFailure ShellSession::open() {
  return read_again({});
}

// All that depends on the deck is made aside and takes its place at the end. Without a text of its
// cards the deck is read from its file, and nothing is set.
base::OptionalFailure ShellSession::read_again(SessionDeckChanges to) {
  deck::DeckReadOptions options;
  if (to.text) {
    options.own_lengths = to.cracks;
    options.text = deck::write_deck(*to.text, files_.front().parent_path() / ".");
  } else {
    options.defines = options_.defines;
  }
  auto deck = std::make_unique<CheckedDeck>(options_.read(options));
  if (!deck->model) {
    return base::OperationFailure{.kind = deck->refusal.kind, .why = {}, .complete = true};
  }
  ShellSession next(options_);
  next.model_ = std::make_unique<model::Model>(std::move(*deck->model));
  deck->model.reset();
  next.deck_ = std::move(deck);
  next.cache_ = cache_;
  const bool changed = to.text != nullptr;
  if (changed) {
    next.set_ = std::move(to);
    next.files_ = files_;
    next.earlier_ = earlier_;
    next.known_ = known_;
    next.reported_ = reported_;
  } else {
    const std::string leading = report::leading_step_name(*next.model_);
    next.set_.base = static_cast<std::size_t>(
        std::ranges::find(next.model_->steps, leading, &model::Step::name) -
        next.model_->steps.begin());
    auto text = std::make_shared<deck::DeckCardList>();
    if (base::OptionalFailure trouble = read_checked_deck_cards(
            next.deck_->sources.file_name(0), options_.defines, *text, next.files_)) {
      return trouble;
    }
    next.set_.text = std::move(text);
  }
  next.other_cards_ = cards_without_cracks_text(*next.set_.text);
  if (changed && next.other_cards_ == other_cards_ &&
      next.model_->mesh.element_count() == model_->mesh.element_count()) {
    next.plan_ = plan_; // lengths of one deck share them
    next.contact_ = contact_;
    next.memory_ = memory_;
  }
  if (base::OptionalFailure trouble = next.open_model()) {
    return trouble;
  }
  *this = std::move(next);
  return {};
}

base::OptionalFailure ShellSession::open_model() {
  const std::vector<model::CrackDefinition> own = model_->cracks;
  begin_growth(*model_);
  if (plan_.region.empty()) {
    base::Diagnostics diagnostics;
    plan_ = analysis::plan_crack_region(*model_, growth::growth_loop_lengths(*model_), diagnostics);
    if (diagnostics.has_errors()) {
      return located_failure(base::Outcome::deck_error, deck_->sources, diagnostics);
    }
  }
  if (keeps_mounts(*model_) && !memory_) { // what is mounted at the first length, by all steps
    memory_ = std::make_shared<analysis::MountOffsetMemory>();
    std::unique_ptr<InteractiveSolver> first;
    base::OptionalFailure trouble = make_bench(true, first);
    trouble = trouble ? trouble : first->solve_from_unloaded(model_->steps);
    if (trouble) {
      return trouble;
    }
  }
  for (std::size_t c = 0; c < own.size(); ++c) {
    if (set_.cracks.contains(own[c].name)) {
      model_->cracks[c] = own[c];
    }
  }
  if (!set_.cracks.empty()) {
    plan_ = plan_lengths();
  }
  return rebuild();
}

base::OptionalFailure ShellSession::make_bench(bool first,
                                               std::unique_ptr<InteractiveSolver>& bench) {
  base::Diagnostics diagnostics;
  base::OptionalFailure trouble;
  bench = InteractiveSolver::make({.model = *model_,
                                   .cache = *cache_,
                                   .contact = *contact_,
                                   .memory = memory_.get(),
                                   .fills_memory = first,
                                   .threads = options_.threads ? options_.threads(*model_) : 1,
                                   .stopped = options_.stopped},
                                  plan_, diagnostics, trouble);
  return diagnostics.has_errors()
             ? located_failure(base::Outcome::deck_error, deck_->sources, diagnostics)
             : trouble;
}

base::OptionalFailure ShellSession::rebuild() {
  std::unique_ptr<InteractiveSolver> bench;
  if (base::OptionalFailure trouble = make_bench(false, bench)) {
    return trouble;
  }
  if (base::OptionalFailure trouble = bench->solve_from_unloaded(way())) {
    return trouble;
  }
  bench_ = std::move(bench);
  if (cache_->nets.size() > most_nets) {
    std::erase_if(cache_->nets, [](const auto& entry) { return entry.second.use_count() == 1; });
    std::erase_if(cache_->bodies, [](const auto& entry) { return entry.second.use_count() == 1; });
  }
  remember();
  return {};
}

base::OptionalFailure ShellSession::restore_after_failure() {
  return bench_->ready() ? base::OptionalFailure() : rebuild();
}

// Lengths to come are likely to be near: room for half and for half as much again.
analysis::CrackRegionPlan ShellSession::plan_lengths() const {
  const auto join = [](analysis::CrackRegionPlan& plan, const analysis::CrackRegionPlan& more) {
    for (std::size_t e = 0; e < plan.region.size(); ++e) {
      plan.region[e] = plan.region[e] || more.region[e];
    }
  };
  base::Diagnostics ignored;
  analysis::CrackRegionPlan needed = analysis::plan_crack_region(*model_, {0.0, 0.0}, ignored);
  if (!needed.split ||
      (plan_.split && std::ranges::equal(plan_.region, needed.region,
                                         [](bool has, bool needs) { return has || !needs; }))) {
    return needed.split ? plan_ : needed;
  }
  if (plan_.split) {
    join(needed, plan_);
  }
  model::Model near = *model_;
  for (const double times : {0.5, 0.75, 1.25, 1.5}) {
    base::Diagnostics misfit; // a length that does not fit needs no room
    for (std::size_t c = 0; c < near.cracks.size(); ++c) {
      const std::optional<double> a = model_->cracks[c].a0;
      near.cracks[c].a0 = a ? std::optional(times * *a) : std::nullopt;
    }
    const analysis::CrackRegionPlan more = analysis::plan_crack_region(near, {0.0, 0.0}, misfit);
    if (!misfit.has_errors()) {
      join(needed, more);
    }
  }
  return needed;
}

std::vector<model::Step> ShellSession::way_to(std::size_t step) const {
  return {model_->steps.begin(), model_->steps.begin() + static_cast<std::ptrdiff_t>(step) + 1};
}

std::vector<model::Step> ShellSession::way() const {
  std::vector<model::Step> steps = way_to(set_.base);
  steps.insert(steps.end(), set_.applied.begin(), set_.applied.end());
  return steps;
}

base::OptionalFailure ShellSession::go_to_step(const std::string& name) {
  std::vector<std::string> names = candidate_argument_names('s', *model_);
  names.erase(names.begin()); // NOW
  std::size_t index = 0;
  base::OptionalFailure trouble = find_name_index(names, "step", name, index);
  trouble = trouble ? trouble : bench_->solve_from_unloaded(way_to(index));
  if (trouble) {
    return trouble;
  }
  earlier_.push_back(set_);
  set_.base = index;
  set_.applied.clear();
  set_.pending.actions.clear();
  mapped_.clear();
  remember();
  return {};
}

// A contact that changes its state; what is pending the other way is taken back. What is in force
// would count its fit a second time, from bodies that have it already.
base::OptionalFailure ShellSession::goes_on_or_off(base::ContactId contact, bool on) const {
  const std::string& name = model_->contacts[contact.index()].name;
  if (keeps_mounts(*model_)) {
    return invalid_input(
        "with $GROW MOUNTED=FIRST a contact keeps what it took on at the first length: "
        "nothing is mounted or dismounted here");
  }
  const bool pending = std::ranges::any_of(set_.pending.actions, [&](const model::StepAction& a) {
    return subject(a) == std::pair(2, contact.index());
  });
  if (factors().mounted[contact.index()] == on && !pending) {
    return invalid_input(
        fmt::format("contact {} is {} already", name, on ? "mounted" : "absent"),
        on ? "dismount it first: mounted anew, its fit counts from the bodies as they are then"
           : "mount puts it in");
  }
  return {};
}

base::OptionalFailure ShellSession::add_step_line(const std::string& line) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::optional<model::Step> step = deck::read_step_line(*model_, line, sources, diagnostics);
  if (!step) {
    return located_failure(base::Outcome::usage, sources, diagnostics);
  }
  const model::StepAction& action = step->actions.front();
  const auto* fit = std::get_if<model::ApplyFit>(&action);
  if (fit != nullptr && !model_->contacts[fit->contact.index()].gap) {
    const std::string& contact = model_->contacts[fit->contact.index()].name;
    return invalid_input(
        fmt::format("contact {} has no declared fit that a factor could scale", contact),
        fmt::format("$CONTACT NAME={} INTERFERENCE=0.05 declares one", contact));
  }
  SessionDeckChanges to = set_;
  if (subject(action).first == 2) {
    const base::ContactId contact(subject(action).second);
    const bool on = std::holds_alternative<model::MountContact>(action);
    if (base::OptionalFailure trouble = goes_on_or_off(contact, on)) {
      return trouble;
    }
    if (factors().mounted[contact.index()] == on) { // a change that was pending is taken back
      std::erase_if(to.pending.actions,
                    [&](const model::StepAction& a) { return subject(a) == subject(action); });
    } else {
      put(to.pending.actions, action);
    }
  } else {
    put(to.pending.actions, action);
  }
  earlier_.push_back(std::exchange(set_, std::move(to)));
  return {};
}

base::OptionalFailure ShellSession::change_deck(SessionDeckChanges to, deck::DeckCardList text,
                                                const std::string& line) {
  to.text = std::make_shared<deck::DeckCardList>(std::move(text));
  to.lines.push_back(line);
  SessionDeckChanges before = set_;
  base::OptionalFailure trouble = read_again(std::move(to));
  if (!trouble) {
    earlier_.push_back(std::move(before));
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
  SessionDeckChanges to = earlier_.back();
  base::OptionalFailure trouble;
  if (to.text == set_.text) {
    std::swap(set_, to);
    trouble = bench_->solve_from_unloaded(way());
    if (trouble) {
      std::swap(set_, to);
      return trouble;
    }
    mapped_.clear();
    remember();
  } else {
    trouble = read_again(std::move(to));
  }
  if (!trouble) {
    earlier_.pop_back();
  }
  return trouble;
}

base::OptionalFailure ShellSession::solve(int substeps) {
  if (!has_pending_changes()) {
    return {};
  }
  model::Step next = set_.pending;
  next.substeps = has_friction() ? substeps : 1;
  std::vector<model::Step>& applied = set_.applied;
  const std::vector<model::Step> before = applied;
  if (!applied.empty() && !has_friction() && !changes_mounted_contacts(next) &&
      !changes_mounted_contacts(applied.back())) {
    for (const model::StepAction& action : next.actions) {
      put(applied.back().actions, action);
    }
  } else {
    applied.push_back(next);
  }
  if (base::OptionalFailure trouble = bench_->solve_further_step(next, way())) {
    applied = before;
    return trouble;
  }
  set_.pending.actions.clear();
  mapped_.clear();
  remember();
  return {};
}

bool ShellSession::has_friction() const {
  return std::ranges::any_of(model_->contacts, [](const auto& c) { return c.mu > 0.0; }) ||
         std::ranges::any_of(model_->cracks,
                             [](const auto& c) { return c.faces_in_contact && c.mu > 0.0; });
}

} // namespace spricka::program
