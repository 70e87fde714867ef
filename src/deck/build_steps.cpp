// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/dimension_rules.hpp"
#include "deck/growth_laws.hpp"
#include "deck/step_actions.hpp"
#include "model/model.hpp"
#include "model/spectrum_runs.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

const std::vector<std::string> k_actions{"LOAD", "FIT", "MOUNT", "DISMOUNT"};

// A second LOAD of a case, FIT of a contact .. in one step: the deck means something else.
bool says_twice(DeckContext& c, const grammar::DataRow& row, const model::Step& step,
                std::string_view verb, std::size_t index) {
  bool twice = false;
  const auto look = [&](const auto& id) { twice = twice || id.index() == index; };
  if (verb == "LOAD") {
    for_each_action<model::ApplyLoad>(step, [&](const auto& load) { look(load.load_case); });
  } else if (verb == "FIT") {
    for_each_action<model::ApplyFit>(step, [&](const auto& fit) { look(fit.contact); });
  } else {
    for_each_mounting(step, [&](base::ContactId contact, bool /*on*/) { look(contact); });
  }
  if (twice) {
    c.error(row.span, "E320",
            fmt::format("{} {} stands twice in this step", verb, row.fields[1].text),
            "a step says how it ends; make two steps");
  }
  return twice;
}

// The name and factor behind LOAD and FIT, the name behind MOUNT and DISMOUNT.
void action(DeckContext& c, const grammar::DataRow& row, model::Step& step) {
  const CardField& verb = row.fields.front();
  const bool loads = verb.text == "LOAD";
  const bool factored = loads || verb.text == "FIT";
  const std::size_t wanted = factored ? 3 : 2;
  if (row.fields.size() != wanted || !row.fields[1].is_name()) {
    c.error(row.span, "E115",
            fmt::format("a line is {} {}{}", verb.text, loads ? "case" : "contact",
                        factored ? " factor" : ""));
    return;
  }
  const NameReference reference{row.fields[1].text, row.fields[1].span, {}};
  const NameDefinition* found =
      find_referenced_definition(c, loads ? EntityKind::load_case : EntityKind::contact, reference);
  const auto factor = factored
                          ? c.read_number(row.fields[2], grammar::QuantityKind::number, "a factor")
                          : std::optional(1.0);
  if (found == nullptr || !factor) {
    return;
  }
  if (says_twice(c, row, step, verb.text, found->index)) {
    return;
  }
  if (loads) {
    step.actions.emplace_back(model::ApplyLoad{base::CaseId(found->index), *factor});
  } else if (verb.text == "FIT") {
    step.actions.emplace_back(model::ApplyFit{base::ContactId(found->index), *factor});
  } else if (verb.text == "MOUNT") {
    step.actions.emplace_back(model::MountContact{base::ContactId(found->index)});
  } else {
    step.actions.emplace_back(model::DismountContact{base::ContactId(found->index)});
  }
}

void step(DeckContext& c, const CheckedCard& card) {
  model::Step step;
  step.name = card.word_value("NAME");
  step.substeps = card.has_key("SUBSTEPS") ? card.integer_value("SUBSTEPS") : 0;
  step.span = card.span;
  for (const grammar::DataRow& row : card.rows) {
    read_step_row(c, row, step);
  }
  if (!card.bad) {
    c.model.steps.push_back(std::move(step));
  }
}

base::StepId step_id(DeckContext& c, const CheckedCard& card, std::string_view key) {
  if (!card.has_key(key)) {
    return {};
  }
  const NameDefinition* found =
      find_referenced_definition(c, EntityKind::step, card.name_reference(key));
  return found == nullptr ? base::StepId() : base::StepId(found->index);
}

// The crack lengths of LAW=INCREMENT, ascending.
void lengths(DeckContext& c, const CheckedCard& card, model::CrackGrowthSettings& growth) {
  for (const grammar::DataRow& row : card.rows) {
    for (const CardField& field : row.fields) {
      const auto a = c.read_number(field, grammar::QuantityKind::length, "a crack length");
      if (!a) {
        continue;
      }
      if (*a <= (growth.lengths.empty() ? 0.0 : growth.lengths.back())) {
        c.error(field.span, "E109",
                growth.lengths.empty()
                    ? fmt::format("{} is no crack length: it is positive", *a)
                    : fmt::format("{} is not longer than {} before it", *a, growth.lengths.back()),
                "crack lengths are positive and grow");
        continue;
      }
      growth.lengths.push_back(*a);
    }
  }
  if (card.rows.empty() && !card.rows_bad) {
    c.error(card.span, "E115", "LAW=INCREMENT needs the crack lengths as data lines");
  }
}

// What ends the growth by a law, and how well it is followed.
void stops(const CheckedCard& card, double tolerance, model::CrackGrowthSettings& growth) {
  growth.largest_advance = card.optional_number("DA");
  growth.last_length = card.optional_number("AMAX");
  growth.cycles = card.optional_number("CYCLES");
  growth.tolerance = card.optional_number("TOL").value_or(tolerance);
  growth.flow_stress = card.optional_number("SFLOW");
  growth.corrected = !card.key_has_word("CORRECT", "NO");
  growth.correction_wanted = card.key_has_word("CORRECT", "YES");
}

void law(DeckContext& c, const CheckedCard& card, model::CrackGrowthSettings& growth) {
  if (growth.law == model::CrackGrowthLaw::increment) {
    lengths(c, card, growth);
  }
  stops(card, dimension_rules.at(c.model.mesh.dim).life_stop, growth);
}

// The loads that a law counts: from step to step, or a spectrum.
void cycles_of(DeckContext& c, const CheckedCard& card, model::CrackGrowthSettings& growth) {
  growth.kmax = step_id(c, card, "KMAX");
  growth.kmin = step_id(c, card, "KMIN");
  if (growth.kmin.valid() && growth.kmin == growth.kmax) {
    c.error(card.find("KMIN")->span, "E110", "KMAX and KMIN name the same step");
  }
  if (card.has_key("SPECTRUM")) {
    if (const NameDefinition* found =
            find_referenced_definition(c, EntityKind::spectrum, card.name_reference("SPECTRUM"))) {
      growth.spectrum = found->index;
    }
  } else if (growth.law != model::CrackGrowthLaw::increment &&
             !(card.has_key("KMAX") && card.has_key("KMIN"))) {
    c.error(card.span, "E106",
            fmt::format("$GROW {} needs KMAX and KMIN, or SPECTRUM",
                        card.has_key("LAW")
                            ? fmt::format("LAW={}", card.word_value("LAW"))
                            : fmt::format("MATERIAL={}", card.name_reference("MATERIAL").name)),
            "the steps with the largest and the smallest K of a cycle, or a load history");
  }
}

void grow(DeckContext& c, const CheckedCard& card) {
  model::CrackGrowthSettings growth;
  model::GrowthLawDefinition said = growth_law_of_card(c, card);
  growth.law = said.law;
  growth.constants = std::move(said.constants);
  growth.data = std::move(said.data);
  growth.direction = card.key_has_word("DIRECTION", "HOOP")     ? model::GrowthDirection::hoop
                     : card.key_has_word("DIRECTION", "K2ZERO") ? model::GrowthDirection::k2_zero
                                                                : model::GrowthDirection::path;
  if (card.has_key("CRACKS")) {
    for (const NameReference& name : card.find("CRACKS")->names) {
      if (const NameDefinition* found = find_referenced_definition(c, EntityKind::crack, name)) {
        growth.cracks.emplace_back(found->index);
      }
    }
  }
  growth.history = card.key_has_word("HISTORY", "CONTINUE") ? model::SlipHistoryOverGrowth::carry_on
                                                            : model::SlipHistoryOverGrowth::restart;
  // a part that keeps what it has slipped keeps what it was mounted with
  growth.mounted = card.key_has_word("MOUNTED", "FIRST") ||
                           growth.history == model::SlipHistoryOverGrowth::carry_on
                       ? model::ContactMountingPolicy::first
                       : model::ContactMountingPolicy::each;
  growth.shape = card.key_has_word("SHAPE", "ELLIPSE") ? model::FrontShapeRule::ellipse
                                                       : model::FrontShapeRule::free;
  growth.span = card.span;
  cycles_of(c, card, growth);
  law(c, card, growth);
  read_growth_interactions(c, card, growth);
  c.model.growth = std::move(growth);
}

// Steps must be complete.
void load_path(DeckContext& c, const CheckedCard& card) {
  model::LoadPathDefinition path;
  path.name = card.word_value("NAME");
  path.from = step_id(c, card, "FROM");
  path.to = step_id(c, card, "TO");
  path.beyond = card.number_value("BEYOND");
  path.span = card.span;
  const std::vector<model::Step>& steps = c.model.steps;
  const bool known = path.from.valid() && path.to.valid() && path.from.index() < steps.size() &&
                     path.to.index() < steps.size();
  if (known && path.from == path.to) {
    c.error(card.find("TO")->span, "E323", "FROM and TO name the same step");
  }
  for (std::size_t s = std::min(path.from.index(), path.to.index()) + 1;
       known && s <= std::max(path.from.index(), path.to.index()); ++s) {
    if (mounts_or_dismounts_contact(steps[s])) {
      c.error(card.span, "E323",
              fmt::format("step {} mounts or dismounts a contact between {} and {}", steps[s].name,
                          steps[path.from.index()].name, steps[path.to.index()].name),
              "let the path begin behind that step, or end before it");
      break;
    }
  }
  c.model.load_paths.push_back(std::move(path));
}

// What rubs first, for a message; empty: nothing does.
std::string what_rubs(const model::Model& model) {
  for (const model::Contact& contact : model.contacts) {
    if (contact.mu > 0.0) {
      return fmt::format("contact {} has friction", contact.name);
    }
  }
  for (const model::CrackDefinition& crack : model.cracks) {
    if (crack.faces_in_contact && crack.mu > 0.0) {
      return fmt::format("the faces of crack {} have friction", crack.name);
    }
  }
  return {};
}

// With friction there is no map over a path; only a growth can follow its loads, as they come.
void paths_with_friction(DeckContext& c) {
  const std::string rubs = what_rubs(c.model);
  const std::optional<model::CrackGrowthSettings>& growth = c.model.growth;
  const bool spectrum = growth && growth->spectrum && *growth->spectrum < c.model.spectra.size();
  for (std::size_t p = 0; p < c.model.load_paths.size() && !rubs.empty(); ++p) {
    if (!(spectrum && c.model.spectra[*growth->spectrum].path == p)) {
      c.error(c.model.load_paths[p].span, "E324",
              rubs + ": what happens on the path depends on how it is walked",
              "MU=0, or steps with SUBSTEPS");
    }
  }
  if (!spectrum || rubs.empty()) {
    return;
  }
  const model::SpectrumDefinition& history = c.model.spectra[*growth->spectrum];
  const std::size_t places =
      model::followed_place_count(model::divide_spectrum_into_blocks(history));
  if (places > model::most_followed_places) {
    c.error(
        history.span, "E327",
        fmt::format("spectrum {} has {} turning points: as {}, each of them is solved, in "
                    "several passes at every crack length, and {} are too many for that (at "
                    "most {})",
                    history.name, places, rubs, places, model::most_followed_places),
        "TYPE=BLOCKS, whose cycles are solved until they repeat; fewer turning points; or MU=0");
  }
}

} // namespace

void read_step_row(DeckContext& context, const grammar::DataRow& row, model::Step& step) {
  const CardField& verb = row.fields.front();
  const bool known = verb.is_name() && std::ranges::find(k_actions, verb.text) != k_actions.end();
  if (known) {
    action(context, row, step);
  } else {
    context.error(verb.span, "E115",
                  fmt::format("a step has no '{}'", context.sources.text(verb.span)),
                  base::make_spelling_hint(verb.text, k_actions));
  }
}

void build_steps(DeckContext& context) {
  build_interactions(context);
  build_growth_laws(context);
  for (const CheckedCard& card : context.cards) {
    if (card.spec->name == "STEP") {
      step(context, card);
    } else if (card.spec->name == "GROW" && !card.bad) {
      grow(context, card);
    }
  }
  context.for_each_sound_card("LOADPATH",
                              [&](const CheckedCard& card) { load_path(context, card); });
  build_spectra(context);
  paths_with_friction(context);
  build_growth_tests(context);
}

} // namespace spricka::deck
