// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

/// What the motion of nodes releases, at a point of an element, in the plane and in space. A
/// displacement with the gradient H = du/dx that keeps its nodal values while nodes move by v
/// changes by dH = -H grad v; so its energy falls by T : grad v a volume (Eshelby 1975).
namespace spricka::crack {

template <int dim> using Tensor = Eigen::Matrix<double, dim, dim>;

/// Stress of a displacement gradient by the elasticity of an element, temperatures left out.
template <int dim>
Tensor<dim> stress_from_gradient(const fe::Elasticity<dim>& D, const Tensor<dim>& H) {
  const fe::Strain<dim> sigma = D * fe::strain<dim>(H);
  return fe::stress_tensor<dim>(sigma);
}

/// H and the stress of a displacement.
template <int dim> struct GradientAndStress {
  const Tensor<dim>& H;
  const Tensor<dim>& sigma;
};

/// Energy-momentum H^T sigma - W I of one displacement [stress] (manual, crack.4); W is half of
/// sigma : H, less `heat`, what a temperature has a part in: beta T tr(H).
template <int dim> Tensor<dim> energy_momentum(const GradientAndStress<dim>& u, double heat = 0.0) {
  Tensor<dim> T = u.H.transpose() * u.sigma;
  T.diagonal().array() -= 0.5 * (u.sigma.cwiseProduct(u.H).sum() - heat);
  return T;
}

} // namespace spricka::crack
