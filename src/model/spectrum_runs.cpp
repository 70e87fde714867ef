// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/spectrum_runs.hpp"

#include "base/turning_points.hpp"
#include "model/steps.hpp"

namespace spricka::model {

std::vector<SpectrumBlock> divide_spectrum_into_blocks(const SpectrumDefinition& spectrum) {
  std::vector<SpectrumBlock> runs;
  if (!spectrum.sequence) {
    for (const auto& [low, high, count] : spectrum.cycles) {
      runs.push_back({{high, low}, count, true});
    }
    return runs;
  }
  const std::vector<double> t = base::turning_points(spectrum.turning_points);
  for (std::size_t i = 0; i < t.size();) {
    std::size_t times = 1;
    while (i + 2 * times + 1 < t.size() && t[i + 2 * times] == t[i] &&
           t[i + 2 * times + 1] == t[i + 1]) {
      ++times;
    }
    if (times > 1) {
      runs.push_back({{t[i], t[i + 1]}, static_cast<double>(times), false});
      i += 2 * times;
    } else {
      runs.push_back({{t[i++]}, 1.0, false});
    }
  }
  return runs;
}

std::size_t followed_place_count(const std::vector<SpectrumBlock>& runs) {
  std::size_t places = 0;
  for (const SpectrumBlock& run : runs) {
    places += run.t.size();
  }
  return places;
}

} // namespace spricka::model
