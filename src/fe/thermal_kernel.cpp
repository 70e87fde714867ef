// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/thermal_kernel.hpp"

#include "base/dense_solve.hpp"

#include <Eigen/Cholesky>

namespace spricka::fe {

namespace {

// Whether an element's displacements hold all quadratic functions of x: its nodes are where its
// corners put them, those of a QUAMC8 on a parallelogram. Quarter-point elements do not.
bool holds_quadratics(const AnyElement<2>& element, const AnyNodeVectors<2>& X) {
  const auto C = X.leftCols(element.corners);
  const double least = 1e-9 * (C.rowwise().maxCoeff() - C.rowwise().minCoeff()).norm();
  if (element.nodes == 8 && (X.col(0) - X.col(1) + X.col(2) - X.col(3)).norm() > least) {
    return false;
  }
  for (int n = element.corners; n < element.nodes; ++n) {
    if ((X.col(n) - C * element.linear_element().N(element.node_local_coordinates(n))).norm() >
        least) {
      return false;
    }
  }
  return true;
}

} // namespace

FreeExpansion::FreeExpansion(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                             const ConstitutiveLaw& law, const CornerValues<2>& T)
    : centre_(X.leftCols(element.corners).rowwise().mean()),
      strain_(law.expansion * (law.heated_direction_count() * law.lambda + 2.0 * law.mu) /
              (2.0 * (law.lambda + law.mu))) {
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 4, 3> A(element.corners, 3);
  A.col(0).setOnes();
  A.rightCols<2>() = (X.leftCols(element.corners).colwise() - centre_).transpose();
  // The plane through three corners, or the nearest to four.
  const Eigen::Matrix3d normal = A.transpose().lazyProduct(A);
  const Eigen::Vector3d right = A.transpose() * T;
  plane_ = normal.ldlt().solve(right);
}

bool FreeExpansion::must_remove_beforehand(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                                           const ConstitutiveLaw& law) {
  return element.quadratic && !law.axisymmetric && !law.projected && !holds_quadratics(element, X);
}

base::Vec2 FreeExpansion::displacement(const base::Vec2& x) const {
  const base::Vec2 d = x - centre_;
  const base::Vec2 g = temperature_gradient();
  // (fe.38).
  const double square = 0.5 * (d.x() * d.x() - d.y() * d.y());
  const double product = d.x() * d.y();
  return strain_ * (plane_[0] * d +
                    base::Vec2(g.x() * square + g.y() * product, g.x() * product - g.y() * square));
}

Eigen::Matrix2d FreeExpansion::gradient(const base::Vec2& x) const {
  const base::Vec2 d = x - centre_;
  const double turn = temperature_gradient().y() * d.x() - temperature_gradient().x() * d.y();
  const double T = temperature(x);
  Eigen::Matrix2d H;
  // The same strain in all directions, no shear, and a rotation.
  H << T, turn, -turn, T;
  return strain_ * H;
}

AnyNodeVectors<2> FreeExpansion::at_nodes(const AnyNodeVectors<2>& X) const {
  AnyNodeVectors<2> U(2, X.cols());
  for (Eigen::Index n = 0; n < X.cols(); ++n) {
    U.col(n) = displacement(X.col(n));
  }
  return U;
}

std::optional<AnyNodeVectors<2>> free_expansion_displacements(const AnyElement<2>& element,
                                                              const AnyNodeVectors<2>& X,
                                                              const ConstitutiveLaw& law,
                                                              const CornerValues<2>& T) {
  if (!FreeExpansion::must_remove_beforehand(element, X, law)) {
    return std::nullopt;
  }
  return FreeExpansion(element, X, law, T).at_nodes(X);
}

template <int dim>
TemperatureFunctions<dim>::TemperatureFunctions(const AnyElement<dim>& element,
                                                const AnyNodeVectors<dim>& X)
    : element_(&element), X_(X) {
  if (bent()) {
    const auto C = X.leftCols(element.corners);
    const CornerGradients<dim> A = (C.colwise() - C.rowwise().mean()).transpose();
    const Eigen::Matrix<double, dim, dim> normal = A.transpose().lazyProduct(A);
    slope_ = A.lazyProduct(Eigen::Matrix<double, dim, dim>(
        normal.ldlt().solve(Eigen::Matrix<double, dim, dim>::Identity())));
  }
}

template <int dim>
CornerValues<dim> TemperatureFunctions<dim>::at(const shape::Point<dim>& r) const {
  CornerValues<dim> L = element_->linear_element().N(r);
  if (bent()) {
    // How far a point is from where the corners put it.
    const Eigen::Matrix<double, dim, 1> off =
        X_ * element_->N(r) - X_.leftCols(element_->corners) * L;
    L += slope_ * off;
  }
  return L;
}

template <int dim>
CornerGradients<dim> TemperatureFunctions<dim>::gradients(const Eigen::Matrix<double, dim, dim>& J,
                                                          const shape::Point<dim>& r) const {
  using Square = Eigen::Matrix<double, dim, dim>;
  const Square inverse = J.inverse();
  CornerGradients<dim> G = element_->linear_element().dN(r).lazyProduct(inverse);
  if (bent()) {
    const Square off = Square::Identity() - Square(X_.leftCols(element_->corners).lazyProduct(G));
    G += slope_.lazyProduct(off);
  }
  return G;
}

template <int dim>
ThermalStress<dim>::ThermalStress(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                                  const ConstitutiveLaw& law, const CornerValues<dim>& T)
    : element_(&element), law_(&law), T_(T), cold_((T.array() == 0.0).all()),
      functions_(element, X) {
  using Volume = ProjectedDilatation<AnyElement<dim>>;
  if (!law.projected || cold_) {
    return;
  }
  typename Volume::Modes right = Volume::Modes::Zero(Volume::mode_count(element));
  for (const auto& point : stiffness_rule(element, law)) {
    const HoopStrain<AnyElement<dim>> hoop(element, X, law, point.r);
    const double w = point.weight * jacobian(element, X, point.r).det * law.depth(hoop.x);
    right += (w * temperature(point.r)) * Volume::phi(element, point.r);
  }
  // As the volume change (fe.12): what drives it must be of the same functions.
  projected_ = Volume(element, X, law).coefficients_from_integrals(right);
}

template <int dim>
AnyNodeVectors<dim> thermal_forces(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                                   const ConstitutiveLaw& law, const CornerValues<dim>& T) {
  if (const auto U = free_expansion_displacements(element, X, law, T)) {
    return element_force(element, X, law, *U); // F = K_e u_T of (fe.38)
  }
  const ThermalStress<dim> stress(element, X, law, T);
  AnyNodeVectors<dim> F = AnyNodeVectors<dim>::Zero(dim, element.nodes);
  for (const auto& point : stiffness_rule(element, law)) {
    const auto at = jacobian(element, X, point.r);
    const HoopStrain<AnyElement<dim>> hoop(element, X, law, point.r);
    // (fe.22).
    const double w = point.weight * at.det * law.depth(hoop.x) * stress.at(point.r);
    F += w * at.dNdx.transpose();
    F.row(0) += w * hoop.h.transpose();
  }
  return F;
}

template <int dim>
CornerValues<dim> project_temperature(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                                      const ConstitutiveLaw& law,
                                      std::span<const WeightedTemperature<dim>> samples) {
  using Place = shape::Point<dim>;
  const TemperatureFunctions<dim> heat(element, X);
  const Place centre = X.leftCols(element.corners).rowwise().mean();
  const bool in_x = FreeExpansion::must_remove_beforehand(element, X, law);
  const auto functions = [&](const Place& x, const Place& r) -> base::Vector {
    if (!element.quadratic) {
      return base::Vector::Ones(1); // the mean (fe.23)
    }
    if (in_x) {
      base::Vector f(1 + dim);
      f << 1.0, x - centre;
      return f;
    }
    return heat.at(r);
  };
  const Eigen::Index terms = functions(centre, element.centre()).size();
  base::Matrix G = base::Matrix::Zero(terms, terms);
  base::Vector right = base::Vector::Zero(terms);
  for (const WeightedTemperature<dim>& s : samples) {
    const base::Vector f = functions(X * element.N(s.r), s.r);
    G += (s.weight * f) * f.transpose();
    right += (s.weight * s.T) * f;
  }
  const base::Vector c = base::solve_semidefinite_system(G, right);
  CornerValues<dim> T(element.corners);
  for (int n = 0; n < element.corners; ++n) {
    T[n] = c.dot(functions(X.col(n), element.node_local_coordinates(n)));
  }
  return T;
}

#define THERMAL(dim)                                                                               \
  template class TemperatureFunctions<dim>;                                                        \
  template class ThermalStress<dim>;                                                               \
  template AnyNodeVectors<dim> thermal_forces<dim>(                                                \
      const AnyElement<dim>&, const AnyNodeVectors<dim>&, const ConstitutiveLaw&,                  \
      const CornerValues<dim>&);                                                                   \
  template CornerValues<dim> project_temperature<dim>(                                             \
      const AnyElement<dim>&, const AnyNodeVectors<dim>&, const ConstitutiveLaw&,                  \
      std::span<const WeightedTemperature<(dim)>>);
THERMAL(2)
THERMAL(3)

} // namespace spricka::fe
