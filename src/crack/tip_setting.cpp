// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/tip_setting.hpp"

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

TipContext make_tip_context(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front,
                            const std::vector<VirtualExtensionField>& fields,
                            const FrontLoads& loads) {
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
          std::nullopt,
          front.symmetric_half ? 2.0 : 1.0};
}

fe::Elasticity<2> TipContext::elasticity(base::ElementId e) const {
  const model::StressState own = model.element_property(mesh, e).state;
  // About an axis the section is strained round it as well: see SectionState.
  return fe::elasticity<2>(model.element_material(mesh, e), own == model::StressState::axisymmetric
                                                                ? model::StressState::plane_strain
                                                                : own);
}

bool is_between_materials(const TipContext& set, const VirtualExtensionField& field) {
  const auto differs = [&](base::ElementId e) {
    const model::ElasticMaterial& m = set.model.element_material(set.mesh, e);
    return m.E != set.material.E || m.nu != set.material.nu ||
           set.model.element_property(set.mesh, e).state != set.state();
  };
  return std::ranges::any_of(field.elements, differs) || std::ranges::any_of(field.inside, differs);
}

Eigen::Matrix2d auxiliary_field_gradient(const TipContext& set, const PolarCoordinates& at,
                                         std::size_t auxiliary) {
  return near_tip_gradient(set.tip, at, section_field_number<2>(auxiliary),
                           make_section_body(set.material, set.state()));
}

base::Vec2 auxiliary_field_displacement(const TipContext& set, const PolarCoordinates& at,
                                        std::size_t auxiliary) {
  return near_tip_displacement(set.tip, at, section_field_number<2>(auxiliary),
                               make_section_body(set.material, set.state(), set.tip.x.x()));
}

double extension_of_node(const std::map<base::NodeId, double>& q, base::NodeId n) {
  const auto at = q.find(n);
  return at == q.end() ? 0.0 : at->second;
}

PlaneValues extension_at_element_nodes(const model::Mesh& mesh, base::ElementId e,
                                       const std::map<base::NodeId, double>& q) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  PlaneValues moved = PlaneValues::Zero(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    moved[static_cast<Eigen::Index>(n)] = extension_of_node(q, nodes[n]);
  }
  return moved;
}

} // namespace spricka::crack
