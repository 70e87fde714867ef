// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/stress.hpp"
#include "fe/thermal_kernel.hpp"

namespace spricka::fe {

/// One element, ready for stresses at its points.
template <shape::ElementShape S> struct StressElement {
  NodeVectors<S> X;
  NodeVectors<S> U;
  Law law;
  VolumeChange<S> change;
  ThermalStress<S> thermal;

  StressElement(const model::Model& model, const model::Mesh& mesh, base::ElementId e,
                const StateField& field)
      : X(coordinates<S>(mesh, e)), U(gather<S>(mesh, e, field.u)), law(law_of(model, mesh, e)),
        change(X, law, U), thermal(X, law, held_temperature(mesh, e, field)) {}
  StressElement(const StressElement&) = delete; // its members point at its law
  StressElement& operator=(const StressElement&) = delete;

  // In the plane and about an axis, zz is across the mesh: nothing, or what lambda and the hoop
  // strain make of it.
  [[nodiscard]] Stress from(const Jacobian<S>& at, const shape::Point<S::dim>& r) const {
    const Eigen::Matrix<double, S::dim, S::dim> H = U * at.dNdx;
    const double ring = hoop_strain(H, r);
    const double pressure = law.lambda * change.at(r, H.trace() + ring) - thermal.at(r);
    Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
    s.template topLeftCorner<S::dim, S::dim>() = law.mu * (H + H.transpose());
    s(2, 2) += S::dim == 2 ? 2.0 * law.mu * ring : 0.0;
    s.diagonal().array() += pressure;
    if (law.plane_stress) {
      s(2, 2) = 0.0;
    }
    Stress six;
    six << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    return six;
  }

  /// Stress at reference coordinates r; where the map is singular or folds over (a corner that
  /// mesh/quality.hpp lets pass), and gradients are without meaning, that of the centre.
  [[nodiscard]] Stress at(const shape::Point<S::dim>& r) const {
    const Jacobian<S> here = jacobian<S>(X, r);
    const Jacobian<S> centre = jacobian<S>(X, shape::centre<S>());
    return here.det > 1e-2 * centre.det ? from(here, r) : from(centre, shape::centre<S>());
  }

private:
  // What stays of the temperature once bent elements have expanded freely.
  CornerValues<S> held_temperature(const model::Mesh& mesh, base::ElementId e,
                                   const StateField& field) {
    if (field.temperature == nullptr) {
      return CornerValues<S>::Zero();
    }
    CornerValues<S> T = corner_temperature<S>(mesh, e, *field.temperature);
    if constexpr (plane_quadratic<S>) {
      if (FreeExpansion<S>::wanted(X, law)) {
        U -= FreeExpansion<S>(X, law, T).at_nodes(X);
        return CornerValues<S>::Zero();
      }
    }
    return T;
  }

  // u / x, and on the axis its limit du/dx.
  [[nodiscard]] double hoop_strain(const Eigen::Matrix<double, S::dim, S::dim>& H,
                                   const shape::Point<S::dim>& r) const {
    if (!law.axisymmetric) {
      return 0.0;
    }
    const Eigen::Matrix<double, S::nodes, 1> N = S::N(r);
    const double x = X.row(0) * N;
    const double size = X.row(0).maxCoeff() - X.row(0).minCoeff();
    return x > 1e-9 * size ? (U.row(0) * N).value() / x : H(0, 0);
  }
};

} // namespace spricka::fe
