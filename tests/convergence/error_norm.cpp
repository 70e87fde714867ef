// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/convergence/error_norm.hpp"

#include "fe/element.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <cmath>

namespace spricka::test {

namespace {

template <int dim>
void add_element(const fe::AnyElement<dim>& element, const model::Model& model, base::ElementId e,
                 const base::Vector& u, const ExactField& exact, ErrorNorms& square) {
  const fe::AnyNodeVectors<dim> X = fe::element_coordinates(element, model.mesh, e);
  const fe::AnyNodeVectors<dim> U = fe::gather_element_values(element, model.mesh, e, u);
  const fe::ConstitutiveLaw law = fe::constitutive_law(model, model.mesh, e);
  for (const auto& point : shape::quadrature<dim>(element.domain, dim == 3 ? 7 : 10)) {
    const auto at = fe::jacobian(element, X, point.r);
    base::Vec3 x = base::Vec3::Zero();
    x.template head<dim>() = X * element.N(point.r);
    const base::Vec3 found = exact.u(x);
    const Eigen::Matrix<double, dim, dim> H =
        exact.H(x).template topLeftCorner<dim, dim>() - U.lazyProduct(at.dNdx);
    const fe::HoopStrain<fe::AnyElement<dim>> hoop(element, X, law, point.r);
    const double ring = law.axisymmetric ? found.x() / x.x() - U.row(0) * hoop.h : 0.0;
    const double trace = H.trace() + ring;
    const double w = point.weight * at.det * law.depth(x.x());
    square.L2 += w * (found.template head<dim>() - U * element.N(point.r)).squaredNorm();
    square.energy += w * (law.lambda * trace * trace +
                          2.0 * law.mu * (0.25 * (H + H.transpose()).squaredNorm() + ring * ring));
  }
}

} // namespace

ErrorNorms error_norms(const model::Model& model, const base::Vector& u, const ExactField& exact) {
  ErrorNorms square;
  for (const base::ElementId e : every_element(model.mesh)) {
    fe::with_any_element(model.mesh, e, [&]<int dim>(const fe::AnyElement<dim>& element) {
      add_element<dim>(element, model, e, u, exact, square);
    });
  }
  return {std::sqrt(square.L2), std::sqrt(square.energy)};
}

ErrorNorms error_norms(const model::Model& model, const base::Vector& u, const Exact& exact) {
  const auto flat = [](const base::Vec3& x) { return Eigen::Vector2d(x.head<2>()); };
  ExactField field;
  field.u = [&](const base::Vec3& x) {
    base::Vec3 u3 = base::Vec3::Zero();
    u3.head<2>() = exact.u(flat(x));
    return u3;
  };
  field.H = [&](const base::Vec3& x) {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    H.topLeftCorner<2, 2>() = exact.H(flat(x));
    return H;
  };
  return error_norms(model, u, field);
}

double slope(const std::vector<double>& errors) {
  std::vector<int> n;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    n.push_back(1 << i);
  }
  return slope(n, errors);
}

double slope(const std::vector<int>& n, const std::vector<double>& errors) {
  const auto count = static_cast<double>(errors.size());
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = -std::log(static_cast<double>(n[i]));
    const double y = std::log(errors[i]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

} // namespace spricka::test
