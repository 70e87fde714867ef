// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/crack_opening.hpp"

#include "report/drawing/picture_frame.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace spricka::report {
namespace {

/// Of the crack's size: what counts as one place, and as in the plane.
constexpr double one_place = 1e-7;
constexpr double in_plane = 1e-5;

using Key = std::array<long long, 3>;

/// Places of nodes as whole numbers, the same for nodes that lie on each other.
class CoincidenceGrid {
public:
  CoincidenceGrid(const base::Vec3& origin, double step) : origin_(origin), step_(step) {}
  [[nodiscard]] Key key(const base::Vec3& x) const {
    const base::Vec3 d = (x - origin_) / step_;
    return {std::llround(d[0]), std::llround(d[1]), std::llround(d[2])};
  }

private:
  base::Vec3 origin_;
  double step_;
};

bool lies_in(const FittedFrontPlane& frame, const model::Mesh& mesh,
             const std::vector<base::NodeId>& outline) {
  return std::ranges::all_of(outline, [&](base::NodeId n) {
    return std::abs(frame.normal.dot(mesh.x[n.index()] - frame.centre)) < in_plane * frame.size;
  });
}

base::Vec3 displacement(const results::LoadStepResult& step, base::NodeId n) {
  return step.u.segment<3>(static_cast<Eigen::Index>(3 * n.index()));
}

} // namespace

std::optional<FittedFrontPlane> fit_front_plane(const results::FrontResult& front) {
  const std::size_t n = front.points.size();
  if (n < 3) {
    return std::nullopt;
  }
  FittedFrontPlane frame;
  for (const results::FrontPointResult& p : front.points) {
    frame.centre += p.x / static_cast<double>(n);
    frame.growth += p.direction / static_cast<double>(n);
  }
  for (std::size_t i = 0; i + 1 < n; ++i) { // b = t x m
    const base::Vec3 t = front.points[i + 1].x - front.points[i].x;
    frame.normal += t.cross(front.points[i].direction + front.points[i + 1].direction);
  }
  if (frame.normal.norm() == 0.0) {
    return std::nullopt;
  }
  frame.normal.normalize();
  for (const results::FrontPointResult& p : front.points) {
    frame.size = std::max(frame.size, (p.x - frame.centre).norm());
  }
  const bool plane = std::ranges::all_of(front.points, [&](const results::FrontPointResult& p) {
    return std::abs(frame.normal.dot(p.x - frame.centre)) < in_plane * frame.size &&
           std::abs(frame.normal.dot(p.direction)) < 1e-3;
  });
  if (front.is_loop) {
    frame.growth.setZero();
  }
  return plane ? std::optional(frame) : std::nullopt;
}

std::vector<OpenedCrackFace> crack_face_openings(const results::CrackLengthResult& increment,
                                                 const results::LoadStepResult& step,
                                                 const FittedFrontPlane& frame) {
  const model::Mesh& mesh = increment.mesh;
  const CoincidenceGrid places(frame.centre, one_place * frame.size);
  // of the lower side, whose outer normal is the crack's: faces by the place of their middle
  std::map<Key, const std::vector<base::NodeId>*> lower;
  std::vector<const std::vector<base::NodeId>*> upper;
  const auto middle = [&](const std::vector<base::NodeId>& outline) {
    base::Vec3 x = base::Vec3::Zero();
    for (const base::NodeId n : outline) {
      x += mesh.x[n.index()] / static_cast<double>(outline.size());
    }
    return x;
  };
  for (const results::OuterSurfaceFace& face : increment.surface) {
    if (!lies_in(frame, mesh, face.outline)) {
      continue;
    }
    if (doubled_area_vector(mesh, face.outline).dot(frame.normal) > 0.0) {
      lower[places.key(middle(face.outline))] = &face.outline;
    } else {
      upper.push_back(&face.outline);
    }
  }
  std::vector<OpenedCrackFace> open;
  for (const std::vector<base::NodeId>* const outline : upper) {
    const auto twin = lower.find(places.key(middle(*outline)));
    if (twin == lower.end() || twin->second->size() != outline->size()) {
      continue;
    }
    base::Vec3 apart = base::Vec3::Zero();
    for (std::size_t i = 0; i < outline->size(); ++i) {
      apart += displacement(step, (*outline)[i]) - displacement(step, (*twin->second)[i]);
    }
    apart /= static_cast<double>(outline->size());
    const double opening = frame.normal.dot(apart);
    open.push_back({.outline = *outline,
                    .opening = opening,
                    .sliding = (apart - opening * frame.normal).norm()});
  }
  return open;
}

} // namespace spricka::report
