// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/boundary_part.hpp"

#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"

#include <utility>

namespace spricka::sense {

namespace {

constexpr double same_side = 3e-3;  // of a face's size
constexpr double same_point = 1e-6; // of the mesh's size
constexpr double bulge = 0.1;       // of a face's size, beyond the box of its nodes

std::vector<base::Vec3> corners_of(const model::Mesh& mesh, const model::Face& face) {
  std::vector<base::Vec3> x;
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, {face})) {
    x.push_back(mesh.x[n.index()]);
  }
  return x;
}

} // namespace

BoundaryPart::BoundaryPart(const model::Mesh& mesh, std::vector<model::Face> faces,
                           const std::vector<base::NodeId>& nodes)
    : mesh_(mesh), faces_(std::move(faces)) {
  same_point_ = mesh.x.empty() ? 0.0 : same_point * geometry::Box<3>::around(mesh.x).diagonal();
  std::vector<geometry::Box<3>> boxes;
  for (const model::Face& face : faces_) {
    const auto box = geometry::Box<3>::around(corners_of(mesh, face));
    size_.push_back(box.diagonal());
    boxes.push_back(box.grown(bulge * size_.back()));
    const geometry::ElementSide side = model::element_side(mesh, face);
    samples_.push_back(side.position(side.domain_centre()));
  }
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, faces_)) {
    samples_.push_back(mesh.x[n.index()]);
  }
  for (const base::NodeId n : nodes) {
    points_.push_back(mesh.x[n.index()]);
    boxes.push_back(geometry::Box<3>{points_.back(), points_.back()}.grown(same_point_));
    samples_.push_back(points_.back());
  }
  tree_ = geometry::BoxTree<3>(boxes);
}

bool BoundaryPart::contains_point(const base::Vec3& x) const {
  for (const std::size_t i : tree_.boxes_containing(x)) {
    double off = 0.0;
    double allowed = same_point_;
    if (i >= faces_.size()) {
      off = (x - points_[i - faces_.size()]).norm();
    } else {
      allowed = same_side * size_[i];
      const geometry::ElementSide side = model::element_side(mesh_, faces_[i]);
      off = (x - side.position(side.nearest_local_coordinates(x))).norm();
    }
    if (off <= allowed) {
      return true;
    }
  }
  return false;
}

} // namespace spricka::sense
