// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What an entry of the catalogue says of a card: its keys, their types, limits and defaults.
namespace spricka::grammar {

enum class KeyType {
  integer,
  real,
  word,       ///< one of KeySpec::words
  words,      ///< a list of them
  name,       ///< defines a name
  reference,  ///< uses a name of KeySpec::refers
  references, ///< a list of them
  integers,   ///< a list of whole numbers
  text,       ///< 'text'
  expression  ///< (expression in x y z rho theta)
};

/// What a name stands for.
enum class EntityKind {
  none,
  node_set,
  element_set,
  face_set,
  set, ///< node or face set
  any_set,
  material,
  net,
  load_case,
  contact,
  crack,
  step,
  parameter,
  rigid,
  path,
  spectrum,
  interaction,
  test,
  law,     ///< of crack growth
  surface, ///< node or face set, or a rigid target
  solid    ///< of an imported file
};

/// The field's word for a kind: "node set".
std::string_view display_name(EntityKind kind);

using base::QuantityKind;
/// The dimension that values of a quantity have, in length, force and angle; of a number none.
base::PhysicalDimension quantity_dimension(QuantityKind quantity);
/// "a length": for messages.
std::string_view display_name(QuantityKind quantity);
/// "stress*length^0.5": how the help writes the dimension.
std::string_view dimension_formula(QuantityKind quantity);

inline constexpr double k_unbounded = std::numeric_limits<double>::infinity();

/// Limits of a number; open ends exclude the limit itself.
struct ValueLimits {
  double low = -k_unbounded;
  double high = k_unbounded;
  bool low_open = false;
  bool high_open = false;

  /// Whether a value lies within the limits.
  [[nodiscard]] bool contains(double v) const {
    return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high);
  }
  /// ">0", "2..3", "-1<..<0.5"; empty when unbounded.
  [[nodiscard]] std::string text() const;
};

struct KeySpec {
  std::string_view name = {};
  KeyType type = KeyType::real;
  bool required = false;
  std::string_view words = {};         ///< "STRESS|STRAIN"
  std::string_view default_value = {}; ///< as the deck would write it; empty: none
  std::string_view later = {};         ///< words (or * for any value) without an analysis yet
  EntityKind kind = EntityKind::none;  ///< of a name, reference or list of them
  QuantityKind quantity = QuantityKind::number;
  bool any_unit = false; ///< a number of whatever kind: its card judges the unit
  ValueLimits range = {};
  std::string_view doc = {};
};

/// What the data lines of a card are.
enum class DataLineForm { none, table, assignments, rows };

/// Where KEY is one of some words (without words: where KEY is given): the keys that must and must
/// not be there.
struct KeyPresenceRule {
  std::string_view key;
  std::string_view words;        ///< "AXI|SOLID"
  std::string_view needs = {};   ///< "C M"
  std::string_view forbids = {}; ///< "RI RO"
};

struct CardSpec {
  std::string_view name = {};
  std::string_view group = {}; ///< the part of ASKA's flow it belongs to
  std::span<const KeySpec> keys = {};
  DataLineForm data = DataLineForm::none;
  bool data_required = false;
  bool once = false;               ///< at most one in a deck
  std::string_view data_form = {}; ///< of one data line
  std::string_view exclusive = {}; ///< of these keys at most one
  std::span<const KeyPresenceRule> when = {};
  std::string_view doc = {};
  std::string_view notes = {};   ///< sentences for the help, beyond doc
  std::string_view example = {}; ///< as a deck would hold it, with its data lines

  /// The key of that name, in upper case; null: the card does not have it.
  [[nodiscard]] const KeySpec* find(std::string_view key) const;
};

/// Words between | or blanks, "A|B" or "A B", as a list; empty ones are left out.
std::vector<std::string> split_words(std::string_view words);

} // namespace spricka::grammar
