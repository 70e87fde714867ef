// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_geometry.hpp"

#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

/// The nearest place on faces that come one by one; ties go to the lower number.
class NearestFaceSearch {
public:
  NearestFaceSearch(const SurfaceGeometry& surface, const Vec3& x) : surface_(surface), x_(x) {}

  [[nodiscard]] double distance() const { return distance_; }
  void look_at(std::size_t face) {
    const geometry::ElementSide& f = surface_.face(face);
    const Vec2 r = f.nearest_point(x_, geometry::BorderFootPolicy::replaced);
    const double distance = (f.position(r) - x_).norm();
    const double same = 1e-12 * surface_.diagonal();
    if (distance < distance_ - same || (distance < distance_ + same && face < face_)) {
      distance_ = std::min(distance, distance_);
      face_ = face;
      r_ = r;
    }
  }
  [[nodiscard]] SurfacePlace place() const {
    return face_ == nowhere ? SurfacePlace{} : surface_.place_at_coordinates(face_, r_);
  }

private:
  const SurfaceGeometry& surface_;
  const Vec3& x_;
  double distance_ = std::numeric_limits<double>::max();
  std::size_t face_ = nowhere;
  Vec2 r_ = Vec2::Zero();
};

} // namespace

SurfaceGeometry::SurfaceGeometry(const model::Mesh& mesh, std::span<const base::FaceSetId> kept,
                                 bool borders, std::span<const base::NodeSetId> lines) {
  std::vector<geometry::Box<3>> boxes;
  geometry::Box<3> all;
  for (const model::Face& face : boundary_faces(mesh)) {
    if (base::element_info(mesh.type[face.element.index()]).dim != 3) {
      continue;
    }
    faces_.push_back(model::element_side(mesh, face));
  }
  std::ranges::sort(faces_, {}, model::face_of_side);
  for (const geometry::ElementSide& face : faces_) {
    boxes.push_back(face.bounding_box());
    all.extend(boxes.back());
  }
  extent_ = faces_.empty() ? 0.0 : all.diagonal();
  boxes_ = geometry::BoxTree<3>(boxes);
  find_edges();
  find_sets(mesh, kept);
  find_lines(mesh, lines);
  find_pieces(borders);
}

std::size_t SurfaceGeometry::face_index(const model::Face& face) const {
  const auto at = std::ranges::lower_bound(faces_, face, {}, model::face_of_side);
  return at != faces_.end() && model::face_of_side(*at) == face
             ? static_cast<std::size_t>(at - faces_.begin())
             : nowhere;
}

SurfacePlace SurfaceGeometry::place_at_coordinates(std::size_t face, const Vec2& r) const {
  const geometry::SidePoint point = faces_[face].point(r);
  return {face, r, point.x, point.normal()};
}

SurfacePlace SurfaceGeometry::nearest_place(const Vec3& x) const {
  NearestFaceSearch nearest(*this, x);
  boxes_.visit_nearest(x, [&](std::size_t face) {
    nearest.look_at(face);
    return nearest.distance() + 1e-12 * extent_;
  });
  return nearest.place();
}

SurfacePlace SurfaceGeometry::nearest_place(const Vec3& x,
                                            std::span<const std::size_t> among) const {
  NearestFaceSearch nearest(*this, x);
  for (const std::size_t face : among) {
    if (faces_[face].bounding_box().distance(x) <= nearest.distance() + 1e-12 * extent_) {
      nearest.look_at(face);
    }
  }
  return nearest.place();
}

} // namespace spricka::mesh
