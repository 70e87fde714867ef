// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/reduce_spectrum.hpp"

#include "base/turning_points.hpp"
#include "model/steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace spricka::model {

std::vector<double> leave_out_small_ranges(std::span<const double> history, double least) {
  std::vector<double> pass = base::closed_turning_points(history);
  const std::size_t turns = pass.size();
  if (turns < 2) {
    return pass;
  }
  // From the highest peak round to it again all ranges close.
  const auto start =
      static_cast<std::size_t>(std::max_element(pass.begin(), pass.end()) - pass.begin());
  std::vector<bool> kept(turns, true);
  std::vector<std::size_t> open; // places behind the peak whose ranges have not closed
  const auto load = [&](std::size_t place) { return pass[(start + place) % turns]; };
  for (std::size_t place = 0; place <= turns; ++place) {
    open.push_back(place);
    while (open.size() >= 3) {
      std::size_t* last = &open.back();
      const double range = std::fabs(load(last[-1]) - load(last[-2]));
      if (std::fabs(load(last[0]) - load(last[-1])) < range) {
        break;
      }
      if (range < least) {
        kept[(start + last[-2]) % turns] = false;
        kept[(start + last[-1]) % turns] = false;
      }
      last[-2] = last[0];
      open.resize(open.size() - 2);
    }
  }
  std::vector<double> rest;
  for (std::size_t i = 0; i < turns; ++i) {
    if (kept[i]) {
      rest.push_back(pass[i]);
    }
  }
  return rest;
}

void reduce_spectrum(SpectrumDefinition& spectrum) {
  if (!spectrum.clip && !spectrum.omit) {
    return;
  }
  spectrum.unreduced = UnreducedLoads{spectrum.cycles, spectrum.turning_points};
  if (spectrum.clip) {
    for (auto& [low, high, count] : spectrum.cycles) {
      low = std::min(low, *spectrum.clip);
      high = std::min(high, *spectrum.clip);
    }
    for (double& t : spectrum.turning_points) {
      t = std::min(t, *spectrum.clip);
    }
  }
  const double least = spectrum.omit.value_or(0.0);
  std::erase_if(spectrum.cycles, [&](const std::array<double, 3>& cycle) {
    return cycle[1] - cycle[0] < least || cycle[1] == cycle[0];
  });
  if (least > 0.0 && !spectrum.turning_points.empty()) {
    spectrum.turning_points = leave_out_small_ranges(spectrum.turning_points, least);
  }
}

} // namespace spricka::model
