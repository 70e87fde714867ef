// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/law_constants.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

/// The data lines of a TABLE: `delta_K da/dN`, or behind `RATIO R R ..` lines `da/dN delta_K ..`,
/// in KUNIT and AUNIT.
class GrowthTableReader {
public:
  GrowthTableReader(DeckContext& c, const CheckedCard& card, model::GrowthLawConstants& constants)
      : c_(c), card_(card), constants_(constants) {}

  void read() {
    for (const grammar::DataRow& row : card_.rows) {
      const grammar::CardField& first = row.fields.front();
      if (first.is_name() && first.text == "RATIO") {
        ratios(row);
      } else if (has_ratios_) {
        across(row);
      } else {
        pair(row);
      }
    }
    for (const std::vector<double>& column : columns_) {
      constants_.delta_k.insert(constants_.delta_k.end(), column.begin(), column.end());
    }
    if (card_.rows.size() < (has_ratios_ ? 3U : 2U) && !card_.rows_bad) {
      c_.error(card_.span, "E115",
               "a TABLE needs two or more data lines: delta_K da/dN, or behind RATIO R R .. "
               "da/dN delta_K delta_K ..");
    }
  }

private:
  // The columns; R of each ascends.
  void ratios(const grammar::DataRow& row) {
    if (has_ratios_ || !constants_.growth.empty()) {
      c_.error(row.span, "E115", "RATIO stands once, in the first data line of the table");
      return;
    }
    has_ratios_ = true;
    for (std::size_t i = 1; i < row.fields.size(); ++i) {
      const auto R = c_.read_number(row.fields[i], grammar::QuantityKind::number, "a ratio R");
      const std::vector<double>& before = constants_.table_ratios;
      const bool ascends = R && (before.empty() || *R > before.back());
      if (R && (!ascends || !(*R < 1.0))) {
        c_.error(row.fields[i].span, "E109", "R grows from column to column and is below 1");
      }
      constants_.table_ratios.push_back(R.value_or(0.0));
    }
    if (row.fields.size() < 3) {
      c_.error(row.span, "E115", "RATIO names the R of two or more columns",
               "of one R: lines delta_K da/dN");
    }
    columns_.resize(constants_.table_ratios.size());
  }

  // da/dN and the delta K of each column.
  void across(const grammar::DataRow& row) {
    if (row.fields.size() != columns_.size() + 1) {
      c_.error(row.span, "E115",
               fmt::format("behind RATIO with {} R a line is da/dN and {} delta_K", columns_.size(),
                           columns_.size()));
      return;
    }
    const auto rate =
        c_.read_number(row.fields[0], grammar::QuantityKind::number, "a growth per cycle");
    if (rate && *rate <= last(constants_.growth)) {
      c_.error(row.fields[0].span, "E109", "da/dN is positive and grows from line to line");
    }
    bool sound = rate.has_value();
    std::vector<double> ranges;
    for (std::size_t i = 1; i < row.fields.size(); ++i) {
      const auto k = c_.read_number(row.fields[i], grammar::QuantityKind::number, "a range of K");
      if (k && *k <= last(columns_[i - 1])) {
        c_.error(row.fields[i].span, "E109", "delta_K is positive and grows from line to line");
      }
      sound = sound && k;
      ranges.push_back(k.value_or(0.0));
    }
    for (std::size_t i = 0; i < ranges.size() && sound; ++i) {
      columns_[i].push_back(ranges[i]);
    }
    if (sound) {
      constants_.growth.push_back(*rate);
    }
  }

  void pair(const grammar::DataRow& row) {
    if (row.fields.size() != 2) {
      c_.error(row.span, "E115", "a line of a TABLE is delta_K da/dN");
      return;
    }
    const auto k = c_.read_number(row.fields[0], grammar::QuantityKind::number, "a range of K");
    const auto rate =
        c_.read_number(row.fields[1], grammar::QuantityKind::number, "a growth per cycle");
    if (!k || !rate) {
      return;
    }
    const double before = last(constants_.delta_k);
    if (*k <= before || *rate <= 0.0) {
      c_.error(row.fields[*k <= before ? 0 : 1].span, "E109",
               "delta_K grows from line to line and da/dN is positive");
      return;
    }
    constants_.delta_k.push_back(*k);
    constants_.growth.push_back(*rate);
  }

  static double last(const std::vector<double>& values) {
    return values.empty() ? 0.0 : values.back();
  }

  DeckContext& c_;
  const CheckedCard& card_;
  model::GrowthLawConstants& constants_;
  std::vector<std::vector<double>> columns_; ///< delta K
  bool has_ratios_ = false;
};

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

void read_threshold(DeckContext& c, const CheckedCard& card, model::GrowthLawDefinition& read) {
  model::GrowthLawConstants& constants = read.constants;
  const bool at_zero_ratio = card.has_key("DK0");
  if (!at_zero_ratio && !card.has_key("DK1")) {
    constants.threshold = law_intensity(card, "DKTH", constants.k_unit);
    refuse_keys_without(c, card, "CTHP CTHM AINTRINSIC RCL", "DK0 or DK1");
    if (read.law != model::CrackGrowthLaw::nasgro) {
      refuse_keys_without(c, card, "ALPHA SMAX", "NASGRO, DK0 or DK1");
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

void read_toughness(DeckContext& c, const CheckedCard& card, model::GrowthLawDefinition& read) {
  model::GrowthLawConstants& constants = read.constants;
  const bool is_named = card.spec->name == "LAW";
  read.data.thickness = card.optional_number("THICK");
  if (card.has_key("KIE")) {
    constants.k_part_through = law_intensity(card, "KIE", constants.k_unit);
  }
  if (card.has_key("K1C")) {
    read.toughness =
        model::ToughnessOverThickness{.plane_strain = law_intensity(card, "K1C", constants.k_unit),
                                      .A_k = card.number_value("AK"),
                                      .B_k = card.number_value("BK"),
                                      .yield = card.number_value("YIELD")};
    return;
  }
  refuse_keys_without(c, card, is_named ? "AK BK YIELD" : "AK BK THICK YIELD", "K1C");
  if (card.has_key("KC")) {
    constants.k_c = law_intensity(card, "KC", constants.k_unit);
  } else if (read.law == model::CrackGrowthLaw::forman ||
             read.law == model::CrackGrowthLaw::nasgro ||
             read.law == model::CrackGrowthLaw::hartman) {
    const std::string_view key = is_named ? "TYPE" : "LAW";
    c.error(card.span, "E106",
            fmt::format("${} {}={} needs KC, or K1C", card.spec->name, key, card.word_value(key)),
            "KC=82, or K1C=33 AK=1 BK=1.5 YIELD=365 THICK=2.54");
  }
}

// What only $LAW says.
void read_data(DeckContext& c, const CheckedCard& card, model::GrowthLawDefinition& read) {
  model::GrowthLawData& data = read.data;
  data.name = card.word_value("NAME");
  data.source = card.word_value("SOURCE");
  data.form = card.word_value("FORM");
  data.orientation = card.word_value("ORIENTATION");
  data.environment = card.word_value("ENVIRONMENT");
  if (card.has_key("DKMIN")) {
    data.lowest_delta_k = law_intensity(card, "DKMIN", read.constants.k_unit);
  }
  if (card.has_key("DKMAX")) {
    data.highest_delta_k = law_intensity(card, "DKMAX", read.constants.k_unit);
  }
  data.lowest_ratio = card.optional_number("RMIN");
  data.highest_ratio = card.optional_number("RMAX");
  data.scatter = card.optional_number("SCATTER");
  if (data.lowest_delta_k && data.highest_delta_k && *data.lowest_delta_k > *data.highest_delta_k) {
    c.error(card.value_span("DKMIN"), "E109", "DKMIN is above DKMAX");
  }
  if (data.lowest_ratio && data.highest_ratio && *data.lowest_ratio > *data.highest_ratio) {
    c.error(card.value_span("RMIN"), "E109", "RMIN is above RMAX");
  }
}

} // namespace

double toughness_of_thickness(const model::ToughnessOverThickness& toughness, double thickness) {
  const double zone = toughness.plane_strain / toughness.yield;
  const double part = toughness.A_k * thickness / (2.5 * zone * zone);
  return toughness.plane_strain * (1.0 + toughness.B_k * std::exp(-part * part));
}

model::GrowthLawDefinition read_growth_law(DeckContext& context, const CheckedCard& card,
                                           std::string_view key) {
  model::GrowthLawDefinition read;
  read.law = static_cast<model::CrackGrowthLaw>(
      std::ranges::find(model::growth_law_words, card.word_value(key)) -
      model::growth_law_words.begin());
  model::GrowthLawConstants& constants = read.constants;
  constants.C = card.number_value("C");
  constants.m = card.number_value("M");
  constants.p = card.number_value("P");
  constants.q = card.number_value("Q");
  constants.alpha = card.number_value("ALPHA");
  constants.stress_ratio = card.number_value("SMAX");
  constants.k_unit = context.key_unit_factor(card, "KUNIT");
  constants.a_unit = context.key_unit_factor(card, "AUNIT");
  read_threshold(context, card, read);
  read_negative_ratio(context, card, constants);
  read_toughness(context, card, read);
  read_data(context, card, read);
  if (read.law == model::CrackGrowthLaw::table) {
    GrowthTableReader(context, card, constants).read();
  } else if (read.law != model::CrackGrowthLaw::increment && !card.rows.empty()) {
    context.error(card.rows.front().span, "E115",
                  fmt::format("{}={} takes no data lines", key, card.word_value(key)));
  }
  return read;
}

} // namespace spricka::deck
