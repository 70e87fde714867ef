// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/mode_load.hpp"

#include "fe/heat.hpp"
#include "fe/load_points.hpp"
#include "fe/thermal.hpp"
#include "model/loads.hpp"

namespace spricka::estimate {

namespace {

using base::Vec2;
using base::Vec3;

/// An element with its modes, and how it carries them.
struct ModeElement {
  const fe::AnyElement<2>& shape;
  const PlaneModes& modes;
  fe::AnyNodeVectors<2> X;
  SideModeFrames sides;
  std::span<const std::int32_t> freedom;

  ModeElement(const CubicEnrichment& enrichment, base::ElementId e)
      : shape(shape::reference_element<2>(enrichment.mesh().type[e.index()])),
        modes(PlaneModes::for_type(enrichment.mesh().type[e.index()])),
        X(fe::element_coordinates(shape, enrichment.mesh(), e)),
        sides(enrichment.element_side_frames(e)), freedom(enrichment.element_freedoms(e)) {}

  /// A force along the axes of a side's mode at t.
  [[nodiscard]] Vec2 along(std::size_t side, double t, const Vec3& force) const {
    if (!sides.framed[side]) {
      return force.head<2>();
    }
    const SideFrame frame = side_frame(side_node_coordinates(modes, X, static_cast<int>(side)), t);
    return {frame.axis[0].dot(force.head<2>()), frame.axis[1].dot(force.head<2>())};
  }
};

// Of the modes of an element only that of the loaded side moves the side.
void add_on_side(const ModeElement& element, int side, double t, const Vec3& force,
                 base::Vector& f) {
  const auto s = static_cast<std::size_t>(side);
  const double psi = element.sides.sign[s] * side_mode_value(t);
  const Vec2 along = element.along(s, t, force);
  f[element.freedom[2 * s]] += psi * along.x();
  f[element.freedom[2 * s + 1]] += psi * along.y();
}

void add_inside(const ModeElement& element, const shape::Point<2>& r, const Vec3& force,
                base::Vector& f) {
  const PlaneModes& modes = element.modes;
  PlaneModes::Values psi = modes.psi(r);
  for (int m = 0; m < modes.count; ++m) {
    Vec2 along = force.head<2>();
    if (m < modes.sides) {
      const auto s = static_cast<std::size_t>(m);
      psi[m] *= element.sides.sign[s];
      along = element.along(s, modes.along(r, m), force);
    }
    f[element.freedom[static_cast<std::size_t>(2 * m)]] += psi[m] * along.x();
    f[element.freedom[static_cast<std::size_t>(2 * m + 1)]] += psi[m] * along.y();
  }
}

// Forces of the modes of an element by a stress (tensor) at a point, its weight included. J of the
// map there.
ModeNumbers pressed(const ModeElement& element, const shape::Point<2>& r, const Eigen::Matrix2d& J,
                    const Eigen::Matrix2d& stress) {
  const ModeGradients G = mode_gradients(element.modes, element.X, r, J, element.sides);
  return G.transpose() * Eigen::Vector4d(stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1));
}

// What the temperature that an element takes does to its modes. Where a part expands it freely the
// nodes bear what their displacements make of that, and so do the modes: nothing is missed of it.
ModeNumbers taken_forces(const ModeElement& element, const fe::ConstitutiveLaw& law,
                         const fe::CornerValues<2>& T) {
  const fe::AnyElement<2>& shape = element.shape;
  const fe::AnyNodeVectors<2>& X = element.X;
  const fe::ThermalStress<2> thermal(shape, X, law, T);
  // (fe.38): stress of the expansion at the nodes, int B_e^T D B u_T dV.
  const bool carried = fe::FreeExpansion::must_remove_beforehand(shape, X, law);
  fe::AnyNodeVectors<2> U;
  if (carried) {
    U = fe::FreeExpansion(shape, X, law, T).at_nodes(X);
  }
  ModeNumbers F = ModeNumbers::Zero(element.modes.freedoms());
  for (const auto& point : shape::quadrature<2>(shape.domain, element.modes.degree)) {
    const fe::Jacobian<fe::AnyElement<2>> at = fe::jacobian(shape, X, point.r);
    const double even = thermal.at(point.r);
    Eigen::Matrix2d stress = even * Eigen::Matrix2d::Identity();
    if (law.axisymmetric) { // nothing is carried there, and the strain round the axis takes part
      const double x = X.row(0) * shape.N(point.r);
      const double w = point.weight * at.det * law.depth(x);
      F += pressed(element, point.r, at.J, w * stress);
      F += w * even / x * mode_x_displacements(element.modes, X, point.r, element.sides);
      continue;
    }
    if (carried) {
      const Eigen::Matrix2d H = U.lazyProduct(at.dNdx);
      stress = law.mu * (H + H.transpose());
      stress.diagonal().array() += law.lambda * H.trace();
    }
    F += pressed(element, point.r, at.J, point.weight * at.det * law.thickness * stress);
  }
  return F;
}

// A temperature presses on the volume change of the modes, also with what elements do not take.
void add_thermal(const CubicEnrichment& enrichment, const fe::CaseTemperature& heat,
                 base::Vector& f) {
  const model::Mesh& mesh = enrichment.mesh();
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const fe::CornerValues<2> T = fe::gather_corner_temperatures(
        shape::reference_element<2>(mesh.type[i]), mesh, e, heat.temperature);
    const std::span<const fe::ResidualTemperaturePoint> points = heat.residual_points_in_element(e);
    if ((T.array() == 0.0).all() && points.empty()) {
      continue;
    }
    const ModeElement element(enrichment, e);
    const fe::ConstitutiveLaw law = fe::constitutive_law(enrichment.model(), mesh, e);
    // What the element takes, then the rest at its points (fe.39).
    ModeNumbers F = taken_forces(element, law, T);
    const double beta = law.thickness * fe::thermal_modulus(law);
    for (const fe::ResidualTemperaturePoint& p : points) {
      const Eigen::Matrix2d J = element.X.lazyProduct(element.shape.dN(p.r));
      F += pressed(element, p.r, J, beta * p.area * p.T * Eigen::Matrix2d::Identity());
    }
    for (Eigen::Index m = 0; m < F.size(); ++m) {
      f[element.freedom[static_cast<std::size_t>(m)]] += F[m];
    }
  }
}

} // namespace

base::Vector mode_load(const CubicEnrichment& enrichment, const model::LoadCase& load_case,
                       const fe::CaseTemperature& heat) {
  const model::Model& model = enrichment.model();
  const model::Mesh& mesh = enrichment.mesh();
  base::Vector f = base::Vector::Zero(enrichment.freedoms());
  const auto on_side = [&](const model::Face& face, std::span<const fe::LoadPoint> points) {
    const ModeElement element(enrichment, face.element);
    for (const fe::LoadPoint& p : points) {
      add_on_side(element, face.side, p.r[0], p.force, f);
    }
  };
  const auto inside = [&](base::ElementId e, std::span<const fe::LoadPoint> points) {
    const ModeElement element(enrichment, e);
    for (const fe::LoadPoint& p : points) {
      add_inside(element, p.r.head<2>(), p.force, f);
    }
  };
  for (const model::Load& load : load_case.loads) {
    fe::for_load_points(model, mesh, load, {on_side, inside});
  }
  if (heat.temperature.size() > 0) {
    add_thermal(enrichment, heat, f);
  }
  return f;
}

} // namespace spricka::estimate
