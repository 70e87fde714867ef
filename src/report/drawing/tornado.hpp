// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace spricka::report {

/// Bars about zero, one below the other in the order given.
struct TornadoChart {
  struct TornadoBar {
    std::string name;
    double more = 0.0; ///< effect of more of it, full bar
    double less = 0.0; ///< of as much less, pale bar
    std::size_t colour = 0;
  };
  std::string title;
  std::vector<TornadoBar> bars;
};

/// The drawing; numbers beside the full bars are percent.
std::string draw_svg(const TornadoChart& tornado);

} // namespace spricka::report
