// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"
#include "fe/stress.hpp"

namespace spricka::fe {

/// Six components from those of a state: plane strain has zz = nu (xx + yy).
template <int dim>
Stress all_components(const Strain<dim>& sigma, const model::Material& material,
                      model::State state) {
  if constexpr (dim == 3) {
    return sigma;
  } else {
    Stress s = Stress::Zero();
    s[0] = sigma[0];
    s[1] = sigma[1];
    s[2] = state == model::State::plane_strain ? material.nu * (sigma[0] + sigma[1]) : 0.0;
    s[3] = sigma[2];
    return s;
  }
}

/// One element, ready for stresses at its points.
template <shape::ElementShape S> struct StressElement {
  NodeVectors<S> X;
  NodeVectors<S> U;
  Elasticity<S::dim> D;
  const model::Material* material = nullptr;
  model::State state = model::State::plane_stress;

  StressElement(const model::Model& model, const model::Mesh& mesh, base::ElementId e,
                const base::Vector& u)
      : X(coordinates<S>(mesh, e)), U(gather<S>(mesh, e, u)), material(&model.material_of(mesh, e)),
        state(model.property_of(mesh, e).state) {
    D = elasticity<S::dim>(*material, state);
  }

  [[nodiscard]] Stress from(const Jacobian<S>& at) const {
    const Eigen::Matrix<double, S::dim, S::dim> H = U * at.dNdx;
    return all_components<S::dim>(D * strain<S::dim>(H), *material, state);
  }

  /// Stress at reference coordinates r; where the map is singular, that of the centre.
  [[nodiscard]] Stress at(const shape::Point<S::dim>& r) const {
    const Jacobian<S> here = jacobian<S>(X, r);
    const Jacobian<S> centre = jacobian<S>(X, shape::centre<S>());
    return from(std::abs(here.det) > 1e-10 * std::abs(centre.det) ? here : centre);
  }
};

} // namespace spricka::fe
