// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/condensed_deck.hpp"

#include "deck/growth_cards.hpp"
#include "grammar/lexeme.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"
#include "program/shell/deck_edit.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Condensed nets that are kept for lengths to come back to.
constexpr std::size_t most_nets = 48;

// Lengths of $GROW are those of its cracks: begin with the first.
void begin_growth(model::Model& model) {
  if (!model.growth || model.growth->lengths.empty()) {
    return;
  }
  const double a = model.growth->lengths.front();
  model.cracks = growth::resize_solid_cracks(model, a);
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    if (model.cracks[c].is_line() && growth::is_growing_crack(model, c)) {
      model.cracks[c].a0 = a;
    }
  }
}

// Lengths to come are likely to be near: room for half and for half as much again.
analysis::CrackRegionPlan plan_lengths(const model::Model& model,
                                       const analysis::CrackRegionPlan& before) {
  const auto join = [](analysis::CrackRegionPlan& plan, const analysis::CrackRegionPlan& more) {
    for (std::size_t e = 0; e < plan.region.size(); ++e) {
      plan.region[e] = plan.region[e] || more.region[e];
    }
  };
  base::Diagnostics ignored;
  analysis::CrackRegionPlan needed = analysis::plan_crack_region(model, {0.0, 0.0}, ignored);
  if (!needed.split ||
      (before.split && std::ranges::equal(before.region, needed.region,
                                          [](bool has, bool needs) { return has || !needs; }))) {
    return needed.split ? before : needed;
  }
  if (before.split) {
    join(needed, before);
  }
  model::Model near = model;
  for (const double times : {0.5, 0.75, 1.25, 1.5}) {
    base::Diagnostics misfit; // a length that does not fit needs no room
    for (std::size_t c = 0; c < near.cracks.size(); ++c) {
      const std::optional<double> a = model.cracks[c].a0;
      near.cracks[c].a0 = a ? std::optional(times * *a) : std::nullopt;
    }
    const analysis::CrackRegionPlan more = analysis::plan_crack_region(near, {0.0, 0.0}, misfit);
    if (!misfit.has_errors()) {
      join(needed, more);
    }
  }
  return needed;
}

} // namespace

CondensedDeck::CondensedDeck(CheckedDeck deck, const deck::DeckCardList& text,
                             const SolverThreadsAndStop& controls)
    : deck_(std::move(deck)), controls_(controls), other_cards_(cards_without_cracks_text(text)),
      growth_(controls) {}

void CondensedDeck::reuse_region(const CondensedDeck& before) {
  if (other_cards_ == before.other_cards_ &&
      model().mesh.element_count() == before.model().mesh.element_count()) {
    plan_ = before.plan_;
    contact_ = before.contact_;
    memory_ = before.memory_;
  }
}

base::OptionalFailure CondensedDeck::open(const SessionDeckChanges& changes) {
  model::Model& model = *deck_.model;
  const std::vector<model::CrackDefinition> own = model.cracks;
  begin_growth(model);
  if (plan_.region.empty()) {
    base::Diagnostics diagnostics;
    plan_ =
        analysis::plan_crack_region(model, growth::growth_loop_crack_lengths(model), diagnostics);
    if (diagnostics.has_errors()) {
      return located_failure(base::ProgramOutcome::deck_error, deck_.sources, diagnostics);
    }
  }
  if (keeps_first_mounting(model) &&
      !memory_) { // what is mounted at the first length, by all steps
    memory_ = std::make_shared<analysis::MountOffsetMemory>();
    std::unique_ptr<InteractiveSolver> first;
    base::OptionalFailure trouble = make_solver(true, first);
    trouble = trouble ? trouble : first->solve_from_unloaded(model.steps);
    if (trouble) {
      return trouble;
    }
  }
  for (std::size_t c = 0; c < own.size(); ++c) {
    if (changes.cracks.contains(own[c].name)) {
      model.cracks[c] = own[c];
    }
  }
  if (!changes.cracks.empty()) {
    plan_ = plan_lengths(model, plan_);
  }
  return renew_solver(changes);
}

base::OptionalFailure CondensedDeck::make_solver(bool first,
                                                 std::unique_ptr<InteractiveSolver>& solver) {
  base::Diagnostics diagnostics;
  base::OptionalFailure trouble;
  solver = InteractiveSolver::make(
      {.model = model(),
       .cache = *cache_,
       .contact = *contact_,
       .memory = memory_.get(),
       .fills_memory = first,
       .threads = controls_.threads ? controls_.threads(model()) : 1,
       .engine = controls_.engine ? controls_.engine(model()) : base::EquationEngine::automatic,
       .stopped = controls_.stopped},
      plan_, diagnostics, trouble);
  return diagnostics.has_errors()
             ? located_failure(base::ProgramOutcome::deck_error, deck_.sources, diagnostics)
             : trouble;
}

base::OptionalFailure CondensedDeck::renew_solver(const SessionDeckChanges& changes) {
  std::unique_ptr<InteractiveSolver> solver;
  if (base::OptionalFailure trouble = make_solver(false, solver)) {
    return trouble;
  }
  if (base::OptionalFailure trouble = solver->solve_from_unloaded(steps_up_to(model(), changes))) {
    return trouble;
  }
  solver_ = std::move(solver);
  if (cache_->nets.size() > most_nets) {
    std::erase_if(cache_->nets, [](const auto& entry) { return entry.second.use_count() == 1; });
    std::erase_if(cache_->bodies, [](const auto& entry) { return entry.second.use_count() == 1; });
  }
  return {};
}

base::OptionalFailure CondensedDeck::change_growth_law(const deck::DeckCardList& text,
                                                       const std::filesystem::path& file,
                                                       base::Diagnostics& news) {
  std::optional<deck::GrowthCards> cards =
      deck::read_growth_cards(model(), text, file, deck_.sources, news);
  if (!cards) {
    return located_failure(base::ProgramOutcome::deck_error, deck_.sources, news);
  }
  model::Model& model = *deck_.model;
  model.growth = std::move(cards->growth);
  model.spectra = std::move(cards->spectra);
  model.interactions = std::move(cards->interactions);
  model.parameters = std::move(cards->parameters);
  other_cards_ = cards_without_cracks_text(text);
  growth_.forget_result();
  return {};
}

std::set<std::string> CondensedDeck::script_constants() const {
  std::set<std::string> names;
  for (const deck::ImportedScript& script : deck_.imported.scripts) {
    for (const mesh::GeometryScriptConstant& constant : script.constants) {
      names.insert(grammar::to_upper(constant.name));
    }
  }
  return names;
}

std::string CondensedDeck::setting_to_compare() const {
  std::string text = other_cards_;
  const analysis::StepActionFactors& f = solver_->action_factors();
  for (Eigen::Index c = 0; c < f.case_factor.size(); ++c) {
    text += fmt::format("{} ", f.case_factor[c]);
  }
  for (std::size_t c = 0; c < model().contacts.size(); ++c) {
    text += fmt::format("{} {} ", f.fit[c], f.mounted[c] ? 1 : 0);
  }
  return text;
}

} // namespace spricka::program
