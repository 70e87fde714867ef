// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress_kernel.hpp"

namespace spricka::fe {

template <shape::ElementShape S>
ElementStressEvaluator<S>::ElementStressEvaluator(const model::Model& model,
                                                  const model::Mesh& mesh, base::ElementId e,
                                                  const DisplacementTemperatureField& field)
    : X(element_coordinates<S>(mesh, e)), U(gather_element_values<S>(mesh, e, field.u)),
      law(constitutive_law(model, mesh, e)), change(S{}, X, law, U),
      thermal(shape::as_reference_element<S>(), X, law, held_temperature(mesh, e, field)) {}

// In the plane and about an axis, zz is across the mesh: nothing, or what lambda and the hoop
// strain make of it.
template <shape::ElementShape S>
Stress ElementStressEvaluator<S>::stress_from_map(const Jacobian<S>& at,
                                                  const shape::Point<S::dim>& r) const {
  const Eigen::Matrix<double, S::dim, S::dim> H = U.lazyProduct(at.dNdx); // as in jacobian.cpp
  const double ring = hoop_strain(H, r);
  // (fe.24).
  const double pressure = law.lambda * change.at(r, H.trace() + ring) - thermal.at(r);
  Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
  s.template topLeftCorner<S::dim, S::dim>() = law.mu * (H + H.transpose());
  s(2, 2) += 2.0 * law.mu * ring;
  s.diagonal().array() += pressure;
  if (law.plane_stress) {
    s(2, 2) = 0.0;
  }
  Stress six;
  six << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
  return six;
}

template <shape::ElementShape S>
Stress ElementStressEvaluator<S>::at(const shape::Point<S::dim>& r) const {
  const Jacobian<S> here = jacobian<S>(X, r);
  const Jacobian<S> centre = jacobian<S>(X, shape::centre<S>());
  return here.det > 1e-2 * centre.det ? stress_from_map(here, r)
                                      : stress_from_map(centre, shape::centre<S>());
}

// What stays of the temperature once bent elements have expanded freely.
template <shape::ElementShape S>
CornerValues<S::dim>
ElementStressEvaluator<S>::held_temperature(const model::Mesh& mesh, base::ElementId e,
                                            const DisplacementTemperatureField& field) {
  const AnyElement<S::dim>& element = shape::as_reference_element<S>();
  CornerValues<S::dim> none = CornerValues<S::dim>::Zero(element.corners);
  if (field.temperature == nullptr) {
    return none;
  }
  CornerValues<S::dim> T = gather_corner_temperatures(element, mesh, e, *field.temperature);
  if (const auto free = free_expansion_displacements(element, X, law, T)) {
    U -= *free;
    return none;
  }
  return T;
}

// u / x, and on the axis its limit du/dx.
template <shape::ElementShape S>
double ElementStressEvaluator<S>::hoop_strain(const Eigen::Matrix<double, S::dim, S::dim>& H,
                                              const shape::Point<S::dim>& r) const {
  if (!law.axisymmetric) {
    return 0.0;
  }
  const Eigen::Matrix<double, S::nodes, 1> N = S::N(r);
  const double x = X.row(0) * N;
  const double size = X.row(0).maxCoeff() - X.row(0).minCoeff();
  return x > 1e-9 * size ? (U.row(0) * N).value() / x : H(0, 0);
}

#define STRESS(S) template struct ElementStressEvaluator<S>;
SPRICKA_EACH_SHAPE(STRESS)

} // namespace spricka::fe
