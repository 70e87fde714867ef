// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/boundary_part.hpp"

#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>
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

// Whether a point lies on a face as far as its centre and nodes tell, or on the triangle of its
// corners, which is next to it: no foot of a perpendicular need be found then.
bool BoundaryPart::lies_plainly_on(std::size_t face, const base::Vec3& x, double allowed) const {
  const auto near = [&](const base::Vec3& sample) {
    return (x - sample).squaredNorm() <= allowed * allowed;
  };
  if (near(samples_[face])) {
    return true;
  }
  const model::Face& f = faces_[face];
  const base::ElementType type = mesh_.type[f.element.index()];
  const std::span<const base::NodeId> nodes = mesh_.element_nodes(f.element);
  const std::span<const int> local = shape::side_nodes(type, f.side);
  const auto node = [&](std::size_t i) -> const base::Vec3& {
    return mesh_.x[nodes[static_cast<std::size_t>(local[i])].index()];
  };
  for (std::size_t i = 0; i < local.size(); ++i) {
    if (near(node(i))) {
      return true;
    }
  }
  if (shape::side_corner_count(type, f.side) != 3) {
    return false;
  }
  const base::Vec3 first = node(1) - node(0);
  const base::Vec3 second = node(2) - node(0);
  const base::Vec3 from = x - node(0);
  const base::Vec3 normal = first.cross(second);
  const double square = normal.squaredNorm();
  const double along = from.cross(second).dot(normal);
  const double up = first.cross(from).dot(normal);
  if (along < 0.0 || up < 0.0 || along + up > square) {
    return false;
  }
  double curved = 0.0; // how far the nodes between the corners are off the edges
  for (std::size_t i = 3; i < local.size(); ++i) {
    curved = std::max(curved, (node(i) - 0.5 * (node(i - 3) + node((i - 2) % 3))).norm());
  }
  // Of their shape functions 4 a b the sum is 4/3 at most.
  return std::abs(from.dot(normal)) / std::sqrt(square) + 4.0 / 3.0 * curved <= allowed;
}

bool BoundaryPart::contains_point(const base::Vec3& x) const {
  const std::vector<std::size_t> close = tree_.boxes_containing(x);
  for (const std::size_t i : close) {
    if (i < faces_.size() ? lies_plainly_on(i, x, same_side * size_[i])
                          : (x - points_[i - faces_.size()]).norm() <= same_point_) {
      return true;
    }
  }
  return std::ranges::any_of(close, [&](std::size_t i) {
    if (i >= faces_.size()) {
      return false;
    }
    const geometry::ElementSide side = model::element_side(mesh_, faces_[i]);
    return (x - side.position(side.nearest_local_coordinates(x))).norm() <= same_side * size_[i];
  });
}

} // namespace spricka::sense
