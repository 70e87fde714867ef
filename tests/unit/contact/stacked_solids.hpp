// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <cmath>
#include <string>

namespace spricka::test {

/// What the two blocks of stacked_solids() are made of.
struct StackSpec {
  base::ElementType upper_type = base::ElementType::hexec20;
  base::ElementType lower_type = base::ElementType::hexec20;
  int upper_cells = 4, lower_cells = 6;
  double upper_size = 6.0, lower_size = 10.0; ///< along x and y; both are 2 high
  double turn = 0.35;                         ///< of the upper block about z [rad]
  base::Vec2 shift = base::Vec2::Zero();      ///< of the upper block
  bool upper_is_slave = true;
  bool more_on_upper =
      true; ///< the upper one is the softer: with sizes alike it has the multipliers
};

/// A block that stands on a larger one at z = 0, turned about z, so that no nodes match; one
/// contact between them with gap 0.
inline model::Model stacked_solids(const StackSpec& spec) {
  model::Model model;
  model.mesh.dim = 3;
  model.nets = {{"UP", {}}, {"LOW", {}}};
  const auto block = [&](std::size_t net, base::ElementType type, int cells, double size,
                         double bottom) {
    mesh::BlockSpec b;
    b.type = type;
    b.origin = {-0.5 * size, -0.5 * size, bottom};
    b.size = {size, size, 2.0};
    b.nx = cells;
    b.ny = cells;
    b.nz = 2;
    mesh::generate_solid_block(model.mesh, base::NetId(net), net == 0 ? "UP." : "LOW.", b);
  };
  block(0, spec.upper_type, spec.upper_cells, spec.upper_size, 0.0);
  const std::size_t upper_nodes = model.mesh.node_count();
  for (std::size_t n = 0; n < upper_nodes; ++n) {
    base::Vec3& x = model.mesh.x[n];
    const double c = std::cos(spec.turn);
    const double s = std::sin(spec.turn);
    x = {c * x.x() - s * x.y() + spec.shift.x(), s * x.x() + c * x.y() + spec.shift.y(), x.z()};
  }
  block(1, spec.lower_type, spec.lower_cells, spec.lower_size, -2.0);
  model.materials = {{"A", spec.more_on_upper ? 1.0 : 2.0, 0.3, 0.0, 0.0, {}},
                     {"B", spec.more_on_upper ? 2.0 : 1.0, 0.3, 0.0, 0.0, {}}};
  for (std::size_t i = 0; i < 2; ++i) {
    model::ElementProperty property;
    property.material = base::MaterialId(i);
    property.state = model::StressState::solid;
    for (std::size_t s = 0; s < model.mesh.element_sets.size(); ++s) {
      if (model.mesh.element_sets[s].name == (i == 0 ? "UP.BODY" : "LOW.BODY")) {
        property.elements = base::ElementSetId(s);
      }
    }
    model.properties.push_back(property);
    for (const base::ElementId e : model.mesh.set_with_id(property.elements).elements) {
      model.mesh.property[e.index()] = base::PropertyId(i);
    }
  }
  const auto set = [&](const std::string& name) {
    for (std::size_t i = 0; i < model.mesh.face_sets.size(); ++i) {
      if (model.mesh.face_sets[i].name == name) {
        return base::FaceSetId(i);
      }
    }
    return base::FaceSetId();
  };
  model::Contact contact;
  contact.name = "STAND";
  contact.slave = set(spec.upper_is_slave ? "UP.ZMIN" : "LOW.ZMAX");
  contact.master = set(spec.upper_is_slave ? "LOW.ZMAX" : "UP.ZMIN");
  contact.gap = 0.0;
  model.contacts = {contact};
  return model;
}

} // namespace spricka::test
