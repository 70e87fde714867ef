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

// A total spreads evenly over the volume: weight and volume by one rule, which is exact for them in
// the plane (shape function, Jacobian and radius of quadratic elements).
void add_body_total(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                    Vector& f) {
  const int degree = mesh.dim == 2 ? 7 : load_degree;
  Vector weight = Vector::Zero(static_cast<Eigen::Index>(mesh.node_count()));
  double total = 0.0;
  for_blocks(mesh, mesh.set(load.elements).elements,
             [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
               for (const base::ElementId e : block) {
                 const NodeVectors<S> X = coordinates<S>(mesh, e);
                 const Law law = law_of(model, mesh, e);
                 Eigen::Matrix<double, S::nodes, 1> own =
                     Eigen::Matrix<double, S::nodes, 1>::Zero();
                 for (const auto& point : shape::quadrature<S>(degree)) {
                   const Eigen::Matrix<double, S::dim, S::dim> J = X * S::dN(point.r);
                   const Eigen::Matrix<double, S::nodes, 1> N = S::N(point.r);
                   const double dV = point.weight * J.determinant() * law.depth(X.row(0) * N);
                   own += dV * N;
                   total += dV;
                 }
                 const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
                 for (std::size_t i = 0; i < nodes.size(); ++i) {
                   weight[static_cast<Eigen::Index>(nodes[i].index())] +=
                       own[static_cast<Eigen::Index>(i)];
                 }
               }
             });
  if (!(total > 0.0)) {
    return;
  }
  const Vec3 F = load_value(load, Vec3::Zero());
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    add_at_node(mesh, base::NodeId(n), (weight[static_cast<Eigen::Index>(n)] / total) * F, f);
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
  if (load.type == model::LoadType::resultant && load.elements.valid()) {
    add_body_total(model, mesh, load, f);
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
