// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/topics/figures.hpp"

#include <optional>

namespace spricka::report {

/// The law of a growth over the delta K and R that its cycles had, beside the range of the data
/// behind it, with what it gave at the stations; of a spectrum these stand in a drawing of their
/// own, as they are rates of a pass. Empty where nothing grew. The run has a growth.
std::optional<Figure> growth_law_figure(const model::Model& model, const results::RunResult& run);

} // namespace spricka::report
