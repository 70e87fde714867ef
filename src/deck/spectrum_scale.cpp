// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/spectrum_scale.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spricka::deck {

SpectrumScale::SpectrumScale(DeckContext& context, const CheckedCard& card)
    : context_(context), card_(card), slope_(card.number_value("FACTOR")),
      start_(card.number_value("OFFSET")) {
  const std::optional<double> from = load_of_key("AT0");
  const std::optional<double> to = load_of_key("AT1");
  if (!from || !to) {
    return;
  }
  if (*from == *to) {
    context.error(card.find("AT1")->span, "E109",
                  "AT0 and AT1 are one load: they say nothing of the others");
    sound_ = false;
    return;
  }
  values_ = model::SpectrumValues{unit_label(), *from, *to};
  slope_ /= *to - *from;
  start_ = (start_ - *from) / (*to - *from);
}

// As VALUES says, else the deck's own unit where AT1 has one.
std::string SpectrumScale::unit_label() const {
  if (card_.has_key("VALUES")) {
    return std::string(card_.word_value("VALUES"));
  }
  const auto unit = base::parse_unit(card_.word_value("AT1"));
  const base::UnitSystem& units = context_.model.units;
  for (const base::QuantityKind quantity :
       {base::QuantityKind::stress, base::QuantityKind::force}) {
    if (unit && unit->dimension == grammar::quantity_dimension(quantity)) {
      return base::unit_name(units, quantity);
    }
  }
  return {};
}

std::optional<double> SpectrumScale::load_of_key(std::string_view key) {
  const CheckedValue* value = card_.find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->with_unit) {
    return value->number;
  }
  if (!card_.has_key("AT1")) {
    context_.error(value->span, "E205",
                   fmt::format("{} counts in places t on the path, which have no unit", key),
                   "AT0 and AT1 say which loads the steps FROM and TO stand for");
    sound_ = false;
    return value->number;
  }
  if (!card_.has_key("VALUES")) {
    return value->number; // loads in units of the deck
  }
  const auto unit = base::parse_unit(card_.word_value("VALUES"));
  const auto own = base::parse_unit(value->text);
  if (!unit || (own && own->dimension != unit->dimension)) {
    context_.error(
        value->span, "E205",
        fmt::format("{} cannot be brought to VALUES='{}'", key, card_.word_value("VALUES")),
        "write it as a number in that unit, without a unit of its own");
    sound_ = false;
    return value->number;
  }
  return value->number / base::factor_to_deck_units(*unit, context_.model.units);
}

double SpectrumScale::range_of_loads(double range) const {
  return values_ ? range / std::fabs(values_->at_to - values_->at_from) : range;
}

std::string SpectrumScale::describe(double t) const {
  if (!values_) {
    return fmt::format("t = {:.6g}", t);
  }
  return fmt::format("load {:.6g}{}{} (t = {:.6g})", values_->value_at(t),
                     values_->unit.empty() ? "" : " ", values_->unit, t);
}

} // namespace spricka::deck
