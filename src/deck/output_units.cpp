// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/output_units.hpp"

#include "model/model.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace spricka::deck {

base::OutputUnitChoice read_output_units(DeckContext& context, const CheckedCard& deck,
                                         const base::UnitSystem& units) {
  const auto unit = [&](std::string_view key) -> std::optional<base::OutputUnit> {
    const std::string_view text = deck.word_value(key);
    if (text.find("cycle") != std::string_view::npos) { // as AUNIT may have it
      context.error(deck.find(key)->span, "E205",
                    fmt::format("{}: '{}' is a unit over cycles", key, text),
                    "da/dN is written in OUTLENGTH over what the life counts");
      return std::nullopt;
    }
    return base::make_output_unit(text, units);
  };
  return {.length = unit("OUTLENGTH"),
          .force = unit("OUTFORCE"),
          .stress = unit("OUTSTRESS"),
          .stress_intensity = unit("OUTK"),
          .life = deck.key_has_word("OUTLIFE", "CYCLES")    ? base::LifeUnit::cycles
                  : deck.key_has_word("OUTLIFE", "KCYCLES") ? base::LifeUnit::thousand_cycles
                  : deck.key_has_word("OUTLIFE", "PASSES")  ? base::LifeUnit::passes
                                                            : base::LifeUnit::as_counted};
}

void check_output_life(DeckContext& context) {
  const bool counts_passes = context.model.growth && context.model.growth->spectrum;
  const CheckedCard* const deck = context.find_first_card("DECK");
  if (context.model.units.output.life == base::LifeUnit::passes && !counts_passes &&
      !context.has_bad_card("GROW") && deck != nullptr) {
    context.error(deck->find("OUTLIFE")->span, "E106",
                  "OUTLIFE=PASSES needs a $GROW with SPECTRUM: no other life has passes",
                  "OUTLIFE=CYCLES or KCYCLES");
  }
}

} // namespace spricka::deck
