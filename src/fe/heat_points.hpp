// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/adaptive_rule.hpp"
#include "fe/heat_field.hpp"
#include "fe/jacobian.hpp"

#include <vector>

namespace spricka::fe {

/// A point of an element, and how far its temperature is from what the element takes.
struct ResidualTemperaturePoint {
  base::ElementId element;
  shape::Point<2> r = shape::Point<2>::Zero();
  double area = 0.0; ///< weight times det J [length^2]
  double T = 0.0;
};

/// Points of a temperature inside a plane element, as many as it takes.
struct SampledTemperature {
  std::vector<ResidualTemperaturePoint> points;
  bool discontinuous = false; ///< it jumps inside
  double amount = 0.0;        ///< integral of the magnitude over the element [temperature * area]
  double missed = 0.0;        ///< what of it may be missed
};

/// By rules that follow the temperature (adaptive_rule.hpp) over charts, into the corner `tip`; -1:
/// over the whole element.
SampledTemperature sample_temperature(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                                      const TemperatureField& field, base::ElementId e,
                                      const FieldMagnitude& scale, int tip);

} // namespace spricka::fe
