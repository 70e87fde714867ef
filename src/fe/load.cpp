// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/load_points.hpp"
#include "fe/load_rule.hpp"
#include "fe/thermal.hpp"
#include "model/loads.hpp"

#include <cmath>
#include <set>

namespace spricka::fe {

namespace {

using base::Vec3;
using base::Vector;

void add_at_node(const model::Mesh& mesh, base::NodeId n, const Vec3& force, Vector& f) {
  f.segment(mesh.dim * static_cast<Eigen::Index>(n.index()), mesh.dim) += force.head(mesh.dim);
}

void add_nodal_forces(const model::Mesh& mesh, const model::Load& load, Vector& f) {
  for (const base::NodeId n : mesh.set_with_id(load.nodes).nodes) {
    add_at_node(mesh, n, load_value(load, mesh.x[n.index()]), f);
  }
}

// Whether two sets give a freedom the same displacement, not zero.
bool same_displacement(double a, double b) {
  constexpr double equal = 1e-9;
  return a != 0.0 && std::abs(a - b) <= equal * std::abs(a);
}

// What the lines for one set give together.
Vector displacement_of_set(const model::Mesh& mesh, const model::LoadCase& load_case,
                           const model::NodeSet& set) {
  Vector u = Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for (const model::Load& load : load_case.loads) {
    if (load.type == model::LoadType::displacement &&
        mesh.set_with_id(load.nodes).nodes == set.nodes) {
      // A node that the set names twice is displaced once.
      for (const base::NodeId n : std::set(set.nodes.begin(), set.nodes.end())) {
        add_at_node(mesh, n, load_value(load, mesh.x[n.index()]), u);
      }
    }
  }
  return u;
}

void add_load(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
              Vector& f) {
  if (load.type == model::LoadType::force) {
    add_nodal_forces(mesh, load, f);
    return;
  }
  const auto add = [&](std::span<const base::NodeId> nodes, const auto& N, const Vec3& force) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      add_at_node(mesh, nodes[i], N[static_cast<Eigen::Index>(i)] * force, f);
    }
  };
  LoadPointVisitor visit;
  // (fe.16); on bodies (fe.17).
  visit.on_face = [&](const model::Face& face, std::span<const LoadPoint> points) {
    const geometry::ElementSide side = model::element_side(mesh, face);
    for (const LoadPoint& p : points) {
      add(side.nodes, side.N(p.r.head<2>()), p.force);
    }
  };
  visit.on_body = [&](base::ElementId e, std::span<const LoadPoint> points) {
    with_any_element(mesh, e, [&]<int dim>(const AnyElement<dim>& element) {
      for (const LoadPoint& p : points) {
        add(mesh.element_nodes(e), element.N(p.r.template head<dim>()), p.force);
      }
    });
  };
  for_load_points(model, mesh, load, visit);
}

} // namespace

Vector consistent_load_vector(const model::Model& model, const model::Mesh& mesh,
                              const model::LoadCase& load_case) {
  Vector f = Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  for (const model::Load& load : load_case.loads) {
    add_load(model, mesh, load, f);
  }
  const Vector T = corner_temperatures_of_case(model, mesh, load_case);
  if (T.size() > 0) {
    f += thermal_load(model, mesh, T);
  }
  return f;
}

double unresolved_load_fraction(const model::Model& model, const model::Mesh& mesh,
                                const model::Load& load) {
  UnresolvedLoad missed;
  if (!is_constant(load)) {
    const auto nothing = [](const auto& /*where*/, std::span<const LoadPoint> /*points*/) {};
    for_load_points(model, mesh, load, {nothing, nothing}, &missed);
  }
  return missed.missed_fraction();
}

Vector prescribed_displacement_vector(const model::Model& /*model*/, const model::Mesh& mesh,
                                      const model::LoadCase& load_case) {
  Vector u = Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  std::vector<const model::NodeSet*> reported; // sets, each with all its lines
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::displacement ||
        std::ranges::any_of(reported, [&](const model::NodeSet* set) {
          return set->nodes == mesh.set_with_id(load.nodes).nodes;
        })) {
      continue;
    }
    reported.push_back(&mesh.set_with_id(load.nodes));
    const Vector own = displacement_of_set(mesh, load_case, *reported.back());
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      if (!same_displacement(u[i], own[i])) {
        u[i] += own[i];
      }
    }
  }
  return u;
}

} // namespace spricka::fe
