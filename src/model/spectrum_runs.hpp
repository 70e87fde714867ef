// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"

#include <cstddef>
#include <vector>

namespace spricka::model {

/// A stretch of a history of loads: a place t, or two between which it goes several times.
struct SpectrumBlock {
  std::vector<double> t; ///< one place, or two: the first and the second of each cycle
  double count = 1.0;    ///< cycles of two places
  bool alone = false;    ///< of TYPE=BLOCKS: its cycles are counted by themselves
};

/// One pass of a spectrum as stretches, in order. Places of a sequence where it does not turn are
/// left out; two places that follow one another again and again are one stretch.
std::vector<SpectrumBlock> divide_spectrum_into_blocks(const SpectrumDefinition& spectrum);

/// Places of all stretches: what a solution that has to follow the history comes to.
std::size_t followed_place_count(const std::vector<SpectrumBlock>& runs);

/// More are refused.
inline constexpr std::size_t most_followed_places = 2000;

} // namespace spricka::model
