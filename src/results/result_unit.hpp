// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"
#include "model/forward.hpp"
#include "model/requests.hpp"
#include "results/results.hpp"

#include <string>

/// Units that results are written in, where they depend on the run.
namespace spricka::results {

/// What lives of a growth are written in: the cycles or passes that it counts, or what the units
/// choose. Named "cycle", "pass" or "1000 cycles".
base::OutputUnit life_unit(const base::UnitSystem& units, const GrowthResult& growth);
/// What a spectrum wants lives to be written in; cycles_per_pass is known.
void set_life_unit(const model::SpectrumDefinition& spectrum, GrowthResult& growth);
/// Its name, of the growth that a deck asks for.
std::string life_unit_name(const model::Model& model);
/// Several of a unit of lives of that name: "cycles", "passes", "thousand cycles".
std::string life_unit_words(const std::string& name);

/// What the results that $CHECK names are written in: angles in radians, as it takes them; lives of
/// a run without growth in what is counted.
base::OutputUnit check_unit(const base::UnitSystem& units, base::QuantityKind quantity,
                            const RunResult& run);

/// The value that a check wants, in units of the deck.
double wanted_value(const base::UnitSystem& units, const model::ResultCheck& check,
                    const RunResult& run);
/// How far the result may be from it: a part of it, else in units of the deck.
double check_tolerance(const base::UnitSystem& units, const model::ResultCheck& check,
                       const RunResult& run);

} // namespace spricka::results
