// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"

#include "grammar/lexeme.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

template <class Entities>
void define_entity_names(NameTable& names, EntityKind kind, const Entities& entities) {
  for (std::size_t i = 0; i < entities.size(); ++i) {
    if (!entities[i].name.empty()) {
      names.define(entities[i].name, {kind, i, {}, {}, false});
    }
  }
}

} // namespace

const CheckedCard* DeckContext::find_first_card(std::string_view name) const {
  const auto found =
      std::ranges::find_if(cards, [&](const CheckedCard& card) { return card.spec->name == name; });
  return found == cards.end() ? nullptr : &*found;
}

void DeckContext::report_duplicate_name(const NameDefinition& second, std::string_view name,
                                        const NameDefinition& first) {
  error(second.span, "E302",
        fmt::format("{} {} is defined twice", grammar::display_name(second.kind), name),
        fmt::format("first in line {}", line_number(first.span)));
}

bool DeckContext::has_bad_card(std::string_view name) const {
  return std::ranges::any_of(
      cards, [&](const CheckedCard& card) { return card.spec->name == name && card.bad; });
}

double DeckContext::key_unit_factor(const CheckedCard& card, std::string_view key) const {
  const auto unit = base::parse_unit(card.word_value(key));
  return card.has_key(key) && unit ? base::factor_to_deck_units(*unit, scope.units) : 1.0;
}

const CheckedCard* DeckContext::find_sound_card_named(std::string_view card,
                                                      std::string_view name) const {
  const auto found = std::ranges::find_if(cards, [&](const CheckedCard& one) {
    return one.spec->name == card && !one.bad && one.word_value("NAME") == name;
  });
  return found == cards.end() ? nullptr : &*found;
}

base::NetId DeckContext::find_net(std::string_view name) const {
  const auto found = std::ranges::find(model.nets, name, &model::NetDefinition::name);
  return base::NetId(static_cast<std::size_t>(found - model.nets.begin()));
}

void define_names_of_model(DeckContext& context, const model::Model& model) {
  context.scope.sources = &context.sources;
  for (const auto& [name, value] : model.parameters) {
    context.scope.values.emplace(grammar::to_upper(name), value);
  }
  NameTable& names = context.names;
  define_entity_names(names, EntityKind::load_case, model.cases);
  define_entity_names(names, EntityKind::contact, model.contacts);
  define_entity_names(names, EntityKind::crack, model.cracks);
  define_entity_names(names, EntityKind::step, model.steps);
  names.define("NOW", {EntityKind::step, model.steps.size(), {}, {}, false});
  define_entity_names(names, EntityKind::material, model.materials);
  define_entity_names(names, EntityKind::path, model.load_paths);
  define_entity_names(names, EntityKind::test, model.tests);
  define_entity_names(names, EntityKind::net, model.nets);
  define_entity_names(names, EntityKind::node_set, model.mesh.node_sets);
  define_entity_names(names, EntityKind::element_set, model.mesh.element_sets);
  define_entity_names(names, EntityKind::face_set, model.mesh.face_sets);
}

} // namespace spricka::deck
