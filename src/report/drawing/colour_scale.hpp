// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/measure_title.hpp"
#include "report/drawing/svg.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace spricka::report {

/// Colours told apart in a picture of a field.
inline constexpr std::size_t colour_bands = 12;

/// Values of the colours' ends; what lies beyond has the colour of the end.
struct ColourScale {
  double low = 0.0;
  double high = 0.0;
  /// Number of the colour of a value, 0 to colour_bands - 1; 0 where the scale has no extent.
  [[nodiscard]] std::size_t band_index(double value) const;
};

/// From low to high, or from 0 where there is nothing between them but round-off.
ColourScale make_colour_scale(double low, double high);

/// The value below which that part of the shares of all values lies; 0 of no values.
double value_above_share(std::vector<std::pair<double, double>> values_with_shares, double part);

/// Dark to light, even steps to the eye (Smith and van der Walt's viridis, five of its colours).
std::string band_colour(std::size_t band);

/// The bands with round numbers below, in the unit of the title, and the title above; corner: upper
/// left. Nothing of a scale without extent.
void draw_colour_legend(SvgDrawing& svg, const ColourScale& scale, DrawingPoint corner,
                        double width, const MeasureTitle& title);

} // namespace spricka::report
