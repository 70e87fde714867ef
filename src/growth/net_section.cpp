// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/net_section.hpp"

#include "fe/assemble.hpp"
#include "mesh/plane.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spricka::growth {

namespace {

/// The mesh need not have edges along the ligament: its cut goes from side to side of it, at the
/// end by this part of its length beyond.
constexpr double beyond = 0.03;
constexpr double on_line = 1e-7; // of the ligament

struct LigamentCut {
  std::vector<base::ElementId> elements; ///< on the right of it, with a node on it
  std::vector<bool> on;                  ///< [node]
};

// Elements are left or right of the ligament by their middle; nodes of both are the cut. Where all
// lie on one side (half a model) the nodes on the line are.
LigamentCut cut_along(const model::Mesh& mesh, const NetSectionLigament& ligament) {
  const base::Vec2 way = ligament.direction.head<2>();
  const auto across = [&](const base::Vec3& x) {
    return mesh::cross(way, (x - ligament.from).head<2>());
  };
  const auto along = [&](const base::Vec3& x) {
    return (x - ligament.from).dot(ligament.direction);
  };
  std::vector<char> side(mesh.node_count(), 0); // 1: left elements, 2: right ones
  std::vector<bool> right(mesh.element_count(), false);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    base::Vec3 middle = base::Vec3::Zero();
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    for (const base::NodeId n : nodes) {
      middle += mesh.x[n.index()] / static_cast<double>(nodes.size());
    }
    right[e] = across(middle) < 0.0;
    for (const base::NodeId n : nodes) {
      side[n.index()] = static_cast<char>(side[n.index()] | (right[e] ? 2 : 1));
    }
  }
  LigamentCut cut;
  cut.on.assign(mesh.node_count(), false);
  const auto mark = [&](bool half) {
    bool any = false;
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      const double s = along(mesh.x[n]);
      const bool within = s >= -on_line * ligament.length && s <= (1.0 + beyond) * ligament.length;
      const bool line = std::abs(across(mesh.x[n])) <= on_line * ligament.length;
      // Nodes of both sides are where the cut runs; a half model has none, and its line is the cut.
      cut.on[n] = within && side[n] != 0 && (half ? line : side[n] == 3);
      any = any || cut.on[n];
    }
    return any;
  };
  const bool half = !mark(false) && mark(true);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    if ((half || right[e]) &&
        std::ranges::any_of(nodes, [&](base::NodeId n) { return cut.on[n.index()]; })) {
      cut.elements.emplace_back(e);
    }
  }
  return cut;
}

} // namespace

double plastic_load_ratio(const model::Model& model, const model::Mesh& mesh,
                          const NetSectionLigament& ligament, const base::Vector& u,
                          double flow_stress) {
  const LigamentCut cut = cut_along(mesh, ligament);
  if (cut.elements.empty()) {
    return 0.0;
  }
  // At nodes of the cut the internal forces of one side do not sum to zero: they are what the other
  // side carries.
  base::Vector f = base::Vector::Zero(u.size());
  fe::add_internal_force(model, mesh, cut.elements, u, f);
  const base::Vec2 middle = (ligament.from + 0.5 * ligament.length * ligament.direction).head<2>();
  base::Vec2 force = base::Vec2::Zero();
  double moment = 0.0;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (cut.on[n]) {
      const base::Vec2 F = f.segment<2>(2 * static_cast<Eigen::Index>(n));
      force += F;
      moment += mesh::cross(mesh.x[n].head<2>() - middle, F);
    }
  }
  const double c = ligament.length;
  const double thickness = model.element_property(mesh, cut.elements.front()).thickness;
  const double across = mesh::cross(ligament.direction.head<2>(), force);
  const double normal = std::abs(across) / (flow_stress * thickness * c);
  const double bending = 4.0 * std::abs(moment) / (flow_stress * thickness * c * c);
  // The positive root of p^2 - m p - n^2 = 0 (growth.6).
  return 0.5 * (bending + std::sqrt(bending * bending + 4.0 * normal * normal));
}

} // namespace spricka::growth
