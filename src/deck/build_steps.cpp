// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::Field;

const std::vector<std::string> k_actions{"LOAD", "FIT", "MOUNT", "DISMOUNT"};

// The name and factor behind LOAD and FIT, the name behind MOUNT and DISMOUNT.
void action(Context& c, const BoundCard& card, const grammar::Row& row, model::Step& step) {
  const Field& verb = row.fields.front();
  const bool loads = verb.text == "LOAD";
  const bool factored = loads || verb.text == "FIT";
  const std::size_t wanted = factored ? 3 : 2;
  if (row.fields.size() != wanted || row.fields[1].kind != Field::Kind::name) {
    c.error(row.span, "E115",
            fmt::format("a line is {} {}{}", verb.text, loads ? "case" : "contact",
                        factored ? " factor" : ""));
    return;
  }
  const Reference reference{row.fields[1].text, row.fields[1].span, {}};
  const Definition* found = look_up(c, loads ? Kind::load_case : Kind::contact, reference);
  const auto factor = factored ? number_of(row.fields[2], grammar::Quantity::number, "a factor",
                                           c.scope, c.diagnostics)
                               : std::optional(1.0);
  if (found == nullptr || !factor) {
    return;
  }
  if (loads) {
    step.actions.emplace_back(model::ApplyLoad{base::CaseId(found->index), *factor});
  } else if (verb.text == "FIT") {
    step.actions.emplace_back(model::ApplyFit{base::ContactId(found->index), *factor});
  } else if (verb.text == "MOUNT") {
    step.actions.emplace_back(model::Mount{base::ContactId(found->index)});
  } else {
    step.actions.emplace_back(model::Dismount{base::ContactId(found->index)});
    c.unavailable(fmt::format("${} DISMOUNT", card.spec->name), row.span);
  }
}

void step(Context& c, const BoundCard& card) {
  model::Step step;
  step.name = card.word("NAME");
  step.substeps = card.integer("SUBSTEPS");
  step.span = card.span;
  for (const grammar::Row& row : card.rows) {
    const Field& verb = row.fields.front();
    const bool known = verb.kind == Field::Kind::name &&
                       std::find(k_actions.begin(), k_actions.end(), verb.text) != k_actions.end();
    if (known) {
      action(c, card, row, step);
    } else {
      c.error(verb.span, "E115", fmt::format("a step has no '{}'", c.sources.text(verb.span)),
              base::suggest(verb.text, k_actions));
    }
  }
  if (!card.bad) {
    c.model.steps.push_back(std::move(step));
  }
}

model::GrowthLaw law_of(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, model::GrowthLaw>, 6> laws{
      {{"INCREMENT", model::GrowthLaw::increment},
       {"PARIS", model::GrowthLaw::paris},
       {"WALKER", model::GrowthLaw::walker},
       {"FORMAN", model::GrowthLaw::forman},
       {"NASGRO", model::GrowthLaw::nasgro},
       {"TABLE", model::GrowthLaw::table}}};
  for (const auto& [name, law] : laws) {
    if (name == word) {
      return law;
    }
  }
  return model::GrowthLaw::increment;
}

base::StepId step_id(Context& c, const BoundCard& card, std::string_view key) {
  if (!card.has(key)) {
    return {};
  }
  const Definition* found = look_up(c, Kind::step, card.reference(key));
  return found == nullptr ? base::StepId() : base::StepId(found->index);
}

// The crack lengths of LAW=INCREMENT, ascending.
void lengths(Context& c, const BoundCard& card, model::Growth& growth) {
  if (growth.law != model::GrowthLaw::increment) {
    if (!card.rows.empty() && growth.law != model::GrowthLaw::table) {
      c.error(card.rows.front().span, "E115",
              fmt::format("LAW={} takes no data lines", card.word("LAW")));
    }
    return;
  }
  for (const grammar::Row& row : card.rows) {
    for (const Field& field : row.fields) {
      const auto a =
          number_of(field, grammar::Quantity::length, "a crack length", c.scope, c.diagnostics);
      if (!a) {
        continue;
      }
      if (*a <= (growth.lengths.empty() ? 0.0 : growth.lengths.back())) {
        c.error(field.span, "E109", "crack lengths are positive and grow");
      }
      growth.lengths.push_back(*a);
    }
  }
  if (card.rows.empty() && !card.rows_bad) {
    c.error(card.span, "E115", "LAW=INCREMENT needs the crack lengths as data lines");
  }
}

void grow(Context& c, const BoundCard& card) {
  model::Growth growth;
  growth.law = law_of(card.word("LAW"));
  growth.direction = card.is("DIRECTION", "HOOP")     ? model::GrowthDirection::hoop
                     : card.is("DIRECTION", "K2ZERO") ? model::GrowthDirection::k2_zero
                                                      : model::GrowthDirection::path;
  if (card.has("CRACKS")) {
    for (const Reference& name : card.find("CRACKS")->names) {
      if (const Definition* found = look_up(c, Kind::crack, name)) {
        growth.cracks.emplace_back(found->index);
      }
    }
  }
  growth.kmax = step_id(c, card, "KMAX");
  growth.kmin = step_id(c, card, "KMIN");
  growth.history =
      card.is("HISTORY", "CONTINUE") ? model::History::carry_on : model::History::restart;
  growth.mounted = card.is("MOUNTED", "FIRST") ? model::Mounted::first : model::Mounted::each;
  growth.span = card.span;
  lengths(c, card, growth);
  c.model.growth = std::move(growth);
}

} // namespace

void build_steps(Context& context) {
  for (const BoundCard& card : context.cards) {
    if (card.spec->name == "STEP") {
      step(context, card);
    } else if (card.spec->name == "GROW" && !card.bad) {
      grow(context, card);
    }
  }
}

} // namespace spricka::deck
