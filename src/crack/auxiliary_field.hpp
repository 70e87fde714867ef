// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/energy_momentum.hpp"
#include "crack/williams.hpp"

#include <cstddef>

/// Displacements at a point of a body, and those that the solution is combined with.
namespace spricka::crack {

/// Partners of the solution at a front: itself (G), the near-tip fields of K1, K2 and in space K3
/// = 1, and the field of a unit force along the crack at the front (T).
template <int dim> inline constexpr std::size_t auxiliary_field_count = dim + 2;
/// Number of the last one.
template <int dim> inline constexpr std::size_t force_auxiliary = dim + 1;
/// Number of a partner among the fields of a section (section_field).
template <int dim> [[nodiscard]] constexpr std::size_t section_field_number(std::size_t auxiliary) {
  return auxiliary == force_auxiliary<dim> ? line_force_auxiliary : auxiliary;
}

/// A displacement at a point: gradient and stress, and about an axis those round it (both 0 in
/// other bodies, where nothing works on them).
template <int dim> struct GradientStressState {
  Tensor<dim> H = Tensor<dim>::Zero(); ///< du_i/dx_j
  double hoop = 0.0;                   ///< u_x / x
  Tensor<dim> sigma = Tensor<dim>::Zero();
  double sigma_hoop = 0.0;

  /// Volume change, the part round the axis included.
  [[nodiscard]] double dilatation() const { return H.trace() + hoop; }
  /// Work density of this state's stress on the strain of another, the part round the axis included
  /// [stress].
  [[nodiscard]] double work_density_on(const GradientStressState& other) const {
    return sigma.cwiseProduct(other.H).sum() + sigma_hoop * other.hoop;
  }
};

/// An auxiliary field at a point off the front. About an axis it is carried round with the section,
/// in space along the front: a displacement of the body, but none of a body at rest.
template <int dim> struct AuxiliaryField : GradientStressState<dim> {
  /// Of its stress [stress/length] (crack.38, crack_space.5).
  shape::Point<dim> divergence = shape::Point<dim>::Zero();
};

} // namespace spricka::crack
