// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_geometry.hpp"

#include "mesh/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeEntry = std::pair<TreeBox, std::size_t>;

TreePoint tree_point(const Vec3& x) {
  return {x.x(), x.y(), x.z()};
}

double distance_to_box(const std::array<Vec3, 2>& box, const Vec3& x) {
  return (box[0] - x).cwiseMax(x - box[1]).cwiseMax(0.0).norm();
}

/// The nearest place on faces that come one by one; ties go to the lower number.
class NearestFaceSearch {
public:
  NearestFaceSearch(const SurfaceGeometry& surface, const Vec3& x) : surface_(surface), x_(x) {}

  [[nodiscard]] double distance() const { return distance_; }
  void look_at(std::size_t face) {
    const CurvedFace& f = surface_.face(face);
    const Vec2 r = nearest_on(f, x_);
    const double distance = (point_on(f, r).x - x_).norm();
    const double same = 1e-12 * surface_.diagonal();
    if (distance < distance_ - same || (distance < distance_ + same && face < face_)) {
      distance_ = std::min(distance, distance_);
      face_ = face;
      r_ = r;
    }
  }
  [[nodiscard]] SurfacePlace place() const {
    return face_ == nowhere ? SurfacePlace{} : surface_.place_on_face(face_, r_);
  }

private:
  const SurfaceGeometry& surface_;
  const Vec3& x_;
  double distance_ = std::numeric_limits<double>::max();
  std::size_t face_ = nowhere;
  Vec2 r_ = Vec2::Zero();
};

} // namespace

struct SurfaceGeometry::FaceTree {
  bg::index::rtree<TreeEntry, bg::index::rstar<16>> boxes;
};

SurfaceGeometry::SurfaceGeometry(const model::Mesh& mesh, std::span<const base::FaceSetId> kept,
                                 bool borders, std::span<const base::NodeSetId> lines) {
  std::vector<TreeEntry> entries;
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  for (const model::Face& face : boundary_faces(mesh)) {
    if (base::element_info(mesh.type[face.element.index()]).dim != 3) {
      continue;
    }
    faces_.push_back(make_surface_face(mesh, face));
  }
  std::ranges::sort(faces_, {}, &CurvedFace::face);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto [least, most] = bounding_box(faces_[f]);
    entries.emplace_back(TreeBox(tree_point(least), tree_point(most)), f);
    low = f == 0 ? least : Vec3(low.cwiseMin(least));
    high = f == 0 ? most : Vec3(high.cwiseMax(most));
  }
  extent_ = (high - low).norm();
  tree_ = std::make_unique<FaceTree>(
      FaceTree{bg::index::rtree<TreeEntry, bg::index::rstar<16>>(entries)});
  find_edges();
  find_sets(mesh, kept);
  find_lines(mesh, lines);
  find_pieces(borders);
}

SurfaceGeometry::~SurfaceGeometry() = default;
SurfaceGeometry::SurfaceGeometry(SurfaceGeometry&&) noexcept = default;
SurfaceGeometry& SurfaceGeometry::operator=(SurfaceGeometry&&) noexcept = default;

std::size_t SurfaceGeometry::face_index(const model::Face& face) const {
  const auto at = std::ranges::lower_bound(faces_, face, {}, &CurvedFace::face);
  return at != faces_.end() && at->face == face ? static_cast<std::size_t>(at - faces_.begin())
                                                : nowhere;
}

SurfacePlace SurfaceGeometry::place_on_face(std::size_t face, const Vec2& r) const {
  const CurvedFacePoint point = point_on(faces_[face], r);
  return {face, r, point.x, point.normal()};
}

SurfacePlace SurfaceGeometry::nearest_place(const Vec3& x) const {
  NearestFaceSearch nearest(*this, x);
  // The tree hands boxes out by their distance, the nearest first.
  const double same = 1e-12 * extent_;
  for (auto it = tree_->boxes.qbegin(
           bg::index::nearest(tree_point(x), static_cast<unsigned>(faces_.size())));
       it != tree_->boxes.qend(); ++it) {
    if (bg::distance(it->first, tree_point(x)) > nearest.distance() + same) {
      break;
    }
    nearest.look_at(it->second);
  }
  return nearest.place();
}

SurfacePlace SurfaceGeometry::nearest_place(const Vec3& x,
                                            std::span<const std::size_t> among) const {
  NearestFaceSearch nearest(*this, x);
  for (const std::size_t face : among) {
    if (distance_to_box(bounding_box(faces_[face]), x) <= nearest.distance() + 1e-12 * extent_) {
      nearest.look_at(face);
    }
  }
  return nearest.place();
}

std::vector<std::size_t> SurfaceGeometry::faces_in_box(const Vec3& low, const Vec3& high) const {
  std::vector<std::size_t> found;
  const TreeBox box(tree_point(low), tree_point(high));
  for (auto it = tree_->boxes.qbegin(bg::index::intersects(box)); it != tree_->boxes.qend(); ++it) {
    found.push_back(it->second);
  }
  std::ranges::sort(found);
  return found;
}

} // namespace spricka::mesh
