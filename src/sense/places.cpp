// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/places.hpp"

#include "fe/face_point.hpp"
#include "mesh/boundary.hpp"

#include <utility>

namespace spricka::sense {

namespace {

constexpr double same_side = 3e-3;  // of a face's size
constexpr double same_point = 1e-6; // of the mesh's size
constexpr double bulge = 0.1;       // of a face's size, beyond the box of its nodes

contact::ContactBoundingBox box_of(const std::vector<base::Vec3>& points) {
  contact::ContactBoundingBox box{points.front(), points.front()};
  for (const base::Vec3& x : points) {
    box.low = box.low.cwiseMin(x);
    box.high = box.high.cwiseMax(x);
  }
  return box;
}

contact::ContactBoundingBox grown(const contact::ContactBoundingBox& box, double by) {
  return {box.low.array() - by, box.high.array() + by};
}

std::vector<base::Vec3> corners_of(const model::Mesh& mesh, const model::Face& face) {
  std::vector<base::Vec3> x;
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, {face})) {
    x.push_back(mesh.x[n.index()]);
  }
  return x;
}

} // namespace

BoundarySamples::BoundarySamples(const model::Mesh& mesh, std::vector<model::Face> faces,
                                 const std::vector<base::NodeId>& nodes)
    : mesh_(mesh), faces_(std::move(faces)) {
  const contact::ContactBoundingBox all =
      mesh.x.empty() ? contact::ContactBoundingBox{} : box_of(mesh.x);
  same_point_ = mesh.x.empty() ? 0.0 : same_point * (all.high - all.low).norm();
  std::vector<contact::ContactBoundingBox> boxes;
  for (const model::Face& face : faces_) {
    const std::vector<base::Vec3> x = corners_of(mesh, face);
    const contact::ContactBoundingBox box = box_of(x);
    size_.push_back((box.high - box.low).norm());
    boxes.push_back(grown(box, bulge * size_.back()));
    fe::with_any_side(mesh, face, [&](const auto& side, const auto& X) {
      samples_.push_back(X * side.N(side.centre()));
    });
  }
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, faces_)) {
    samples_.push_back(mesh.x[n.index()]);
  }
  for (const base::NodeId n : nodes) {
    points_.push_back(mesh.x[n.index()]);
    boxes.push_back(grown({points_.back(), points_.back()}, same_point_));
    samples_.push_back(points_.back());
  }
  if (!boxes.empty()) {
    tree_.emplace(boxes);
  }
}

bool BoundarySamples::contains_point(const base::Vec3& x) const {
  if (!tree_) {
    return false;
  }
  for (const std::size_t i : tree_->overlapping_boxes({x, x})) {
    double off = 0.0;
    double allowed = same_point_;
    if (i >= faces_.size()) {
      off = (x - points_[i - faces_.size()]).norm();
    } else {
      allowed = same_side * size_[i];
      fe::with_any_side(
          mesh_, faces_[i],
          [&]<int dim>(const fe::AnyElement<dim>& side, const fe::SpaceNodes<dim>& X) {
            off = (x - X * side.N(fe::nearest_on_side<dim>(side, X, x))).norm();
          });
    }
    if (off <= allowed) {
      return true;
    }
  }
  return false;
}

} // namespace spricka::sense
