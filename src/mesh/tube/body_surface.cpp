// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/body_surface.hpp"

#include "mesh/boundary.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace spricka::mesh {

using base::ElementId;

BodySurface::BodySurface(const model::Mesh& mesh, const std::vector<ElementId>& elements)
    : elements_(elements), number_(mesh.element_count(), -1) {
  body_.dim = 3;
  body_.x = mesh.x;
  body_.node_label = mesh.node_label;
  body_.node_net = mesh.node_net;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const ElementId e = elements_[i];
    number_[e.index()] = static_cast<std::int32_t>(i);
    model::add_element(body_, mesh.type[e.index()], mesh.nodes_of(e), mesh.element_label[e.index()],
                       mesh.element_net[e.index()]);
  }
  add_face_sets(mesh);
  add_node_sets(mesh);
  for (std::size_t s = 0; s < body_.face_sets.size(); ++s) {
    kept_.emplace_back(s);
  }
  geometry_.emplace(body_, kept_);
}

void BodySurface::add_face_sets(const model::Mesh& mesh) {
  for (const model::FaceSet& set : mesh.face_sets) {
    model::FaceSet own{set.name, {}, set.span};
    for (const model::Face& face : set.faces) {
      if (number_[face.element.index()] >= 0) {
        own.faces.push_back(
            {ElementId(static_cast<std::size_t>(number_[face.element.index()])), face.side});
      }
    }
    std::ranges::sort(own.faces);
    body_.face_sets.push_back(std::move(own));
  }
}

/// A face set has a node set of the same faces: only what is new makes borders.
void BodySurface::add_node_sets(const model::Mesh& mesh) {
  std::set<std::vector<model::Face>> known;
  for (const model::FaceSet& set : body_.face_sets) {
    known.insert(set.faces);
  }
  const std::vector<model::Face> boundary = boundary_faces(body_);
  for (const model::NodeSet& set : mesh.node_sets) {
    std::vector<bool> member(mesh.node_count(), false);
    for (const base::NodeId n : set.nodes) {
      member[n.index()] = true;
    }
    model::FaceSet own{set.name, {}, set.span};
    std::ranges::copy_if(boundary, std::back_inserter(own.faces),
                         [&](const model::Face& face) { return lies_within(body_, face, member); });
    std::ranges::sort(own.faces);
    if (known.insert(own.faces).second) {
      body_.face_sets.push_back(std::move(own));
    }
  }
}

const SurfaceGeometry& BodySurface::without_borders() const {
  if (!without_borders_) {
    without_borders_.emplace(body_, kept_, false);
  }
  return *without_borders_;
}

std::size_t BodySurface::index(const model::Face& face) const {
  const std::int32_t e = number_[face.element.index()];
  return e < 0 ? nowhere : geometry_->index({ElementId(static_cast<std::size_t>(e)), face.side});
}

model::Face BodySurface::face(std::size_t index) const {
  const model::Face& own = geometry_->face(index).face;
  return {elements_[own.element.index()], own.side};
}

} // namespace spricka::mesh
