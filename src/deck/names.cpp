// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/names.hpp"

#include "base/diagnostics.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

std::string_view net_of(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view() : name.substr(0, dot);
}

std::string_view last_part(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

} // namespace

std::string qualified_name(const std::string& net, const std::string& name) {
  return net.empty() ? name : net + "." + name;
}

std::vector<EntityKind> accepted_kinds(EntityKind kind) {
  switch (kind) {
  case EntityKind::set:
  case EntityKind::node_set:
    return {EntityKind::node_set, EntityKind::face_set};
  case EntityKind::face_set:
    return {EntityKind::face_set, EntityKind::node_set};
  case EntityKind::any_set:
    return {EntityKind::node_set, EntityKind::face_set, EntityKind::element_set};
  case EntityKind::surface:
    return {EntityKind::face_set, EntityKind::node_set, EntityKind::rigid};
  default:
    return {kind};
  }
}

const NameDefinition* NameTable::define(const std::string& name, const NameDefinition& definition) {
  const auto [it, fresh] = table_.try_emplace({definition.kind, name}, definition);
  return fresh ? nullptr : &it->second;
}

void NameTable::poison(EntityKind kind, const std::string& name) {
  const auto [it, fresh] = table_.try_emplace({kind, name}, NameDefinition{.kind = kind});
  it->second.poisoned = true;
}

void NameTable::mark_set_built(EntityKind kind, const std::string& name, std::size_t index) {
  NameDefinition& definition = table_.at({kind, name});
  definition.index = index;
  definition.card.reset();
}

const NameDefinition* NameTable::find(const std::vector<EntityKind>& kinds, const std::string& name,
                                      const std::string& net) const {
  if (!net.empty()) {
    for (const EntityKind kind : kinds) {
      if (const auto it = table_.find({kind, qualified_name(net, name)}); it != table_.end()) {
        return &it->second;
      }
    }
  }
  for (const EntityKind kind : kinds) {
    if (const auto it = table_.find({kind, name}); it != table_.end()) {
      return &it->second;
    }
  }
  return nullptr;
}

bool NameTable::is_poisoned(const std::vector<EntityKind>& kinds, const std::string& name,
                            const std::string& net) const {
  const bool kind_poisoned =
      std::ranges::any_of(kinds, [&](EntityKind k) { return kinds_.contains(k); });
  if (everything_ || kind_poisoned || words_.contains(std::string(last_part(name))) ||
      words_.contains(name)) {
    return true;
  }
  const std::string own(net_of(name)); // or the crack whose face it is
  return nets_.contains(own) || (!own.empty() && words_.contains(own)) ||
         (own.empty() && !net.empty() && nets_.contains(net));
}

std::string NameTable::describe_other_kind(const std::vector<EntityKind>& kinds,
                                           const std::string& name) const {
  for (const auto& [key, definition] : table_) {
    if (key.second == name && std::ranges::find(kinds, key.first) == kinds.end()) {
      const std::string_view word = grammar::display_name(key.first);
      const bool faces = std::ranges::find(kinds, EntityKind::face_set) != kinds.end();
      return fmt::format("'{0}' is {1} {2}{3}", name, word.front() == 'e' ? "an" : "a", word,
                         key.first == EntityKind::crack && faces
                             ? fmt::format("; a pressure on both of its faces is $LOAD TYPE=FACES, "
                                           "on one of them {0}.LEFT or {0}.RIGHT is loaded",
                                           name)
                             : "");
    }
  }
  return {};
}

std::string NameTable::similar_name_hint(const std::vector<EntityKind>& kinds,
                                         const std::string& name) const {
  std::vector<std::string> valid;
  std::vector<std::string> same_word;
  for (const auto& [key, definition] : table_) {
    if (std::ranges::find(kinds, key.first) != kinds.end()) {
      valid.push_back(key.second);
      if (last_part(key.second) == last_part(name)) {
        same_word.push_back(key.second);
      }
    }
  }
  if (same_word.empty()) {
    const std::string other = describe_other_kind(kinds, name);
    return valid.empty() && other.empty() ? "the deck defines none"
           : other.empty()                ? base::make_spelling_hint(name, valid)
                                          : other;
  }
  return same_word.size() == 1 ? fmt::format("did you mean '{}'?", same_word.front())
                               : fmt::format("one of: {}", fmt::join(same_word, ", "));
}

} // namespace spricka::deck
