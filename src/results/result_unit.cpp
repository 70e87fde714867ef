// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/result_unit.hpp"

#include "model/model.hpp"

namespace spricka::results {

namespace {

constexpr const char* thousand = "1000 cycles";

} // namespace

base::OutputUnit life_unit(const base::UnitSystem& units, const GrowthResult& growth) {
  using enum base::LifeUnit;
  const base::LifeUnit wanted = units.output.life;
  const bool counts_passes = growth.unit == "pass";
  if (wanted == as_counted && !growth.life_unit.empty()) {
    // "flights": of one
    return {growth.life_unit.substr(0, growth.life_unit.size() - 1), growth.life_units_per_pass};
  }
  if (wanted == as_counted || (wanted == passes && counts_passes)) {
    return {growth.unit};
  }
  // A life of single cycles has no passes: the deck is refused before.
  const double cycles_of_one = counts_passes ? growth.cycles_per_pass : 1.0;
  return wanted == thousand_cycles ? base::OutputUnit{thousand, cycles_of_one, 1000.0}
                                   : base::OutputUnit{"cycle", cycles_of_one, 1.0};
}

void set_life_unit(const model::SpectrumDefinition& spectrum, GrowthResult& growth) {
  switch (spectrum.life_unit) {
  case model::SpectrumLifeUnit::passes:
    return;
  case model::SpectrumLifeUnit::flights:
    growth.life_unit = "flights";
    break;
  case model::SpectrumLifeUnit::hours:
    growth.life_unit = "hours";
    break;
  case model::SpectrumLifeUnit::cycles:
    growth.life_unit = "cycles";
    growth.life_units_per_pass = growth.cycles_per_pass;
    return;
  }
  growth.life_units_per_pass = spectrum.life_units_per_pass;
}

std::string life_unit_name(const model::Model& model) {
  GrowthResult growth;
  growth.unit = "cycle";
  if (model.growth && model.growth->spectrum) {
    growth.unit = "pass";
    set_life_unit(model.spectra[*model.growth->spectrum], growth);
  }
  return life_unit(model.units, growth).name;
}

std::string life_unit_words(const std::string& name) {
  return name == "pass" ? "passes" : name == thousand ? "thousand cycles" : name + "s";
}

base::OutputUnit check_unit(const base::UnitSystem& units, base::QuantityKind quantity,
                            const RunResult& run) {
  if (quantity == base::QuantityKind::angle) {
    return {"rad"};
  }
  return quantity == base::QuantityKind::life && run.growth ? life_unit(units, *run.growth)
                                                            : base::output_unit(units, quantity);
}

double wanted_value(const base::UnitSystem& units, const model::ResultCheck& check,
                    const RunResult& run) {
  return check.is_value_in_output_unit ? check_unit(units, check.kind, run).to_deck(check.value)
                                       : check.value;
}

double check_tolerance(const base::UnitSystem& units, const model::ResultCheck& check,
                       const RunResult& run) {
  return check.is_tolerance_in_output_unit
             ? check_unit(units, check.kind, run).to_deck(check.tolerance)
             : check.tolerance;
}

} // namespace spricka::results
