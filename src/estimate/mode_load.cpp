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

// Of the modes of an element only that of the loaded side moves the side.
void add_on_side(const Enrichment& enrichment, const model::Face& face, double t, const Vec3& force,
                 base::Vector& f) {
  const model::Mesh& mesh = enrichment.mesh();
  const SideState sides = enrichment.sides(face.element);
  const auto s = static_cast<std::size_t>(face.side);
  const double psi = sides.sign[s] * side_mode(t);
  const std::span<const std::int32_t> freedom = enrichment.of_element(face.element);
  Vec2 along = force.head<2>();
  if (sides.framed[s]) {
    with_mode_shape(mesh.type[face.element.index()], [&]<shape::PlaneShape S>(S) {
      const SideFrame frame =
          side_frame(side_points<S>(fe::coordinates<S>(mesh, face.element), face.side), t);
      along = {frame.axis[0].dot(force.head<2>()), frame.axis[1].dot(force.head<2>())};
    });
  }
  f[freedom[2 * s]] += psi * along.x();
  f[freedom[2 * s + 1]] += psi * along.y();
}

template <shape::PlaneShape S>
void add_inside(const Enrichment& enrichment, base::ElementId e, const shape::Point<2>& r,
                const Vec3& force, base::Vector& f) {
  using M = Modes<S>;
  const SideState sides = enrichment.sides(e);
  const std::span<const std::int32_t> freedom = enrichment.of_element(e);
  Eigen::Matrix<double, M::count, 1> psi = M::psi(r);
  const fe::NodeVectors<S> X = fe::coordinates<S>(enrichment.mesh(), e);
  for (int m = 0; m < M::count; ++m) {
    Vec2 along = force.head<2>();
    if (m < M::sides) {
      const auto s = static_cast<std::size_t>(m);
      psi[m] *= sides.sign[s];
      if (sides.framed[s]) {
        const SideFrame frame = side_frame(side_points<S>(X, m), M::along(r, m));
        along = {frame.axis[0].dot(force.head<2>()), frame.axis[1].dot(force.head<2>())};
      }
    }
    f[freedom[static_cast<std::size_t>(2 * m)]] += psi[m] * along.x();
    f[freedom[static_cast<std::size_t>(2 * m + 1)]] += psi[m] * along.y();
  }
}

// Forces of the modes of an element by a stress (tensor) at a point, its weight included.
template <shape::PlaneShape S> using ModeForces = Eigen::Matrix<double, mode_freedoms<S>, 1>;
template <shape::PlaneShape S>
ModeForces<S> pressed(const ModeGradients<S>& G, const Eigen::Matrix2d& stress) {
  return G.transpose() * Eigen::Vector4d(stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1));
}

// What the temperature that an element takes does to its modes. Where a part expands it freely the
// nodes bear what their displacements make of that, and so do the modes: nothing is missed of it.
template <shape::PlaneShape S>
ModeForces<S> taken_forces(const fe::NodeVectors<S>& X, const fe::Law& law,
                           const fe::CornerValues<S>& T, const SideState& sides) {
  const fe::ThermalStress<S> thermal(X, law, T);
  // (fe.38): stress of the expansion at the nodes, int B_e^T D B u_T dV.
  const bool carried = fe::FreeExpansion<S>::wanted(X, law);
  const fe::NodeVectors<S> U =
      carried ? fe::FreeExpansion<S>(X, law, T).at_nodes(X) : fe::NodeVectors<S>::Zero();
  ModeForces<S> F = ModeForces<S>::Zero();
  for (const auto& point : shape::quadrature<S>(Modes<S>::degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const double even = thermal.at(point.r);
    Eigen::Matrix2d stress = even * Eigen::Matrix2d::Identity();
    if (law.axisymmetric) { // nothing is carried there, and the strain round the axis takes part
      const double x = X.row(0) * S::N(point.r);
      const double w = point.weight * at.det * law.depth(x);
      F += pressed<S>(mode_gradients<S>(X, point.r, at.J, sides), w * stress);
      F += w * even / x * mode_outward<S>(X, point.r, sides).transpose();
      continue;
    }
    if (carried) {
      const Eigen::Matrix2d H = U * at.dNdx;
      stress = law.mu * (H + H.transpose());
      stress.diagonal().array() += law.lambda * H.trace();
    }
    F += pressed<S>(mode_gradients<S>(X, point.r, at.J, sides),
                    point.weight * at.det * law.thickness * stress);
  }
  return F;
}

// A temperature presses on the volume change of the modes, also with what elements do not take.
void add_thermal(const Enrichment& enrichment, const fe::CaseHeat& heat, base::Vector& f) {
  const model::Mesh& mesh = enrichment.mesh();
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    with_mode_shape(mesh.type[i], [&]<shape::PlaneShape S>(S) {
      const fe::CornerValues<S> T = fe::corner_temperature<S>(mesh, e, heat.temperature);
      const std::span<const fe::HeatPoint> points = heat.of(e);
      if ((T.array() == 0.0).all() && points.empty()) {
        return;
      }
      const fe::NodeVectors<S> X = fe::coordinates<S>(mesh, e);
      const fe::Law law = fe::law_of(enrichment.model(), mesh, e);
      const SideState sides = enrichment.sides(e);
      // What the element takes, then the rest at its points (fe.39).
      ModeForces<S> F = taken_forces<S>(X, law, T, sides);
      const double beta = law.thickness * fe::heat_modulus(law);
      for (const fe::HeatPoint& p : points) {
        F += pressed<S>(mode_gradients<S>(X, p.r, fe::jacobian<S>(X, p.r).J, sides),
                        beta * p.area * p.T * Eigen::Matrix2d::Identity());
      }
      const std::span<const std::int32_t> freedom = enrichment.of_element(e);
      for (int m = 0; m < mode_freedoms<S>; ++m) {
        f[freedom[static_cast<std::size_t>(m)]] += F[m];
      }
    });
  }
}

} // namespace

base::Vector mode_load(const Enrichment& enrichment, const model::LoadCase& load_case,
                       const fe::CaseHeat* heat) {
  const model::Model& model = enrichment.model();
  const model::Mesh& mesh = enrichment.mesh();
  base::Vector f = base::Vector::Zero(enrichment.freedoms());
  const auto on_side = [&](const model::Face& face, std::span<const fe::LoadPoint> points) {
    for (const fe::LoadPoint& p : points) {
      add_on_side(enrichment, face, p.r[0], p.force, f);
    }
  };
  const auto inside = [&](base::ElementId e, std::span<const fe::LoadPoint> points) {
    with_mode_shape(mesh.type[e.index()], [&]<shape::PlaneShape S>(S) {
      for (const fe::LoadPoint& p : points) {
        add_inside<S>(enrichment, e, p.r.head<2>(), p.force, f);
      }
    });
  };
  for (const model::Load& load : load_case.loads) {
    fe::for_load_points(model, mesh, load, {on_side, inside});
  }
  const fe::CaseHeat own =
      heat == nullptr ? fe::case_heat(model, {mesh, mesh, nullptr, {}}, load_case) : fe::CaseHeat();
  const fe::CaseHeat& all = heat == nullptr ? own : *heat;
  if (all.temperature.size() > 0) {
    add_thermal(enrichment, all, f);
  }
  return f;
}

} // namespace spricka::estimate
