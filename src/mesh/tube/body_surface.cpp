// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/body_surface.hpp"

#include "mesh/boundary.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace spricka::mesh {

using base::ElementId;

BodySurface::BodySurface(const model::Mesh& mesh, const std::vector<ElementId>& elements,
                         const SetUsage& use)
    : elements_(elements), number_(mesh.element_count(), -1) {
  body_.dim = 3;
  body_.x = mesh.x;
  body_.node_label = mesh.node_label;
  body_.node_net = mesh.node_net;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const ElementId e = elements_[i];
    number_[e.index()] = static_cast<std::int32_t>(i);
    model::add_element(body_, mesh.type[e.index()], mesh.element_nodes(e),
                       mesh.element_label[e.index()], mesh.element_net[e.index()]);
  }
  add_face_sets(mesh, use);
  add_node_sets(mesh, use);
  for (std::size_t s = 0; s < body_.face_sets.size(); ++s) {
    kept_.emplace_back(s);
  }
  for (const base::NodeSetId set : use.held) {
    lines_.emplace_back(body_.node_sets.size());
    body_.node_sets.push_back(mesh.set_with_id(set));
  }
  static_cast<void>(geometry());
}

void BodySurface::add_face_sets(const model::Mesh& mesh, const SetUsage& use) {
  for (std::size_t s = 0; s < mesh.face_sets.size(); ++s) {
    const model::FaceSet& set = mesh.face_sets[s];
    model::FaceSet own{set.name, {}, set.span};
    for (const model::Face& face : set.faces) {
      if (number_[face.element.index()] >= 0) {
        own.faces.push_back(
            {ElementId(static_cast<std::size_t>(number_[face.element.index()])), face.side});
      }
    }
    std::ranges::sort(own.faces);
    body_.face_sets.push_back(std::move(own));
    used_.push_back(SetUsage::is_used(use.faces, s));
  }
}

/// A face set has a node set of the same faces: only what is new makes borders.
void BodySurface::add_node_sets(const model::Mesh& mesh, const SetUsage& use) {
  std::map<std::vector<model::Face>, std::size_t> known;
  for (std::size_t s = 0; s < body_.face_sets.size(); ++s) {
    const std::size_t first = known.try_emplace(body_.face_sets[s].faces, s).first->second;
    used_[first] = used_[first] || used_[s];
  }
  const std::vector<model::Face> boundary = boundary_faces(body_);
  for (std::size_t s = 0; s < mesh.node_sets.size(); ++s) {
    const model::NodeSet& set = mesh.node_sets[s];
    const std::vector<bool> member = model::mark_members(mesh.node_count(), set.nodes);
    model::FaceSet own{set.name, {}, set.span};
    std::ranges::copy_if(boundary, std::back_inserter(own.faces), [&](const model::Face& face) {
      return face_has_all_nodes_inside(body_, face, member);
    });
    std::ranges::sort(own.faces);
    const bool used = SetUsage::is_used(use.nodes, s);
    const auto [at, fresh] = known.try_emplace(own.faces, body_.face_sets.size());
    if (fresh) {
      body_.face_sets.push_back(std::move(own));
      used_.push_back(used);
    } else {
      used_[at->second] = used_[at->second] || used;
    }
  }
}

const SurfaceGeometry& BodySurface::geometry(KeptSetBorders borders) const {
  std::optional<SurfaceGeometry>& made = geometry_[static_cast<std::size_t>(borders)];
  if (!made) {
    std::vector<base::FaceSetId> kept = kept_;
    if (borders == KeptSetBorders::used) {
      std::erase_if(kept, [&](base::FaceSetId set) { return !used_[set.index()]; });
    }
    made.emplace(body_, kept, borders != KeptSetBorders::none, lines_);
  }
  return *made;
}

std::size_t BodySurface::face_index(const model::Face& face) const {
  const std::int32_t e = number_[face.element.index()];
  return e < 0 ? nowhere
               : geometry().face_index({ElementId(static_cast<std::size_t>(e)), face.side});
}

model::Face BodySurface::face(std::size_t index) const {
  const geometry::ElementSide& own = geometry().face(index);
  return {elements_[own.element.index()], own.side};
}

} // namespace spricka::mesh
