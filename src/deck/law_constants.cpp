// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/law_constants.hpp"

#include "model/model.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

// The lines `delta_K da/dN` of LAW=TABLE, in KUNIT and AUNIT.
void law_table(DeckContext& c, const CheckedCard& card, model::GrowthLawConstants& constants) {
  for (const grammar::DataRow& row : card.rows) {
    if (row.fields.size() != 2) {
      c.error(row.span, "E115", "a line of LAW=TABLE is delta_K da/dN");
      continue;
    }
    const auto k = c.read_number(row.fields[0], grammar::QuantityKind::number, "a range of K");
    const auto rate =
        c.read_number(row.fields[1], grammar::QuantityKind::number, "a growth per cycle");
    if (!k || !rate) {
      continue;
    }
    const double before = constants.delta_k.empty() ? 0.0 : constants.delta_k.back();
    if (*k <= before || *rate <= 0.0) {
      c.error(row.fields[*k <= before ? 0 : 1].span, "E109",
              "delta_K grows from line to line and da/dN is positive");
      continue;
    }
    constants.delta_k.push_back(*k);
    constants.growth.push_back(*rate);
  }
  if (card.rows.size() < 2 && !card.rows_bad) {
    c.error(card.span, "E115", "LAW=TABLE needs two or more data lines: delta_K da/dN");
  }
}

// A K of the law in deck units: a number alone counts in KUNIT, as C does.
double law_intensity(const CheckedCard& card, std::string_view key, double k_unit) {
  const CheckedValue* value = card.find(key);
  return value->with_unit ? value->number : value->number * k_unit;
}

bool is_given(const CheckedCard& card, std::string_view key) {
  const CheckedValue* value = card.find(key);
  return value != nullptr && value->given;
}

// Keys that a function of R and length is made of, DK0 or DK1, say nothing without it.
void refuse_keys_without(DeckContext& c, const CheckedCard& card, std::string_view keys,
                         std::string_view without) {
  for (const std::string& key : grammar::split_words(keys)) {
    if (is_given(card, key)) {
      c.error(card.find(key)->span, "E110",
              fmt::format("{} means nothing without {}", key, without));
    }
  }
}

// Intrinsic length of NASGRO's threshold where the card gives none: 0.0015 in [m].
constexpr double usual_intrinsic_length = 0.0381e-3;

void read_threshold(DeckContext& c, const CheckedCard& card, model::CrackGrowthSettings& growth) {
  model::GrowthLawConstants& constants = growth.constants;
  const bool at_zero_ratio = card.has_key("DK0");
  if (!at_zero_ratio && !card.has_key("DK1")) {
    constants.threshold = law_intensity(card, "DKTH", constants.k_unit);
    refuse_keys_without(c, card, "CTHP CTHM AINTRINSIC RCL", "DK0 or DK1");
    if (growth.law != model::CrackGrowthLaw::nasgro) {
      refuse_keys_without(c, card, "ALPHA SMAX", "LAW=NASGRO, DK0 or DK1");
    }
    return;
  }
  constants.threshold_over_ratio = model::ThresholdOverRatio{
      .delta_k = law_intensity(card, at_zero_ratio ? "DK0" : "DK1", constants.k_unit),
      .at_zero_ratio = at_zero_ratio,
      .slope_above = card.number_value("CTHP"),
      .slope_below = card.number_value("CTHM"),
      .intrinsic_length = card.optional_number("AINTRINSIC")
                              .value_or(usual_intrinsic_length / c.model.units.metre_per_length),
      .largest_ratio = card.number_value("RCL")};
}

// K_c of a thickness (life.27); lengths and stresses are in the units of the deck.
double toughness_of_thickness(const CheckedCard& card, double plane_strain) {
  const double zone = plane_strain / card.number_value("YIELD");
  const double part = card.number_value("AK") * card.number_value("THICK") / (2.5 * zone * zone);
  return plane_strain * (1.0 + card.number_value("BK") * std::exp(-part * part));
}

void read_negative_ratio(DeckContext& c, const CheckedCard& card,
                         model::GrowthLawConstants& constants) {
  constants.at_negative_ratio =
      card.key_has_word("NEGATIVE", "WHOLE")  ? model::NegativeRatioRule::whole_range
      : card.key_has_word("NEGATIVE", "KMAX") ? model::NegativeRatioRule::K_max
                                              : model::NegativeRatioRule::positive_part;
  constants.p_below = card.number_value("PM");
  if (!card.has_key("NEGATIVE")) {
    refuse_keys_without(c, card, "PM", "NEGATIVE=WHOLE");
  }
}

void read_toughness(DeckContext& c, const CheckedCard& card, model::CrackGrowthSettings& growth) {
  model::GrowthLawConstants& constants = growth.constants;
  if (card.has_key("KIE")) {
    constants.k_part_through = law_intensity(card, "KIE", constants.k_unit);
  }
  if (card.has_key("K1C")) {
    constants.k_c = toughness_of_thickness(card, law_intensity(card, "K1C", constants.k_unit));
    return;
  }
  refuse_keys_without(c, card, "AK BK THICK YIELD", "K1C");
  if (card.has_key("KC")) {
    constants.k_c = law_intensity(card, "KC", constants.k_unit);
  } else if (growth.law == model::CrackGrowthLaw::forman ||
             growth.law == model::CrackGrowthLaw::nasgro ||
             growth.law == model::CrackGrowthLaw::hartman) {
    c.error(card.span, "E106", fmt::format("$GROW LAW={} needs KC, or K1C", card.word_value("LAW")),
            "KC=82, or K1C=33 AK=1 BK=1.5 YIELD=365 THICK=2.54");
  }
}

} // namespace

void read_law_constants(DeckContext& context, const CheckedCard& card,
                        model::CrackGrowthSettings& growth) {
  model::GrowthLawConstants& constants = growth.constants;
  constants.C = card.number_value("C");
  constants.m = card.number_value("M");
  constants.p = card.number_value("P");
  constants.q = card.number_value("Q");
  constants.alpha = card.number_value("ALPHA");
  constants.stress_ratio = card.number_value("SMAX");
  constants.k_unit = context.key_unit_factor(card, "KUNIT");
  constants.a_unit = context.key_unit_factor(card, "AUNIT");
  read_threshold(context, card, growth);
  read_negative_ratio(context, card, constants);
  read_toughness(context, card, growth);
  if (growth.law == model::CrackGrowthLaw::table) {
    law_table(context, card, constants);
  }
}

} // namespace spricka::deck
