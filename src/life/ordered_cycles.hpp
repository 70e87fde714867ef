// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/rainflow.hpp"
#include "model/steps.hpp"

#include <span>
#include <vector>

/// The cycles of one pass in the order in which they come, for models whose cycles know of each
/// other.
namespace spricka::life {

/// Each valley of a history that repeats with the peak behind it, in their order. A history that
/// begins with a peak has its last valley before that.
std::vector<LoadCycle> pair_valleys_with_peaks(std::span<const double> history);

/// The cycles of a history of loads, or of K, that repeats: pairs, or rainflow in order of peaks.
/// A history without a range has none.
std::vector<LoadCycle> order_cycles(std::span<const double> history, model::CycleCounting counting);

/// The cycles of a pass of a spectrum as places t: blocks as the deck lists them, low <= high.
std::vector<LoadCycle> order_cycles(const model::SpectrumDefinition& spectrum);

} // namespace spricka::life
