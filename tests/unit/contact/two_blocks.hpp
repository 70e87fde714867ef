// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <numbers>
#include <string>

namespace spricka::test {

struct TwoBlocks {
  base::ElementType type = base::ElementType::quamc8;
  model::StressState state = model::StressState::axisymmetric;
  int lower = 5, upper = 5;    ///< elements along x
  double from = 0.0, to = 2.0; ///< of the upper block along x; the lower one is 0 to 2
};

inline base::FaceSetId face_set(const model::Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.mesh.face_sets.size(); ++i) {
    if (model.mesh.face_sets[i].name == name) {
      return base::FaceSetId(i);
    }
  }
  return {};
}

/// A block on a block of height 1 each, interface y = 1, one contact whose slave is the upper
/// block's lower side. Thickness 5 in the plane.
inline model::Model two_blocks(const TwoBlocks& spec) {
  model::Model model;
  model.nets = {{"LO", {}}, {"UP", {}}};
  mesh::BlockSpec block;
  block.type = spec.type;
  block.size = {2.0, 1.0, 0.0};
  block.nx = spec.lower;
  mesh::generate_block(model.mesh, base::NetId(std::size_t{0}), "LO.", block);
  block.origin = {spec.from, 1.0, 0.0};
  block.size = {spec.to - spec.from, 1.0, 0.0};
  block.nx = spec.upper;
  mesh::generate_block(model.mesh, base::NetId(std::size_t{1}), "UP.", block);
  model.materials = {{"A", 1.0, 0.3, 0.0, 0.0, {}}};
  model::ElementProperty property;
  property.material = base::MaterialId(std::size_t{0});
  property.state = spec.state;
  property.thickness = 5.0;
  model.properties = {property};
  for (base::PropertyId& p : model.mesh.property) {
    p = base::PropertyId(std::size_t{0});
  }
  model::Contact contact;
  contact.name = "FACE";
  contact.slave = face_set(model, "UP.YMIN");
  contact.master = face_set(model, "LO.YMAX");
  model.contacts = {contact};
  return model;
}

/// The same, the upper block against a rigid target instead of the lower one.
inline model::Model block_on(const TwoBlocks& spec, const model::RigidTarget& rigid) {
  model::Model model = two_blocks(spec);
  model.rigids = {rigid};
  model.contacts[0].master = {};
  model.contacts[0].rigid = base::RigidId(std::size_t{0});
  return model;
}

inline model::RigidTarget line(double x0, double y0, double x1, double y1) {
  model::RigidTarget rigid;
  rigid.first = {x0, y0, 0.0};
  rigid.second = {x1, y1, 0.0};
  return rigid;
}

inline model::RigidTarget arc(double x, double y, double radius) {
  model::RigidTarget rigid;
  rigid.shape = model::RigidTargetShape::arc;
  rigid.first = {x, y, 0.0};
  rigid.radius = radius;
  return rigid;
}

} // namespace spricka::test
