// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <string>

namespace spricka::report {

/// What the view of a page is made from.
struct ViewData {
  std::string json; ///< may stand within <script>: no < is in it; empty: there is nothing to see
  std::string left_out; ///< what of the results it has not, in a sentence; empty: it has all
};

/// Letters that the data of a page take at most before they are packed, about: what is more is left
/// out, first steps, then lengths, then points are merged.
inline constexpr std::size_t view_budget = 1400000;

/// Surfaces, fields, fronts and marks of a run's lengths and steps for data.js.
ViewData make_view_data(const model::Model& model, const results::RunResult& run,
                        std::size_t budget = view_budget);

} // namespace spricka::report
