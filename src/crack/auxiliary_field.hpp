// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

/// Partners of a solution in the plane and about an axis.
namespace spricka::crack {

/// Elastic constants of an element of a domain.
struct SectionElasticity {
  fe::Elasticity<2> D; ///< in the section
  fe::ConstitutiveLaw law;

  SectionElasticity(const TipSetting& set, base::ElementId e)
      : D(set.elasticity(e)), law(fe::constitutive_law(set.model, set.mesh, e)) {}
};

/// A displacement at a point of a section: gradient and stress there, and about an axis those round
/// it (both 0 in the plane, where nothing works on them).
struct SectionState {
  Tensor<2> H = Tensor<2>::Zero();
  double hoop = 0.0; ///< u_x / x
  Tensor<2> sigma = Tensor<2>::Zero();
  double sigma_hoop = 0.0;

  /// Volume change, of what lies in the section and round the axis.
  [[nodiscard]] double dilatation() const { return H.trace() + hoop; }
  /// Work density of this state's stress on the strain of another, the part round the axis included
  /// [stress].
  [[nodiscard]] double work_on(const SectionState& other) const {
    return sigma.cwiseProduct(other.H).sum() + sigma_hoop * other.hoop;
  }
};

/// With the stress of a gradient.
SectionState state_from_gradient(const SectionElasticity& k, const Tensor<2>& H, double hoop);

/// Partner 1 to 3 at a point x off the tip. About an axis it is carried round with the section: a
/// displacement of the body, but none of a body at rest (crack.38).
struct AuxiliaryField : SectionState {
  base::Vec2 divergence = base::Vec2::Zero(); ///< of its stress [stress/length]
};
/// The auxiliary field at x by its number, stress by the element's own elasticity; the divergence
/// is zero in the plane (crack.39).
AuxiliaryField auxiliary_field_at(const TipSetting& set, const SectionElasticity& k,
                                  const base::Vec2& x, std::size_t auxiliary);

} // namespace spricka::crack
