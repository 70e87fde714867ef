// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/spectrum_keys.hpp"

#include "model/steps.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace spricka::deck {

std::optional<model::TwistSettings> read_twist_settings(DeckContext& context,
                                                        const CheckedCard& card) {
  const auto level_of = [&](std::string_view key, int when_left_out) {
    const std::vector<std::string> words = grammar::split_words(card.spec->find(key)->words);
    return card.has_key(key)
               ? static_cast<int>(std::ranges::find(words, card.word_value(key)) - words.begin())
               : when_left_out;
  };
  model::TwistSettings settings;
  settings.highest_level = level_of("HIGHEST", 0);
  settings.lowest_level = level_of("LOWEST", model::twist_levels - 1);
  if (card.has_key("SEED")) {
    settings.seed = static_cast<std::uint32_t>(card.integer_value("SEED"));
  }
  if (settings.highest_level > settings.lowest_level) {
    context.error(card.find("HIGHEST")->span, "E109",
                  "HIGHEST is a lower level than LOWEST: I is the largest gust, X the smallest");
    return std::nullopt;
  }
  return settings;
}

void set_life_unit(DeckContext& context, const CheckedCard& card, double counted_flights,
                   model::SpectrumDefinition& spectrum) {
  using model::SpectrumLifeUnit;
  const double flights = card.has_key("FLIGHTS") ? card.number_value("FLIGHTS") : counted_flights;
  const std::string_view unit = card.word_value("UNIT");
  if (unit == "FLIGHTS" && !(flights > 0.0)) {
    context.error(card.find("UNIT")->span, "E106",
                  "UNIT=FLIGHTS needs the number of flights in a pass",
                  "FLIGHTS=n, or MARK='..' for lines of the file that begin a flight");
  }
  const auto set = [&](SpectrumLifeUnit as, double per_pass) {
    spectrum.life_unit = as;
    spectrum.life_units_per_pass = per_pass;
  };
  if (unit == "CYCLES") {
    set(SpectrumLifeUnit::cycles, 1.0);
  } else if (unit == "HOURS" || (unit.empty() && !(flights > 0.0) && card.has_key("HOURS"))) {
    set(SpectrumLifeUnit::hours, card.number_value("HOURS"));
  } else if (unit != "PASSES" && flights > 0.0) {
    set(SpectrumLifeUnit::flights, flights);
  }
}

} // namespace spricka::deck
