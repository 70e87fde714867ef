// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/auxiliary_field.hpp"

namespace spricka::crack {

SectionState state_from_gradient(const SectionElasticity& k, const Tensor<2>& H, double hoop) {
  SectionState state{
      .H = H, .hoop = hoop, .sigma = stress_from_gradient<2>(k.D, H), .sigma_hoop = 0.0};
  if (k.law.axisymmetric) {
    const double pressed = k.law.lambda * hoop;
    state.sigma.diagonal().array() += pressed;
    state.sigma_hoop = k.law.lambda * H.trace() + pressed + 2.0 * k.law.mu * hoop;
  }
  return state;
}

AuxiliaryField auxiliary_field_at(const TipSetting& set, const SectionElasticity& k,
                                  const base::Vec2& x, std::size_t auxiliary) {
  const Polar place = polar(set.tip, x);
  const Tensor<2> H = auxiliary_field_gradient(set, place, auxiliary);
  if (!set.is_axisymmetric()) {
    return {state_from_gradient(k, H, 0.0), base::Vec2::Zero()};
  }
  const double hoop = auxiliary_field_displacement(set, place, auxiliary).x() / x.x();
  // (crack.39): in the section alone it is at rest.
  const base::Vec2 divergence((k.law.lambda + 2.0 * k.law.mu) * (H(0, 0) - hoop),
                              k.law.lambda * H(0, 1) + k.law.mu * (H(0, 1) + H(1, 0)));
  return {state_from_gradient(k, H, hoop), divergence / x.x()};
}

} // namespace spricka::crack
