// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/modes.hpp"

namespace spricka::estimate {

namespace {

template <class M> PlaneModes describe() {
  PlaneModes modes;
  modes.sides = M::sides;
  modes.count = M::count;
  modes.degree = M::degree;
  modes.psi = [](const shape::Point<2>& r) { return PlaneModes::Values(M::psi(r)); };
  modes.dpsi = [](const shape::Point<2>& r) { return PlaneModes::CoordinateGradients(M::dpsi(r)); };
  modes.along = M::side_coordinate;
  modes.d_along = M::side_coordinate_gradient;
  return modes;
}

} // namespace

const PlaneModes& PlaneModes::for_type(base::ElementType type) {
  static const PlaneModes trimc6 = describe<Modes<shape::Trimc6>>();
  static const PlaneModes quamc8 = describe<Modes<shape::Quamc8>>();
  static const PlaneModes quamc9 = describe<Modes<shape::Quamc9>>();
  assert(has_cubic_modes(type));
  return type == base::ElementType::trimc6   ? trimc6
         : type == base::ElementType::quamc8 ? quamc8
                                             : quamc9;
}

} // namespace spricka::estimate
