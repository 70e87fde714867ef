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

std::string qualify(const std::string& net, const std::string& name) {
  return net.empty() ? name : net + "." + name;
}

std::vector<Kind> meanings(Kind kind) {
  switch (kind) {
  case Kind::set:
  case Kind::node_set:
    return {Kind::node_set, Kind::face_set};
  case Kind::face_set:
    return {Kind::face_set, Kind::node_set};
  case Kind::any_set:
    return {Kind::node_set, Kind::face_set, Kind::element_set};
  case Kind::surface:
    return {Kind::face_set, Kind::node_set, Kind::rigid};
  default:
    return {kind};
  }
}

const Definition* Names::define(const std::string& name, const Definition& definition) {
  const auto [it, fresh] = table_.try_emplace({definition.kind, name}, definition);
  return fresh ? nullptr : &it->second;
}

void Names::poison(Kind kind, const std::string& name) {
  Definition definition;
  definition.kind = kind;
  definition.poisoned = true;
  const auto [it, fresh] = table_.try_emplace({kind, name}, definition);
  it->second.poisoned = true;
}

void Names::built(Kind kind, const std::string& name, std::size_t index) {
  Definition& definition = table_.at({kind, name});
  definition.index = index;
  definition.card.reset();
}

const Definition* Names::find(const std::vector<Kind>& kinds, const std::string& name,
                              const std::string& net) const {
  if (!net.empty()) {
    for (const Kind kind : kinds) {
      if (const auto it = table_.find({kind, qualify(net, name)}); it != table_.end()) {
        return &it->second;
      }
    }
  }
  for (const Kind kind : kinds) {
    if (const auto it = table_.find({kind, name}); it != table_.end()) {
      return &it->second;
    }
  }
  return nullptr;
}

bool Names::is_poisoned(const std::vector<Kind>& kinds, const std::string& name,
                        const std::string& net) const {
  const bool kind_poisoned =
      std::any_of(kinds.begin(), kinds.end(), [&](Kind k) { return kinds_.contains(k); });
  if (everything_ || kind_poisoned || words_.contains(std::string(last_part(name))) ||
      words_.contains(name)) {
    return true;
  }
  const std::string own(net_of(name)); // or the crack whose face it is
  return nets_.contains(own) || (!own.empty() && words_.contains(own)) ||
         (own.empty() && !net.empty() && nets_.contains(net));
}

std::string Names::other_meaning(const std::vector<Kind>& kinds, const std::string& name) const {
  for (const auto& [key, definition] : table_) {
    if (key.second == name && std::find(kinds.begin(), kinds.end(), key.first) == kinds.end()) {
      const std::string_view word = grammar::word_of(key.first);
      const bool faces = std::ranges::find(kinds, Kind::face_set) != kinds.end();
      return fmt::format("'{0}' is {1} {2}{3}", name, word.front() == 'e' ? "an" : "a", word,
                         key.first == Kind::crack && faces
                             ? fmt::format("; a pressure on both of its faces is $LOAD TYPE=FACES, "
                                           "on one of them {0}.LEFT or {0}.RIGHT is loaded",
                                           name)
                             : "");
    }
  }
  return {};
}

std::string Names::hint(const std::vector<Kind>& kinds, const std::string& name) const {
  std::vector<std::string> valid;
  std::vector<std::string> same_word;
  for (const auto& [key, definition] : table_) {
    if (std::find(kinds.begin(), kinds.end(), key.first) != kinds.end()) {
      valid.push_back(key.second);
      if (last_part(key.second) == last_part(name)) {
        same_word.push_back(key.second);
      }
    }
  }
  if (same_word.empty()) {
    const std::string other = other_meaning(kinds, name);
    return valid.empty() && other.empty() ? "the deck defines none"
           : other.empty()                ? base::suggest_spelling(name, valid)
                                          : other;
  }
  return same_word.size() == 1 ? fmt::format("did you mean '{}'?", same_word.front())
                               : fmt::format("one of: {}", fmt::join(same_word, ", "));
}

} // namespace spricka::deck
