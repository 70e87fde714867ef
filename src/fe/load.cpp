// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/bearing.hpp"
#include "fe/face.hpp"
#include "fe/thermal.hpp"

namespace spricka::fe {

namespace {

using base::Vec3;
using base::Vector;

// Components of a load at a point; missing ones are zero.
Vec3 value_at(const model::Load& load, const Vec3& x) {
  Vec3 value = Vec3::Zero();
  for (std::size_t c = 0; c < load.value.size(); ++c) {
    value[static_cast<Eigen::Index>(c)] = load.value[c](x);
  }
  return value;
}

void add_at_node(const model::Mesh& mesh, base::NodeId n, const Vec3& force, Vector& f) {
  f.segment(mesh.dim * static_cast<Eigen::Index>(n.index()), mesh.dim) += force.head(mesh.dim);
}

// Adds the integral of N density(x, a) over faces, where a is the area vector: a density of
// value(x) |a| is a traction, one of -p a a pressure.
template <class Density>
void add_face_load(const model::Model& model, const model::Mesh& mesh,
                   const std::vector<model::Face>& faces, Density&& density, Vector& f) {
  for_faces(mesh, faces, [&]<shape::Shape Side>(Side, const model::Face& face) {
    const SideNodes<Side> X = side_coordinates<Side>(mesh, face);
    const std::array<base::NodeId, Side::nodes> nodes = nodes_of_face<Side>(mesh, face);
    const Law law = law_of(model, mesh, face.element);
    for (const auto& point : shape::quadrature<Side>(load_degree)) {
      const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(point.r);
      const Vec3 x = X * N;
      const Vec3 force =
          point.weight * law.depth(x.x()) * density(x, area_vector<Side>(X, point.r));
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        add_at_node(mesh, nodes[i], N[static_cast<Eigen::Index>(i)] * force, f);
      }
    }
  });
}

// Adds the integral of N density(x) over the volume of elements.
template <class Density>
void add_body_load(const model::Model& model, const model::Mesh& mesh,
                   const std::vector<base::ElementId>& elements, Density&& density, Vector& f) {
  for_blocks(mesh, elements, [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
    for (const base::ElementId e : block) {
      const NodeVectors<S> X = coordinates<S>(mesh, e);
      const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
      const Law law = law_of(model, mesh, e);
      for (const auto& point : shape::quadrature<S>(load_degree)) {
        const Eigen::Matrix<double, S::nodes, 1> N = S::N(point.r);
        const Eigen::Matrix<double, S::dim, S::dim> J = X * S::dN(point.r);
        Vec3 x = Vec3::Zero();
        x.template head<S::dim>() = X * N;
        const Vec3 force = point.weight * J.determinant() * law.depth(x.x()) * density(x);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          add_at_node(mesh, nodes[i], N[static_cast<Eigen::Index>(i)] * force, f);
        }
      }
    }
  });
}

double total_of(const model::Mesh& mesh, const Vector& f) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < f.size(); i += mesh.dim) {
    sum += f[i];
  }
  return sum;
}

// Spreads a given total evenly over the area of faces or the volume of elements: the nodal vector
// of a unit density along x, divided by its own sum, gives each node its share.
void add_resultant(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                   Vector& f) {
  Vector share = Vector::Zero(f.size());
  if (load.faces.valid()) {
    add_face_load(
        model, mesh, mesh.set(load.faces).faces,
        [](const Vec3& /*x*/, const Vec3& a) { return Vec3(a.norm(), 0.0, 0.0); }, share);
  } else {
    add_body_load(
        model, mesh, mesh.set(load.elements).elements,
        [](const Vec3& /*x*/) { return Vec3(1.0, 0.0, 0.0); }, share);
  }
  const double total = total_of(mesh, share);
  if (!(total > 0.0)) {
    return;
  }
  const Vec3 F = value_at(load, Vec3::Zero());
  for (Eigen::Index i = 0; i < f.size(); i += mesh.dim) {
    f.segment(i, mesh.dim) += (share[i] / total) * F.head(mesh.dim);
  }
}

void add_nodal_forces(const model::Mesh& mesh, const model::Load& load, Vector& f) {
  for (const base::NodeId n : mesh.set(load.nodes).nodes) {
    add_at_node(mesh, n, value_at(load, mesh.x[n.index()]), f);
  }
}

void add_pressure(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                  Vector& f) {
  add_face_load(
      model, mesh, mesh.set(load.faces).faces,
      [&](const Vec3& x, const Vec3& a) { return Vec3(-value_at(load, x)[0] * a); }, f);
}

void add_load(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
              Vector& f) {
  switch (load.type) {
  case model::LoadType::force:
    add_nodal_forces(mesh, load, f);
    return;
  case model::LoadType::resultant:
    add_resultant(model, mesh, load, f);
    return;
  case model::LoadType::traction:
    add_face_load(
        model, mesh, mesh.set(load.faces).faces,
        [&](const Vec3& x, const Vec3& a) { return Vec3(a.norm() * value_at(load, x)); }, f);
    return;
  case model::LoadType::pressure:
    add_pressure(model, mesh, load, f);
    return;
  case model::LoadType::body:
    add_body_load(
        model, mesh, mesh.set(load.elements).elements,
        [&](const Vec3& x) { return value_at(load, x); }, f);
    return;
  case model::LoadType::bearing:
    if (mesh.dim == 3) {
      add_solid_bearing(mesh, load, f);
    } else {
      add_bearing(model, mesh, load, f);
    }
    return;
  case model::LoadType::displacement: // see prescribed_displacement
  case model::LoadType::temperature:  // all of a case together, see nodal_load
    return;
  }
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
      const Vec3 value = value_at(load, mesh.x[n.index()]);
      u.segment(mesh.dim * static_cast<Eigen::Index>(n.index()), given) = value.head(given);
    }
  }
  return u;
}

} // namespace spricka::fe
