// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "results/k_quantities.hpp"
#include "results/results.hpp"

#include <string_view>
#include <vector>

/// Tables of K at the points of fronts: the quantities that the listing has
/// (results/k_quantities.hpp).
namespace spricka::report {

/// What a table of K has: K with its bars, as many digits as these have meaning, or all that there
/// is.
enum class KTableExtent { brief, full };

/// For each step and tip of one increment; no rows in space.
ReportTable tip_k_table(const model::Model& model, const results::CrackLengthResult& increment,
                        KTableExtent extent);

/// The same at the end of one step, one row for each increment and tip.
ReportTable tip_k_table_over_increments(const model::Model& model, const results::RunResult& run,
                                        std::string_view step, KTableExtent extent);

/// A table for each front in space: its points, of all steps of an increment in which K is not
/// nothing but round-off.
std::vector<ReportTable> front_tables(const model::Model& model,
                                      const results::CrackLengthResult& increment);

/// The same at the places by which a front is reported (front_places.hpp), K and its bars alone.
std::vector<ReportTable> front_place_tables(const model::Model& model,
                                            const results::CrackLengthResult& increment);

/// The quantities of K that a model's runs have at a place, in the order of the table; those by
/// opening where the deck asks for them.
std::vector<const results::KQuantity*> shown_k_quantities(const model::Model& model,
                                                          results::KOutputPlace place);

/// The largest K of a front; of a tip K1 and K2 together.
double largest_K(const results::FrontResult& front);
/// Of all fronts and steps.
double largest_K(const results::CrackLengthResult& increment);

/// The fronts in space of an increment, each as its first step has it.
std::vector<const results::FrontResult*>
find_fronts_in_space(const results::CrackLengthResult& increment);

} // namespace spricka::report
