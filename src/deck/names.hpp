// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "grammar/catalogue.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::deck {

using grammar::EntityKind;

/// What a name was defined as. `index` counts the entities of its kind in the model; a set that
/// its card has not built yet has `card`, the card's number, instead.
struct NameDefinition {
  EntityKind kind = EntityKind::none;
  std::size_t index = 0;
  std::optional<std::size_t> card = {};
  base::SourceSpan span = {};
  bool poisoned = false;
};

/// The names of a deck, by kind. Names are upper case; those of sets are qualified by their net.
/// What a bad card would have defined is poisoned: it can be used without a further error.
class NameTable {
public:
  /// The older definition if the name is taken already; then nothing changes.
  const NameDefinition* define(const std::string& name, const NameDefinition& definition);
  /// Makes a name usable without a further error, also where it is defined already.
  void poison(EntityKind kind, const std::string& name);
  /// Any name of any kind that ends in `name` (a card of unknown meaning named it).
  void poison_name_ending(const std::string& name) { words_.insert(name); }
  /// Any name of a kind: a bad card defined one that could not be read.
  void poison_kind(EntityKind kind) { kinds_.insert(kind); }
  /// Every set of a net: its mesh could not be made.
  void poison_net(const std::string& net) { nets_.insert(net); }
  /// Every name: an include is missing.
  void poison_everything() { everything_ = true; }

  /// The definition of `name` as one of `kinds`, the first kind first; within a net its own sets
  /// come before those outside. Null when unknown.
  [[nodiscard]] const NameDefinition* find(const std::vector<EntityKind>& kinds,
                                           const std::string& name, const std::string& net) const;
  /// Whether an unknown name, asked for as one of `kinds` within a net, may be what a bad card
  /// would have defined: by its kind, its net, its last part or a missing include.
  [[nodiscard]] bool is_poisoned(const std::vector<EntityKind>& kinds, const std::string& name,
                                 const std::string& net) const;
  /// "did you mean ..": the nearest name, or one of another net with the same last part.
  [[nodiscard]] std::string similar_name_hint(const std::vector<EntityKind>& kinds,
                                              const std::string& name) const;

  /// "'PLATE' is an element set" where the name stands for something of another kind.
  [[nodiscard]] std::string describe_other_kind(const std::vector<EntityKind>& kinds,
                                                const std::string& name) const;

  /// For a set that has been built.
  void mark_set_built(EntityKind kind, const std::string& name, std::size_t index);

private:
  std::map<std::pair<EntityKind, std::string>, NameDefinition> table_;
  std::set<EntityKind> kinds_;
  std::set<std::string> words_;
  std::set<std::string> nets_;
  bool everything_ = false;
};

/// "SETS" that a reference of this kind may mean, in the order of preference.
std::vector<EntityKind> accepted_kinds(EntityKind kind);

/// NAME within a net: "NET.NAME".
std::string qualified_name(const std::string& net, const std::string& name);

} // namespace spricka::deck
