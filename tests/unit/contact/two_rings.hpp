// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <string>

namespace spricka::test {

/// An inner ring 1..2 with `inner` elements round and an outer ring 2..3 with `outer`, one contact
/// between them: slave the inner ring's outside. Thickness 5.
inline model::Model two_rings(int inner, int outer, base::ElementType type, double E_outer = 1.0) {
  model::Model model;
  model.nets = {{"IN", {}}, {"OUT", {}}};
  mesh::RingSpec spec;
  spec.type = type;
  spec.nr = 2;
  spec.ri = 1.0;
  spec.ro = 2.0;
  spec.nt = inner;
  mesh::generate_ring(model.mesh, base::NetId(std::size_t{0}), "IN.", spec);
  spec.ri = 2.0;
  spec.ro = 3.0;
  spec.nt = outer;
  spec.t0 = 0.3; // turned, so that no nodes match
  spec.t1 = 0.3 + 2.0 * std::numbers::pi;
  mesh::generate_ring(model.mesh, base::NetId(std::size_t{1}), "OUT.", spec);
  model.materials = {{"A", 1.0, 0.3, 0.0, 0.0, {}}, {"B", E_outer, 0.3, 0.0, 0.0, {}}};
  const auto set = [&](const std::string& name) {
    for (std::size_t i = 0; i < model.mesh.element_sets.size(); ++i) {
      if (model.mesh.element_sets[i].name == name) {
        return base::ElementSetId(i);
      }
    }
    return base::ElementSetId();
  };
  for (std::size_t i = 0; i < 2; ++i) {
    model::ElementProperty property;
    property.elements = set(i == 0 ? "IN.BODY" : "OUT.BODY");
    property.material = base::MaterialId(i);
    property.thickness = 5.0;
    model.properties.push_back(property);
    for (const base::ElementId e : model.mesh.set_with_id(property.elements).elements) {
      model.mesh.property[e.index()] = base::PropertyId(i);
    }
  }
  model::Contact contact;
  contact.name = "FIT";
  for (std::size_t i = 0; i < model.mesh.face_sets.size(); ++i) {
    if (model.mesh.face_sets[i].name == "IN.OUTER") {
      contact.slave = base::FaceSetId(i);
    }
    if (model.mesh.face_sets[i].name == "OUT.INNER") {
      contact.master = base::FaceSetId(i);
    }
  }
  contact.gap = 0.0;
  model.contacts = {contact};
  return model;
}

} // namespace spricka::test
