// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/bearing.hpp"
#include "fe/load_points.hpp"
#include "fe/thermal.hpp"

namespace spricka::fe {

namespace {

using base::Vec3;
using base::Vector;

void add_at_node(const model::Mesh& mesh, base::NodeId n, const Vec3& force, Vector& f) {
  f.segment(mesh.dim * static_cast<Eigen::Index>(n.index()), mesh.dim) += force.head(mesh.dim);
}

void add_nodal_forces(const model::Mesh& mesh, const model::Load& load, Vector& f) {
  for (const base::NodeId n : mesh.set(load.nodes).nodes) {
    add_at_node(mesh, n, load_value(load, mesh.x[n.index()]), f);
  }
}

void add_load(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
              Vector& f) {
  if (load.type == model::LoadType::force) {
    add_nodal_forces(mesh, load, f);
    return;
  }
  if (load.type == model::LoadType::bearing && mesh.dim == 3) {
    add_solid_bearing(mesh, load, f);
    return;
  }
  for_load_points(
      model, mesh, load,
      [&]<shape::Shape Side>(Side, const model::Face& face, const shape::Point<Side::dim>& r,
                             const Vec3& force) {
        const std::array<base::NodeId, Side::nodes> nodes = nodes_of_face<Side>(mesh, face);
        const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(r);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          add_at_node(mesh, nodes[i], N[static_cast<Eigen::Index>(i)] * force, f);
        }
      },
      [&]<shape::Shape S>(S, base::ElementId e, const shape::Point<S::dim>& r, const Vec3& force) {
        const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
        const Eigen::Matrix<double, S::nodes, 1> N = S::N(r);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          add_at_node(mesh, nodes[i], N[static_cast<Eigen::Index>(i)] * force, f);
        }
      });
}

} // namespace

Vector nodal_load(const model::Model& model, const model::Mesh& mesh,
                  const model::LoadCase& load_case) {
  Vector f = Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for (const model::Load& load : load_case.loads) {
    add_load(model, mesh, load, f);
  }
  const Vector T = element_temperature(model, mesh, load_case);
  if (T.size() > 0) {
    f += thermal_load(model, mesh, T);
  }
  return f;
}

Vector prescribed_displacement(const model::Model& /*model*/, const model::Mesh& mesh,
                               const model::LoadCase& load_case) {
  Vector u = Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::displacement) {
      continue;
    }
    const auto given =
        std::min(static_cast<Eigen::Index>(load.value.size()), static_cast<Eigen::Index>(mesh.dim));
    for (const base::NodeId n : mesh.set(load.nodes).nodes) {
      const Vec3 value = load_value(load, mesh.x[n.index()]);
      u.segment(mesh.dim * static_cast<Eigen::Index>(n.index()), given) = value.head(given);
    }
  }
  return u;
}

} // namespace spricka::fe
