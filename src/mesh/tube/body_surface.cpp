// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/body_surface.hpp"

namespace spricka::mesh {

using base::ElementId;

BodySurface::BodySurface(const model::Mesh& mesh, const std::vector<ElementId>& elements)
    : elements_(elements), number_(mesh.element_count(), -1) {
  model::Mesh body;
  body.dim = 3;
  body.x = mesh.x;
  body.node_label = mesh.node_label;
  body.node_net = mesh.node_net;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const ElementId e = elements_[i];
    number_[e.index()] = static_cast<std::int32_t>(i);
    model::add_element(body, mesh.type[e.index()], mesh.nodes_of(e), mesh.element_label[e.index()],
                       mesh.element_net[e.index()]);
  }
  std::vector<base::FaceSetId> kept;
  for (const model::FaceSet& set : mesh.face_sets) {
    model::FaceSet own{set.name, {}, set.span};
    for (const model::Face& face : set.faces) {
      if (number_[face.element.index()] >= 0) {
        own.faces.push_back(
            {ElementId(static_cast<std::size_t>(number_[face.element.index()])), face.side});
      }
    }
    kept.emplace_back(body.face_sets.size());
    body.face_sets.push_back(std::move(own));
  }
  geometry_.emplace(body, kept);
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
