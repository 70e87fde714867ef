// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/catalogue.hpp"

#include "grammar/card_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

constexpr std::array quantities{
    ResultQuantity{"K", "cs?aa", "same as K1"},
    ResultQuantity{"K1", "cs?aa", "stress intensity of mode I: crack, step, length, front angle"},
    ResultQuantity{"K2", "cs?aa", "stress intensity of mode II"},
    ResultQuantity{"G", "cs?aa", "energy release rate"},
    ResultQuantity{"T", "cs?aa", "T stress"},
    ResultQuantity{"CPRESS.MIN", "ps", "smallest contact pressure"},
    ResultQuantity{"CPRESS.MAX", "ps", "largest contact pressure"},
    ResultQuantity{"CPRESS.MEAN", "ps", "mean pressure over the part in contact"},
    ResultQuantity{"CPRESS.AT", "psa", "contact pressure at the angle theta"},
    ResultQuantity{"ARC.FROM", "ps", "first angle of the part in contact"},
    ResultQuantity{"ARC.TO", "ps", "last angle of the part in contact"},
    ResultQuantity{"SUM", "psd", "force on the slave"},
    ResultQuantity{"U.X.MIN", "ns", "smallest displacement along x"},
    ResultQuantity{"U.Y.MIN", "ns", "smallest displacement along y"},
    ResultQuantity{"U.Z.MIN", "ns", "smallest displacement along z"},
    ResultQuantity{"U.X.MAX", "ns", "largest displacement along x"},
    ResultQuantity{"U.Y.MAX", "ns", "largest displacement along y"},
    ResultQuantity{"U.Z.MAX", "ns", "largest displacement along z"},
    ResultQuantity{"U.X.AT", "aazs", "displacement along x at a point"},
    ResultQuantity{"U.Y.AT", "aazs", "displacement along y at a point"},
    ResultQuantity{"U.Z.AT", "aazs", "displacement along z at a point"},
    ResultQuantity{"S.XX.MIN", "ns", "smallest stress xx"},
    ResultQuantity{"S.YY.MIN", "ns", "smallest stress yy"},
    ResultQuantity{"S.ZZ.MIN", "ns", "smallest stress zz"},
    ResultQuantity{"S.XY.MIN", "ns", "smallest stress xy"},
    ResultQuantity{"S.YZ.MIN", "ns", "smallest stress yz"},
    ResultQuantity{"S.XZ.MIN", "ns", "smallest stress xz"},
    ResultQuantity{"S.XX.MAX", "ns", "largest stress xx"},
    ResultQuantity{"S.YY.MAX", "ns", "largest stress yy"},
    ResultQuantity{"S.ZZ.MAX", "ns", "largest stress zz"},
    ResultQuantity{"S.XY.MAX", "ns", "largest stress xy"},
    ResultQuantity{"S.YZ.MAX", "ns", "largest stress yz"},
    ResultQuantity{"S.XZ.MAX", "ns", "largest stress xz"},
    ResultQuantity{"S.XX.AT", "aazs", "stress xx at a point"},
    ResultQuantity{"S.YY.AT", "aazs", "stress yy at a point"},
    ResultQuantity{"S.ZZ.AT", "aazs", "stress zz at a point"},
    ResultQuantity{"S.XY.AT", "aazs", "stress xy at a point"},
    ResultQuantity{"S.YZ.AT", "aazs", "stress yz at a point"},
    ResultQuantity{"S.XZ.AT", "aazs", "stress xz at a point"},
    ResultQuantity{"REACTION", "nsd", "force of the supports on a set"},
    ResultQuantity{"N", "a", "cycles at a crack length"},
    ResultQuantity{"LIFE", "", "cycles to the end"},
};

} // namespace

std::string_view word_of(Kind kind) {
  switch (kind) {
  case Kind::node_set:
    return "node set";
  case Kind::element_set:
    return "element set";
  case Kind::face_set:
    return "face set";
  case Kind::set:
    return "node or face set";
  case Kind::any_set:
    return "set";
  case Kind::material:
    return "material";
  case Kind::net:
    return "net";
  case Kind::load_case:
    return "load case";
  case Kind::contact:
    return "contact";
  case Kind::crack:
    return "crack";
  case Kind::step:
    return "step";
  case Kind::parameter:
    return "parameter";
  case Kind::rigid:
    return "rigid target";
  case Kind::surface:
    return "set or rigid target";
  case Kind::none:
    break;
  }
  return "name";
}

base::Dimension dimension_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
    return {1.0, 0.0, 0.0};
  case Quantity::stress:
    return {-2.0, 1.0, 0.0};
  case Quantity::angle:
    return {0.0, 0.0, 1.0};
  case Quantity::stress_intensity:
    return {-1.5, 1.0, 0.0};
  case Quantity::number:
    break;
  }
  return {};
}

std::string_view word_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
    return "a length";
  case Quantity::stress:
    return "a stress";
  case Quantity::angle:
    return "an angle";
  case Quantity::stress_intensity:
    return "a stress intensity";
  case Quantity::number:
    break;
  }
  return "a plain number";
}

std::string Range::text() const {
  const bool has_low = low > -k_unbounded;
  const bool has_high = high < k_unbounded;
  if (has_low && has_high) {
    return fmt::format("{}{}..{}{}", low, low_open ? "<" : "", high_open ? "<" : "", high);
  }
  if (has_low) {
    return fmt::format("{}{}", low_open ? ">" : ">=", low);
  }
  return has_high ? fmt::format("{}{}", high_open ? "<" : "<=", high) : std::string();
}

const KeySpec* CardSpec::find(std::string_view key) const {
  const auto it =
      std::find_if(keys.begin(), keys.end(), [&](const KeySpec& k) { return k.name == key; });
  return it == keys.end() ? nullptr : &*it;
}

std::span<const CardSpec> catalogue() {
  static const std::vector<CardSpec> all = [] {
    std::vector<CardSpec> cards(model_cards().begin(), model_cards().end());
    cards.insert(cards.end(), analysis_cards().begin(), analysis_cards().end());
    return cards;
  }();
  return all;
}

const CardSpec* find_card(std::string_view name) {
  const auto all = catalogue();
  const auto it =
      std::find_if(all.begin(), all.end(), [&](const CardSpec& c) { return c.name == name; });
  return it == all.end() ? nullptr : &*it;
}

std::vector<std::string> split_words(std::string_view words) {
  std::vector<std::string> result;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of("| "), words.size());
    if (end > 0) {
      result.emplace_back(words.substr(0, end));
    }
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return result;
}

std::span<const ResultQuantity> result_quantities() {
  return quantities;
}

const ResultQuantity* find_quantity(std::string_view name) {
  const auto* const it = std::find_if(quantities.begin(), quantities.end(),
                                      [&](const ResultQuantity& q) { return q.name == name; });
  return it == quantities.end() ? nullptr : it;
}

} // namespace spricka::grammar
