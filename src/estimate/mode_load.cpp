// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/mode_load.hpp"

#include "fe/load_points.hpp"
#include "fe/thermal.hpp"
#include "fe/thermal_kernel.hpp"

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

// A temperature presses on the volume change of the modes.
void add_thermal(const Enrichment& enrichment, const base::Vector& temperature, base::Vector& f) {
  const model::Mesh& mesh = enrichment.mesh();
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    with_mode_shape(mesh.type[i], [&]<shape::PlaneShape S>(S) {
      const fe::CornerValues<S> T = fe::corner_temperature<S>(mesh, e, temperature);
      if ((T.array() == 0.0).all()) {
        return;
      }
      const fe::NodeVectors<S> X = fe::coordinates<S>(mesh, e);
      const fe::Law law = fe::law_of(enrichment.model(), mesh, e);
      const fe::ThermalStress<S> thermal(X, law, T);
      const SideState sides = enrichment.sides(e);
      const std::span<const std::int32_t> freedom = enrichment.of_element(e);
      for (const auto& point : shape::quadrature<S>(Modes<S>::degree)) {
        const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
        const double w = point.weight * at.det * law.thickness * thermal.at(point.r);
        const ModeGradients<S> G = mode_gradients<S>(X, point.r, at.J, sides);
        for (int m = 0; m < mode_freedoms<S>; ++m) {
          f[freedom[static_cast<std::size_t>(m)]] += w * (G(0, m) + G(3, m));
        }
      }
    });
  }
}

} // namespace

base::Vector mode_load(const Enrichment& enrichment, const model::LoadCase& load_case) {
  const model::Model& model = enrichment.model();
  const model::Mesh& mesh = enrichment.mesh();
  base::Vector f = base::Vector::Zero(enrichment.freedoms());
  for (const model::Load& load : load_case.loads) {
    fe::for_load_points(
        model, mesh, load,
        [&]<shape::Shape Side>(Side, const model::Face& face, const shape::Point<Side::dim>& r,
                               const Vec3& force) {
          if constexpr (Side::dim == 1) {
            add_on_side(enrichment, face, r[0], force, f);
          }
        },
        [&]<shape::Shape S>(S, base::ElementId e, const shape::Point<S::dim>& r,
                            const Vec3& force) {
          if constexpr (has_modes(S::type)) {
            add_inside<S>(enrichment, e, r, force, f);
          }
        });
  }
  const base::Vector T = fe::element_temperature(model, mesh, load_case);
  if (T.size() > 0) {
    add_thermal(enrichment, T, f);
  }
  return f;
}

} // namespace spricka::estimate
