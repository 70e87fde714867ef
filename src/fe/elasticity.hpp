// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/materials.hpp"

#include <cassert>

namespace spricka::fe {

/// Components of a strain or stress vector: xx yy xy in the plane, xx yy zz xy yz zx in space;
/// shear strains are the engineering ones (gamma = 2 eps).
constexpr int strain_components(int dim) {
  return dim * (dim + 1) / 2;
}

template <int dim> using Strain = Eigen::Matrix<double, strain_components(dim), 1>;
template <int dim>
using Elasticity = Eigen::Matrix<double, strain_components(dim), strain_components(dim)>;

/// Lame's constants [stress] of a state: sigma = lambda tr(eps) I + 2 mu eps over the components
/// kept. In plane stress lambda is E nu / (1 - nu^2), which holds sigma_zz at zero.
struct LameConstants {
  double lambda = 0.0;
  double mu = 0.0;
};
/// Lame's constants of an isotropic material by E and nu, lambda reduced in plane stress.
LameConstants lame_constants(const model::ElasticMaterial& material, model::StressState state);

/// D of sigma = D eps [stress]; dim 2 for plane stress and plane strain, 3 for a solid.
template <int dim>
Elasticity<dim> elasticity(const model::ElasticMaterial& material, model::StressState state) {
  assert(dim == model::element_dimension(state) && state != model::StressState::axisymmetric);
  const LameConstants k = lame_constants(material, state);
  Elasticity<dim> D = Elasticity<dim>::Zero();
  D.template topLeftCorner<dim, dim>().setConstant(k.lambda);
  D.diagonal().array() += k.mu;
  D.diagonal().template head<dim>().array() += k.mu;
  return D;
}

/// E' of Irwin's G = K^2 / E' [stress]: E in plane stress, E / (1 - nu^2) else.
double effective_modulus(const model::ElasticMaterial& material, model::StressState state);

} // namespace spricka::fe
