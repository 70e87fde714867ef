// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/tip_setting.hpp"

#include "crack/point_force.hpp"
#include "fe/corner_rule.hpp"
#include "model/model.hpp"

#include <algorithm>

namespace spricka::crack {

namespace {

TipFrame frame_of(const mesh::CrackFront& front) {
  TipFrame frame;
  frame.x = front.tip_point().x.head<2>();
  frame.e1 = front.tip_point().growth.head<2>();
  // To the left, so that theta is positive on the left face's side.
  frame.e2 = {-frame.e1.y(), frame.e1.x()};
  return frame;
}

} // namespace

TipSetting tip_setting(const model::Model& model, const mesh::CrackedMesh& cracked,
                       const mesh::CrackFront& front, const std::vector<ExtensionField>& fields,
                       const TipLoads& loads) {
  // Domains stay within the tip's property, but between two materials: any of their elements tells
  // it.
  const base::ElementId near = fields.front().elements.front();
  return {model,
          cracked.mesh,
          model.element_material(cracked.mesh, near),
          model.element_property(cracked.mesh, near),
          frame_of(front),
          front.tip_point().node,
          front.crack.index() < cracked.faces.size() ? &cracked.faces[front.crack.index()]
                                                     : nullptr,
          loads,
          std::nullopt};
}

fe::Elasticity<2> TipSetting::elasticity(base::ElementId e) const {
  const model::StressState own = model.element_property(mesh, e).state;
  // About an axis the section is strained round it as well: see SectionState.
  return fe::elasticity<2>(model.element_material(mesh, e), own == model::StressState::axisymmetric
                                                                ? model::StressState::plane_strain
                                                                : own);
}

bool between_materials(const TipSetting& set, const ExtensionField& field) {
  const auto differs = [&](base::ElementId e) {
    const model::ElasticMaterial& m = set.model.element_material(set.mesh, e);
    return m.E != set.material.E || m.nu != set.material.nu ||
           set.model.element_property(set.mesh, e).state != set.state();
  };
  return std::ranges::any_of(field.elements, differs) || std::ranges::any_of(field.inside, differs);
}

std::array<base::Vec3, auxiliary_field_count>& ConfigurationalForces::operator[](base::NodeId n) {
  const auto [place, fresh] = at.try_emplace(n);
  if (fresh) {
    place->second.fill(base::Vec3::Zero());
  }
  return place->second;
}

std::array<double, auxiliary_field_count>
ConfigurationalForces::released_energies(const ExtensionField& field) const {
  std::array<double, auxiliary_field_count> sum{};
  for (const NodeMotion& moved : field.motion) {
    const auto P = at.find(moved.node);
    // Nodes that no term has touched release nothing.
    if (P != at.end()) {
      for (std::size_t k = 0; k < auxiliary_field_count; ++k) {
        sum[k] += moved.q * moved.along.dot(P->second[k]);
      }
    }
  }
  return sum;
}

Eigen::Matrix2d auxiliary_field_gradient(const TipSetting& set, const Polar& at,
                                         std::size_t auxiliary) {
  return auxiliary == 3 ? point_force_gradient(set.tip, at, set.material, set.state())
                        : near_tip_gradient(set.tip, at, static_cast<int>(auxiliary), set.material,
                                            set.state());
}

base::Vec2 auxiliary_field_displacement(const TipSetting& set, const Polar& at,
                                        std::size_t auxiliary) {
  return auxiliary == 3
             ? point_force_displacement(set.tip, at, set.tip.x.x(), set.material, set.state())
             : near_tip_displacement(set.tip, at, static_cast<int>(auxiliary), set.material,
                                     set.state());
}

PlaneValues extension_at(const model::Mesh& mesh, base::ElementId e,
                         const std::map<base::NodeId, double>& q) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  PlaneValues moved = PlaneValues::Zero(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto at = q.find(nodes[n]);
    moved[static_cast<Eigen::Index>(n)] = at == q.end() ? 0.0 : at->second;
  }
  return moved;
}

void for_domain_points(const TipSetting& set, base::ElementId e,
                       const std::function<void(const shape::Point<2>& r, double weight)>& visit) {
  const PlaneElement& element = plane_element(set.mesh, e);
  const std::array<base::NodeId, 1> tips{set.tip_node};
  const int corner = set.is_axisymmetric() ? fe::find_tip_corner(set.mesh, e, tips) : -1;
  if (corner < 0) {
    for (const auto& point : shape::quadrature<2>(element.domain, domain_degree)) {
      visit(point.r, point.weight);
    }
    return;
  }
  for (const fe::ReferenceChart& chart : fe::charts(element, corner)) {
    fe::for_chart_points(chart, {0.0, 0.0, 1.0}, visit);
  }
}

} // namespace spricka::crack
